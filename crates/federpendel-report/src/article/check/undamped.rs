//! Section 1: no friction, both routes to the solution.

use std::f64::consts::PI;

use federpendel::Result;
use federpendel::article::{Complex, ComplexForm, Formula, Reading, eq_16, eq_20, eq_36};

use super::Check;
use crate::article::measure::{
    formula_deviation, largest, largest_of, position, radian, turning_points,
};
use crate::article::{Case, Laboratory};

/// Step of a numeric second derivative over five points, in radians: it is off by STEP⁴/90, 1e-10, and rounding is far
/// below that.
const STEP: f64 = 1e-2;

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.undamped;
    let solution = eq_20(case.oscillator(), case.release())?;
    let form = ComplexForm::new(case.oscillator(), case.release())?;
    Ok(vec![
        harmonic(case),
        angular_frequency(case),
        constants(case, &solution)?,
        general_solution(case, &solution)?,
        imaginary_roots(case)?,
        both_routes(case, &form, &solution),
        chain(case, &form)?,
        lost_factor(case, &form),
    ])
}

/// Cosine, sine and their sum put into (3), with a numeric second derivative.
fn harmonic(case: &Case) -> Check {
    let omega0 = eq_16(case.oscillator());
    let h = STEP * radian(case);
    let residual = |curve: &dyn Fn(f64) -> f64| {
        let pair = |t: f64, h: f64| curve(t + h) + curve(t - h);
        let second =
            |t: f64| (16.0 * pair(t, h) - pair(t, 2.0 * h) - 30.0 * curve(t)) / (12.0 * h * h);
        let at = |i: u32| f64::from(i) * 0.1 * radian(case);
        let ratio = case.oscillator().stiffness() / case.oscillator().mass();
        largest_of((0..63).map(|i| (second(at(i)) + ratio * curve(at(i))) / ratio))
    };
    let (cosine, sine) = (|t: f64| (omega0 * t).cos(), |t: f64| (omega0 * t).sin());
    let amplitude = case.motion.amplitude();
    let [c1, c2] =
        [case.release().position, case.release().velocity / omega0].map(|c| c / amplitude);
    Check::new("harmonic", "3–15")
        .computed("cos: max|x″ + (C/m) x|/ω₀²", residual(&cosine), "1")
        .computed("sin: max|…|", residual(&sine), "1")
        .computed("C₁ cos + C₂ sin: max|…|", residual(&|t| c1 * cosine(t) + c2 * sine(t)), "1")
        .expected("0", 0.0, "1")
        .equal(1.0)
}

fn angular_frequency(case: &Case) -> Check {
    let check = Check::new("angular-frequency", "8, 16");
    let Some(points) = turning_points(&case.motion, 3) else { return check };
    let measured = 2.0 * PI / (points[2].time - points[0].time);
    check
        .computed("√(C/m)", eq_16(case.oscillator()), "1/s")
        .expected("2π/T", measured, "1/s")
        .equal(measured)
}

fn constants(case: &Case, solution: &Formula) -> Result<Check> {
    let start = solution.at(0.0)?;
    let amplitude = case.motion.amplitude();
    Ok(Check::new("constants", "17–19")
        .computed("x(0)", start.position, "m")
        .computed("ẋ(0)", start.velocity, "m/s")
        .expected("x₀", case.release().position, "m")
        .expected("v₀", case.release().velocity, "m/s")
        .within(amplitude * case.oscillator().angular_frequency())
        .equal(amplitude))
}

fn general_solution(case: &Case, solution: &Formula) -> Result<Check> {
    Ok(Check::new("general-solution", "20")
        .computed("max|Δx|", formula_deviation(&case.motion, case.duration, solution)?, "m")
        .expected("0", 0.0, "m")
        .equal(case.motion.amplitude()))
}

fn imaginary_roots(case: &Case) -> Result<Check> {
    let oscillator = case.oscillator();
    let omega0 = eq_16(oscillator);
    let square = -oscillator.stiffness() / oscillator.mass();
    let [first, second] = eq_36(oscillator)?;
    let squared = |root: Complex| (root * root).re;
    Ok(Check::new("imaginary-roots", "21–24")
        .computed("λ₁²", squared(first), "1/s²")
        .computed("λ₂²", squared(second), "1/s²")
        .computed("Im λ₁", first.im, "1/s")
        .expected("−C/m", square, "1/s²")
        .expected("−C/m", square, "1/s²")
        .expected("ω₀", omega0, "1/s")
        .within(omega0)
        .equal(square))
}

fn both_routes(case: &Case, form: &ComplexForm, solution: &Formula) -> Check {
    let difference = |t: f64| form.eq_25(t).re - position(solution, t);
    Check::new("both-routes", "20, 25")
        .computed("max|(25) − (20)|", largest(case.duration, difference), "m")
        .computed("max|Im (25)|", largest(case.duration, |t| form.eq_25(t).im), "m")
        .expected("0", 0.0, "m")
        .equal(case.motion.amplitude())
}

/// Every line of (25) to (27), at a time at which neither sine nor cosine is near zero.
fn chain(case: &Case, form: &ComplexForm) -> Result<Check> {
    let time = radian(case);
    Ok(Check::new("chain-25-27", "25–27")
        .computed("(25)", form.eq_25(time).re, "m")
        .computed("(26)", form.eq_26(time).re, "m")
        .computed("(27)", form.eq_27(time).re, "m")
        .expected("x(1/ω₀)", case.motion.at(time)?.position, "m")
        .equal(case.motion.amplitude()))
}

/// The constant under the brace of (27), against what the release demands.
fn lost_factor(case: &Case, form: &ComplexForm) -> Check {
    let [_, printed] = form.eq_28_constants(Reading::Printed);
    Check::new("lost-factor", "27–28")
        .computed("Re C₂", printed.re, "m")
        .computed("Im C₂", printed.im, "m")
        .expected("v₀/ω₀", case.release().velocity / eq_16(case.oscillator()), "m")
        .expected("0", 0.0, "m")
        .equal_by_chance(case.motion.amplitude())
}
