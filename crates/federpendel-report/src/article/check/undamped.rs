//! Section 1: no friction, both routes to the solution.

use federpendel::Result;
use federpendel::article::{Complex, ComplexForm, Reading, eq_16, eq_20, eq_36};

use super::Check;
use super::measure::{formula_deviation, largest, largest_of, position, radian, turning_points};
use crate::article::Laboratory;

/// Step of a numeric second derivative over five points, in radians: it is off by STEP⁴/90, 1e-10, and rounding is far
/// below that.
const STEP: f64 = 1e-2;

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.undamped;
    let (oscillator, release, motion) = (*case.oscillator(), case.release(), &case.motion);
    let omega0 = eq_16(&oscillator);
    let solution = eq_20(&oscillator, release)?;
    let form = ComplexForm::new(&oscillator, release)?;
    let amplitude = motion.amplitude();
    let mut checks = Vec::new();

    let residual = |curve: &dyn Fn(f64) -> f64| {
        let h = STEP * radian(case);
        let pair = |t: f64, h: f64| curve(t + h) + curve(t - h);
        let second =
            |t: f64| (16.0 * pair(t, h) - pair(t, 2.0 * h) - 30.0 * curve(t)) / (12.0 * h * h);
        let at = |i: u32| f64::from(i) * 0.1 * radian(case);
        let ratio = oscillator.stiffness() / oscillator.mass();
        largest_of((0..63).map(|i| (second(at(i)) + ratio * curve(at(i))) / ratio))
    };
    let (cosine, sine) = (|t: f64| (omega0 * t).cos(), |t: f64| (omega0 * t).sin());
    let [c1, c2] = [release.position, release.velocity / omega0];
    let sum = |t: f64| (c1 * cosine(t) + c2 * sine(t)) / amplitude;
    let check = Check::new("harmonic", "3–15")
        .computed("cos: max|x″ + (C/m) x|/ω₀²", residual(&cosine), "1")
        .computed("sin: max|…|", residual(&sine), "1")
        .computed("C₁ cos + C₂ sin: max|…|", residual(&sum), "1")
        .expected("0", 0.0, "1");
    checks.push(check.equal(1.0));

    if let Some(points) = turning_points(motion, 3) {
        let measured = 2.0 * std::f64::consts::PI / (points[2].time - points[0].time);
        checks.push(
            Check::new("angular-frequency", "8, 16")
                .computed("√(C/m)", omega0, "1/s")
                .expected("2π/T", measured, "1/s")
                .equal(measured),
        );
    }

    let start = solution.at(0.0)?;
    checks.push(
        Check::new("constants", "17–19")
            .computed("x(0)", start.position, "m")
            .computed("ẋ(0)", start.velocity, "m/s")
            .expected("x₀", release.position, "m")
            .expected("v₀", release.velocity, "m/s")
            .equal(amplitude.min(amplitude * omega0)),
    );

    checks.push(
        Check::new("general-solution", "20")
            .computed("max|Δx|", formula_deviation(motion, case.duration, &solution)?, "m")
            .expected("0", 0.0, "m")
            .equal(amplitude),
    );

    let [first, second] = eq_36(&oscillator)?;
    let squared = |root: Complex| (root * root).re;
    checks.push(
        Check::new("imaginary-roots", "21–24")
            .computed("λ₁²", squared(first), "1/s²")
            .computed("λ₂²", squared(second), "1/s²")
            .computed("Im λ₁", first.im, "1/s")
            .expected("−C/m", -oscillator.stiffness() / oscillator.mass(), "1/s²")
            .expected("−C/m", -oscillator.stiffness() / oscillator.mass(), "1/s²")
            .expected("ω₀", omega0, "1/s")
            .equal(omega0.min(omega0 * omega0)),
    );

    let difference = |t: f64| form.eq_25(t).re - position(&solution, t);
    checks.push(
        Check::new("both-routes", "20, 25")
            .computed("max|(25) − (20)|", largest(case.duration, difference), "m")
            .computed("max|Im (25)|", largest(case.duration, |t| form.eq_25(t).im), "m")
            .expected("0", 0.0, "m")
            .equal(amplitude),
    );

    // A time at which neither sine nor cosine is near zero.
    let time = radian(case);
    checks.push(
        Check::new("chain-25-27", "25–27")
            .computed("(25)", form.eq_25(time).re, "m")
            .computed("(26)", form.eq_26(time).re, "m")
            .computed("(27)", form.eq_27(time).re, "m")
            .expected("x(1/ω₀)", motion.at(time)?.position, "m")
            .equal(amplitude),
    );

    let [_, printed] = form.eq_28_constants(Reading::Printed);
    checks.push(
        Check::new("lost-factor", "27–28")
            .computed("Re C₂", printed.re, "m")
            .computed("Im C₂", printed.im, "m")
            .expected("v₀/ω₀", release.velocity / omega0, "m")
            .expected("0", 0.0, "m")
            .equal_by_chance(amplitude),
    );
    Ok(checks)
}
