//! Section 3.2.2: Coulomb friction with any release, (71) to (80).

use federpendel::article::{Reading, eq_20, eq_76, eq_77, eq_78, eq_79};
use federpendel::{Outcome, Result, State};

use super::{Check, LINE_WIDTH};
use crate::article::measure::{
    deviation, end, formula_deviation, largest_of, later, position, scheme_deviation,
    turning_points,
};
use crate::article::{Case, Laboratory};

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let [backward, forward] = by_sign(&laboratory.thrown);
    Ok(vec![
        one_sine(&laboratory.undamped)?,
        coefficients(&laboratory.undamped)?,
        amplitude(&laboratory.undamped)?,
        tangent(&laboratory.undamped)?,
        quadrant(backward)?,
        undefined(backward),
        solution(&laboratory.thrown)?,
        turning_places(&laboratory.thrown)?,
        written_out(forward)?,
        after_rest(forward)?,
        agreement(backward)?,
    ])
}

/// The motion with v0 < 0 first.
fn by_sign(thrown: &[Case; 2]) -> [&Case; 2] {
    let [first, second] = thrown;
    if first.release().velocity < 0.0 { [first, second] } else { [second, first] }
}

/// A and φ of (76), (77) for the motion without friction, φ in the right quadrant.
fn amplitude_and_phase(case: &Case) -> Result<(f64, f64)> {
    let (oscillator, release) = (case.oscillator(), case.release());
    Ok((eq_76(oscillator, release)?, eq_77(oscillator, release, Reading::Corrected)?))
}

fn one_sine(case: &Case) -> Result<Check> {
    let (a, phi) = amplitude_and_phase(case)?;
    let omega0 = case.oscillator().angular_frequency();
    let sum = eq_20(case.oscillator(), case.release())?;
    let away = deviation(&case.motion, case.duration, |t| a * (omega0 * t + phi).sin())?;
    Ok(Check::new("one-sine", "71–73")
        .computed(
            "max|Δx|, x₀ cos + (v₀/ω₀) sin",
            formula_deviation(&case.motion, case.duration, &sum)?,
            "m",
        )
        .computed("max|Δx|, A sin(ω₀t + φ)", away, "m")
        .expected("0", 0.0, "m")
        .equal(a))
}

fn coefficients(case: &Case) -> Result<Check> {
    let (a, phi) = amplitude_and_phase(case)?;
    let State { position, velocity } = case.release();
    Ok(Check::new("coefficients", "74–75")
        .computed("A sin φ", a * phi.sin(), "m")
        .computed("A cos φ", a * phi.cos(), "m")
        .expected("x₀", position, "m")
        .expected("v₀/ω₀", velocity / case.oscillator().angular_frequency(), "m")
        .equal(a))
}

fn amplitude(case: &Case) -> Result<Check> {
    let check = Check::new("amplitude", "76");
    let Some(points) = turning_points(&case.motion, 1) else { return Ok(check) };
    let (a, phi) = amplitude_and_phase(case)?;
    let State { position, velocity } = case.release();
    let other = velocity / case.oscillator().angular_frequency();
    Ok(check
        .computed("√(A² sin²φ + A² cos²φ)", (a * phi.sin()).hypot(a * phi.cos()), "m")
        .computed("√(x₀² + (v₀/ω₀)²)", (position * position + other * other).sqrt(), "m")
        .expected("|x(t₁)|", points[0].position.abs(), "m")
        .equal(a))
}

/// The chain of (77) up to the arc tangent.
fn tangent(case: &Case) -> Result<Check> {
    let (a, phi) = amplitude_and_phase(case)?;
    let State { position, velocity } = case.release();
    let quotient = position * case.oscillator().angular_frequency() / velocity;
    Ok(Check::new("tangent", "77")
        .computed("A sin φ/(A cos φ)", a * phi.sin() / (a * phi.cos()), "1")
        .computed("tan φ", phi.tan(), "1")
        .expected("x₀/(v₀/ω₀)", quotient, "1")
        // The tangent magnifies the rounding of its angle by its own square.
        .equal(quotient.abs().max(quotient * quotient)))
}

/// v0 < 0: where the motion begins with the printed phase.
fn quadrant(case: &Case) -> Result<Check> {
    let (oscillator, release) = (case.oscillator(), case.release());
    let a = eq_76(oscillator, release)?;
    let printed = eq_77(oscillator, release, Reading::Printed)?;
    let right = eq_77(oscillator, release, Reading::Corrected)?;
    Ok(Check::new("quadrant", "77, 79")
        .computed("A sin(arctan(x₀ω₀/v₀)), v₀ < 0", a * printed.sin(), "m")
        .computed("arctan(x₀ω₀/v₀), v₀ < 0", printed, "rad")
        .expected("x₀", release.position, "m")
        .expected("atan2(x₀ω₀, v₀), v₀ < 0", right, "rad")
        .within(1.0)
        .equal(a))
}

