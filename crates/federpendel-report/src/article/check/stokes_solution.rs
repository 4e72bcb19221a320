//! Section 2.1, equations (37) to (47): the solution below critical damping. At and above it none of these claims
//! applies.

use std::f64::consts::PI;

use federpendel::article::{Complex, DampedRates, Formula, eq_36, eq_41, eq_46};
use federpendel::{Regime, Result, State};

use super::{Check, ROUNDING};
use crate::article::Case;
use crate::article::measure::{formula_deviation, largest, position, radian, turning_points};

/// The claims, with the equations they belong to.
const CLAIMS: [(&str, &str); 7] = [
    ("conjugate-roots", "37"),
    ("complex-form", "38–40"),
    ("damped-constants", "42–45"),
    ("derivative", "43"),
    ("damped-solution", "40–41, 46–47"),
    ("frequency-lowered", "37"),
    ("exponential-decay", "46"),
];

pub fn checks(case: &Case) -> Result<Vec<Check>> {
    let blank = CLAIMS.map(|(id, equation)| Check::new(id, equation));
    if case.oscillator().regime() != Regime::Underdamped {
        return Ok(blank.to_vec());
    }
    let [roots, complex, constants, derivative, solution, lowered, decay] = blank;
    let rates = eq_41(case.oscillator())?;
    let formula = eq_46(case.oscillator(), case.release())?;
    Ok(vec![
        conjugate_roots(roots, case, rates)?,
        complex_form(complex, case, rates, &formula),
        damped_constants(constants, case, &formula)?,
        derived(derivative, case, &formula)?,
        solution
            .computed("max|Δx|", formula_deviation(&case.motion, case.duration, &formula)?, "m")
            .expected("0", 0.0, "m")
            .equal(case.motion.amplitude()),
        frequency_lowered(lowered, case, rates),
        exponential_decay(decay, case, rates),
    ])
}

fn conjugate_roots(check: Check, case: &Case, rates: DampedRates) -> Result<Check> {
    let omega0 = case.oscillator().angular_frequency();
    let gamma = rates.damping_rate;
    let [root, _] = eq_36(case.oscillator())?;
    Ok(check
        .computed("Re λ₁", root.re, "1/s")
        .computed("Im λ₁", root.im, "1/s")
        .expected("−D/(2m)", -gamma, "1/s")
        .expected("√(ω₀² − D²/(4m²))", (omega0 * omega0 - gamma * gamma).sqrt(), "1/s")
        .equal(omega0))
}

/// The two lines of the complex form, with C̃1 and its conjugate by (45), against the real one.
fn complex_form(check: Check, case: &Case, rates: DampedRates, formula: &Formula) -> Check {
    let DampedRates { damping_rate: gamma, angular_frequency: omega } = rates;
    let State { position: x0, velocity: v0 } = case.release();
    let first = Complex::new(0.5 * x0, -0.5 * (v0 + gamma * x0) / omega);
    let second = Complex::new(first.re, -first.im);
    let eq_38 = |t: f64| {
        let turn = |sign: f64| Complex::new(-gamma * t, sign * omega * t).exp();
        first * turn(1.0) + second * turn(-1.0)
    };
    let eq_39 = |t: f64| {
        let turn = |sign: f64| Complex::new(0.0, sign * omega * t).exp();
        (first * turn(1.0) + second * turn(-1.0)) * (-gamma * t).exp().into()
    };
    let off =
        |value: &dyn Fn(f64) -> f64| largest(case.duration, |t| value(t) - position(formula, t));
    check
        .computed("max|Re (38) − (40)|", off(&|t| eq_38(t).re), "m")
        .computed("max|Re (39) − (40)|", off(&|t| eq_39(t).re), "m")
        .computed("max|Im (38)|", largest(case.duration, |t| eq_38(t).im), "m")
        .expected("0", 0.0, "m")
        .equal(case.motion.amplitude() * case.oscillator().angular_frequency() / omega)
}

fn damped_constants(check: Check, case: &Case, formula: &Formula) -> Result<Check> {
    let start = formula.at(0.0)?;
    let amplitude = case.motion.amplitude();
    Ok(check
        .computed("x(0)", start.position, "m")
        .computed("ẋ(0)", start.velocity, "m/s")
        .expected("x₀", case.release().position, "m")
        .expected("v₀", case.release().velocity, "m/s")
        .within(amplitude * case.oscillator().angular_frequency())
        .equal(amplitude))
}

/// (43) against a difference quotient of (46), at a time at which neither is near zero.
fn derived(check: Check, case: &Case, formula: &Formula) -> Result<Check> {
    let (time, h) = (radian(case), 1e-5 * radian(case));
    let quotient = (position(formula, time + h) - position(formula, time - h)) / (2.0 * h);
    let check = check
        .computed("(43)", formula.at(time)?.velocity, "m/s")
        .expected("Δx/Δt", quotient, "m/s");
    let speed = case.motion.amplitude() * case.oscillator().angular_frequency();
    let agrees = check.agrees(speed, 1e-7);
    Ok(check.judged(agrees))
}

fn frequency_lowered(check: Check, case: &Case, rates: DampedRates) -> Check {
    let Some(points) = turning_points(&case.motion, 2) else { return check };
    let (omega, omega0) = (rates.angular_frequency, case.oscillator().angular_frequency());
    let measured = PI / (points[1].time - points[0].time);
    let check = check
        .computed("π/(t₂ − t₁)", measured, "1/s")
        .expected("√(ω₀² − D²/(4m²))", omega, "1/s")
        .expected("< ω₀", omega0, "1/s");
    let agrees = check.agrees(omega, ROUNDING) && measured < omega0;
    check.judged(agrees)
}

fn exponential_decay(check: Check, case: &Case, rates: DampedRates) -> Check {
    let Some(points) = turning_points(&case.motion, 4) else { return check };
    // Next to critical damping a swing takes everything.
    if points.iter().any(|point| point.position.abs() <= f64::MIN_POSITIVE) {
        return check;
    }
    let ratio = |n: usize| (points[n].position / points[n - 1].position).abs();
    let decay = (-rates.damping_rate * PI / rates.angular_frequency).exp();
    check
        .computed("|x₂|/|x₁|", ratio(1), "1")
        .computed("|x₃|/|x₂|", ratio(2), "1")
        .computed("|x₄|/|x₃|", ratio(3), "1")
        .expected("e^(−γπ/ω)", decay, "1")
        .equal(1.0)
}
