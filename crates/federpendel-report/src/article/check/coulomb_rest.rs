//! Section 3.2.1, equations (61) and (69): the solution for a release from rest.

use std::f64::consts::PI;

use federpendel::article::{Reading, eq_61, eq_69};
use federpendel::{Outcome, Result, even_times};

use super::{Check, LINE_WIDTH};
use crate::article::measure::{
    end, formula_deviation, half_period, largest_of, later, position, scheme_deviation,
    turning_points,
};
use crate::article::{Case, Laboratory};

/// c_w of the article's section 4, where none is known: that of a sphere.
const DRAG_COEFFICIENT: f64 = 0.47;

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.coulomb;
    Ok(vec![
        letter(laboratory),
        frequency(case),
        analytic(case)?,
        solution(case)?,
        at_turning_points(case)?,
        start(case)?,
        sign(case)?,
        written_out(case)?,
        after_rest(case)?,
        agreement(case)?,
        proof(case)?,
    ])
}

/// ω0 = √(c/m): the only c of the article is c_w. What c must be, the half period tells.
fn letter(laboratory: &Laboratory) -> Check {
    let check = Check::new("letter-c", "61");
    let case = &laboratory.coulomb;
    let Some(points) = turning_points(&case.motion, 1) else { return check };
    let needed = case.oscillator().mass() * (PI / points[0].time).powi(2);
    check
        .computed("c_w", laboratory.drag_coefficient.unwrap_or(DRAG_COEFFICIENT), "1")
        .expected("c = m(π/t₁)²", needed, "N/m")
        .equal_by_chance(needed)
}

/// Turning points lie half an undamped period apart, however strong the friction.
fn frequency(case: &Case) -> Check {
    let check = Check::new("frequency-unchanged", "61");
    let times: Vec<f64> = case.motion.turning_points().take(1000).map(|point| point.time).collect();
    let Some(last) = times.last() else { return check };
    check
        .computed("π/ω₀", half_period(case), "s")
        .expected("t_N/N", last / times.len() as f64, "s")
        .equal(half_period(case))
}

/// There is an analytic solution: swing by swing a cosine about a shifted centre.
fn analytic(case: &Case) -> Result<Check> {
    let check = Check::new("analytic-exists", "§3.1");
    let Some(points) = turning_points(&case.motion, 1) else { return Ok(check) };
    let oscillator = case.oscillator();
    let (x0, omega0) = (case.release().position, oscillator.angular_frequency());
    let centre = oscillator.offset() * x0.signum();
    let times = even_times(points[0].time, 101)?;
    let samples = case.motion.samples(&times)?;
    let away = samples.iter().map(|sample| {
        let swing = centre + (x0 - centre) * (omega0 * sample.time).cos();
        sample.position - swing
    });
    Ok(check
        .computed("max|x − (f + (x₀ − f) cos ω₀t)|", largest_of(away), "m")
        .expected("0", 0.0, "m")
        .equal(x0))
}

/// (61) with the right v_A, until the rest: no solution of (57).
fn solution(case: &Case) -> Result<Check> {
    let formula = eq_61(case.oscillator(), case.release().position, Reading::Corrected)?;
    let distance = formula_deviation(&case.motion, end(case), &formula)?;
    Ok(Check::new("linear-solution", "61")
        .computed("max|Δx|", distance, "m")
        .expected("0", 0.0, "m")
        .equal(case.motion.amplitude()))
}

/// The same at the turning points, where it is right.
fn at_turning_points(case: &Case) -> Result<Check> {
    let check = Check::new("linear-turning-points", "61");
    let formula = eq_61(case.oscillator(), case.release().position, Reading::Corrected)?;
    let points: Vec<_> = case.motion.turning_points().take(1000).collect();
    if points.is_empty() {
        return Ok(check);
    }
    let away = points.iter().map(|point| position(&formula, point.time) - point.position);
    Ok(check
        .computed("max|Δx(t_n)|", largest_of(away), "m")
        .expected("0", 0.0, "m")
        .equal(case.motion.amplitude()))
}