/// v0 = 0: the quotient as it stands, for a displaced mass and for one in the middle.
fn undefined(case: &Case) -> Check {
    let State { position, velocity } = State { velocity: 0.0, ..case.release() };
    let quotient = |position: f64| position * case.oscillator().angular_frequency() / velocity;
    let (displaced, middle) = (quotient(position), quotient(0.0));
    Check::new("phase-at-rest", "77")
        .reading()
        .computed("x₀ω₀/0", displaced, "1")
        .computed("0·ω₀/0", middle, "1")
        .judged(displaced.is_finite() && middle.is_finite())
}

/// (78) with everything right that can be, until the rest, for both throws.
fn solution(thrown: &[Case; 2]) -> Result<Check> {
    let [backward, forward] = by_sign(thrown);
    let away = |case: &Case| {
        let formula = eq_78(case.oscillator(), case.release(), Reading::Corrected)?;
        formula_deviation(&case.motion, end(case), &formula)
    };
    Ok(Check::new("general-linear-solution", "78")
        .computed("max|Δx|, v₀ < 0", away(backward)?, "m")
        .computed("max|Δx|, v₀ > 0", away(forward)?, "m")
        .expected("0", 0.0, "m")
        .equal(forward.motion.amplitude()))
}

fn turning_places(thrown: &[Case; 2]) -> Result<Check> {
    let check = Check::new("general-turning-points", "78");
    let [backward, forward] = by_sign(thrown);
    let away = |case: &Case| {
        let formula = eq_78(case.oscillator(), case.release(), Reading::Corrected)?;
        let points = case.motion.turning_points().take(1000);
        Ok(largest_of(points.map(|point| position(&formula, point.time) - point.position)))
    };
    Ok(check
        .computed("max|Δx(t_n)|, v₀ < 0", away(backward)?, "m")
        .computed("max|Δx(t_n)|, v₀ > 0", away(forward)?, "m")
        .expected("0", 0.0, "m")
        .equal(forward.motion.amplitude()))
}

/// (79) for v0 > 0, where its phase is right, against (78) at the second turning point.
fn written_out(case: &Case) -> Result<Check> {
    let check = Check::new("general-written-out", "79");
    let Some(points) = turning_points(&case.motion, 2) else { return Ok(check) };
    let printed = eq_79(case.oscillator(), case.release(), Reading::Printed)?;
    let right = eq_78(case.oscillator(), case.release(), Reading::Corrected)?;
    Ok(check
        .computed("x(t₂), (79), v₀ > 0", position(&printed, points[1].time), "m")
        .expected("x(t₂), (78), v₀ > 0", position(&right, points[1].time), "m")
        .equal_by_chance(case.motion.amplitude()))
}

fn after_rest(case: &Case) -> Result<Check> {
    let check = Check::new("general-after-rest", "78, 79").reading();
    let Outcome::Rests(rest) = case.motion.outcome() else { return Ok(check) };
    let time = later(case);
    let corrected = eq_78(case.oscillator(), case.release(), Reading::Corrected)?;
    let printed = eq_79(case.oscillator(), case.release(), Reading::Printed)?;
    Ok(check
        .computed_at(time, "x, (78), v₀ > 0", position(&corrected, time))
        .computed_at(time, "x, (79), v₀ > 0", position(&printed, time))
        .expected("x_N, v₀ > 0", rest.position, "m")
        .equal(case.motion.amplitude()))
}

/// The graph with a general release, here v0 < 0: the printed phase, with the right v_A.
fn agreement(case: &Case) -> Result<Check> {
    let check = Check::new("agreement-general", "59, 79");
    let printed = eq_78(case.oscillator(), case.release(), Reading::Printed)?;
    let distance = formula_deviation(&case.motion, end(case), &printed)?;
    let Ok(scheme) = scheme_deviation(case, end(case)) else { return Ok(check) };
    let amplitude = case.motion.amplitude();
    Ok(check
        .computed("max|Δx|, φ (77), v₀ < 0", distance, "m")
        .computed("max|Δx|, (59), v₀ < 0", scheme, "m")
        .expected("0", 0.0, "m")
        .judged_by_chance(distance.max(scheme) <= LINE_WIDTH * amplitude))
}