/// (61) begins with the velocity −v_A.
fn start(case: &Case) -> Result<Check> {
    let formula = eq_61(case.oscillator(), case.release().position, Reading::Corrected)?;
    let scale = case.motion.amplitude() * case.oscillator().angular_frequency();
    Ok(Check::new("linear-start", "61")
        .computed("ẋ(0)", formula.at(0.0)?.velocity, "m/s")
        .expected("v₀", 0.0, "m/s")
        .equal(scale))
}

/// (61) as printed for a release on the negative side, at the end of the first swing.
fn sign(case: &Case) -> Result<Check> {
    let check = Check::new("negative-release", "61, 69").reading();
    let Some(points) = turning_points(&case.motion, 1) else { return Ok(check) };
    let from = -case.release().position.abs();
    let formula = eq_61(case.oscillator(), from, Reading::Printed)?;
    Ok(check
        .computed("|x(t₁)|, x₀ < 0", position(&formula, points[0].time).abs(), "m")
        .expected("|x₁|", points[0].position.abs(), "m")
        .equal(case.motion.amplitude()))
}

/// (69) at the first turning point, against (61), which is right there.
fn written_out(case: &Case) -> Result<Check> {
    let check = Check::new("written-out", "69");
    let Some(points) = turning_points(&case.motion, 1) else { return Ok(check) };
    let from = case.release().position.abs();
    let formula = eq_69(case.oscillator(), from, Reading::Printed)?;
    Ok(check
        .computed("x(t₁), (69)", position(&formula, points[0].time), "m")
        .expected("x₁", points[0].position * case.release().position.signum(), "m")
        .equal_by_chance(case.motion.amplitude()))
}

/// Both formulas long after the rest.
fn after_rest(case: &Case) -> Result<Check> {
    let check = Check::new("after-rest", "61, 69").reading();
    let Outcome::Rests(rest) = case.motion.outcome() else { return Ok(check) };
    let (time, from) = (later(case), case.release().position);
    let corrected = eq_61(case.oscillator(), from, Reading::Corrected)?;
    let printed = eq_69(case.oscillator(), from, Reading::Printed)?;
    Ok(check
        .computed_at(time, "x, (61)", position(&corrected, time))
        .computed_at(time, "x, (69)", position(&printed, time))
        .expected("x_N", rest.position, "m")
        .equal(case.motion.amplitude()))
}

/// The graph: numeric solution and (69) on one line.
fn agreement(case: &Case) -> Result<Check> {
    let check = Check::new("agreement-coulomb", "59, 69");
    let printed = eq_69(case.oscillator(), case.release().position, Reading::Printed)?;
    let amplitude = case.motion.amplitude();
    let formula = formula_deviation(&case.motion, end(case), &printed)? / amplitude;
    let Ok(scheme) = scheme_deviation(case, end(case)) else { return Ok(check) };
    let agrees = formula <= LINE_WIDTH && scheme / amplitude <= LINE_WIDTH;
    Ok(check
        .computed("max|Δx|/x₀, (69)", formula, "1")
        .computed("max|Δx|/x₀, (59)", scheme / amplitude, "1")
        .expected("0", 0.0, "1")
        .judged(agrees))
}

/// “Beweist”: agreement of curves would prove that friction leaves the frequency alone only if it left the zero
/// crossings alone too.
fn proof(case: &Case) -> Result<Check> {
    let check = Check::new("agreement-proves", "61");
    if turning_points(&case.motion, 1).is_none() {
        return Ok(check);
    }
    let (f, x0) = (case.oscillator().offset(), case.release().position.abs());
    if x0 < 2.0 * f {
        // It turns before it has passed x = 0.
        return Ok(check);
    }
    // Seen from the centre f of its first swing the mass starts at x0 − f; it passes x = 0 where the cosine is −f/(x0 − f).
    let crossing = (-f / (x0 - f)).max(-1.0).acos() / case.oscillator().angular_frequency();
    Ok(check
        .computed("ω₀t = π/2", 0.5 * half_period(case), "s")
        .computed_at(crossing, "x", case.motion.at(crossing)?.position)
        .expected("x(t) = 0", crossing, "s")
        .expected("0", 0.0, "m")
        .within(x0)
        .equal(half_period(case)))
}
