//! Section 2.2: the difference quotients, the scheme (51) and its start.

use federpendel::scheme::article::Scheme;
use federpendel::{Friction, Motion, Oscillator, Result, Sample, State};

use super::{Check, LINE_WIDTH};
use crate::article::measure::{
    RUNAWAY, end, half_period, largest_of, order, radian, residual, scheme, scheme_deviation,
    scheme_order,
};
use crate::article::{Case, Laboratory};

/// How near an observed order must come to the one that is claimed.
const NEAR: f64 = 0.2;

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.stokes;
    Ok(vec![
        quotient_orders(&laboratory.undamped)?,
        recursion(case)?,
        scheme_orders(case)?,
        stability(case)?,
        start_quotient(laboratory)?,
        start(case)?,
        agreement(case)?,
    ])
}

fn at(motion: &Motion, time: f64) -> f64 {
    motion.at(time).map_or(f64::NAN, |sample| sample.position)
}

/// How fast the errors of (48) and (49) fall with the step, on a motion that is known; at one time alone an error may
/// vanish by chance.
fn quotient_orders(case: &Case) -> Result<Check> {
    let motion = &case.motion;
    let samples = motion.samples(&[1.0, 2.0, 3.0].map(|angle| angle * radian(case)))?;
    let largest = |error: &dyn Fn(&Sample) -> f64| largest_of(samples.iter().map(error));
    let backward =
        |h: f64| largest(&|now| (now.position - at(motion, now.time - h)) / h - now.velocity);
    let second = |h: f64| {
        largest(&|now| {
            let sum = at(motion, now.time + h) - 2.0 * now.position + at(motion, now.time - h);
            sum / (h * h) - now.acceleration
        })
    };
    let longest = 0.2 * radian(case);
    let (first_order, second_order) = (order(longest, backward), order(longest, second));
    Ok(Check::new("quotient-orders", "48–49")
        .reading()
        .computed("p(48)", first_order, "1")
        .computed("p(49)", second_order, "1")
        .expected("2", 2.0, "1")
        .judged((first_order - 2.0).abs() < NEAR && (second_order - 2.0).abs() < NEAR))
}

/// Whether the positions of (51) satisfy (50).
fn recursion(case: &Case) -> Result<Check> {
    let (oscillator, scheme) = (case.oscillator(), scheme(case)?);
    let (h, mass) = (scheme.time_step(), oscillator.mass());
    let left = residual(case, &scheme, |before, now, after| {
        let quotient = (now - before) / h;
        [
            (after - 2.0 * now + before) / (h * h),
            2.0 * oscillator.damping_rate() * quotient,
            oscillator.stiffness() / mass * now,
        ]
    });
    let check = Check::new("recursion-stokes", "50–51");
    Ok(residual_check(check, left, case, h))
}

/// What is left is zero up to what rounding makes of the terms, and of positions that are divided by the square of the
/// step; of a scheme that runs away nothing can be said.
pub fn residual_check(check: Check, left: Option<(f64, f64)>, case: &Case, step: f64) -> Check {
    let Some((left, largest)) = left else { return check };
    let divided = case.motion.amplitude() / (step * step);
    let check = check.computed("max|…|", left, "m/s²").expected("0", 0.0, "m/s²");
    check.judged(left <= 64.0 * f64::EPSILON * (divided + largest))
}

/// The order of the scheme with this friction and without.
fn scheme_orders(case: &Case) -> Result<Check> {
    let check = Check::new("scheme-order-stokes", "48–51").reading();
    let oscillator = case.oscillator();
    let undamped = Oscillator::new(oscillator.mass(), oscillator.stiffness(), Friction::NONE)?;
    let undamped = Case::on(Motion::new(undamped, case.release())?);
    let (Some(with), Some(without)) = (scheme_order(case), scheme_order(&undamped)) else {
        return Ok(check);
    };
    Ok(check
        .computed("p(D)", with, "1")
        .computed("p(D = 0)", without, "1")
        .expected("2", 2.0, "1")
        .judged_by_chance((with - 2.0).abs() < NEAR && (without - 2.0).abs() < NEAR))
}

/// The claim that the scheme is of second order with this friction. With very little of it that is so at the steps
/// that are tried, by chance.
pub fn order_of_scheme(
    case: &Case,
    id: &'static str,
    equation: &'static str,
    symbol: &'static str,
) -> Check {
    let check = Check::new(id, equation).reading();
    match scheme_order(case) {
        None => check,
        Some(order) => check
            .computed(symbol, order, "1")
            .expected("2", 2.0, "1")
            .judged_by_chance((order - 2.0).abs() < NEAR),
    }
}

/// Steps for which a run is watched on both sides of the limit.
const WATCHED: u64 = 10_000;

/// The article gives no limit to the step; here is one, with runs just below and above it.
fn stability(case: &Case) -> Result<Check> {
    let limit = Scheme::longest_stable_step(case.oscillator(), case.release());
    let away = RUNAWAY * case.motion.amplitude();
    let runaway = |step: f64| {
        let scheme = Scheme::new(case.oscillator(), case.release(), step)?;
        let mut steps = scheme.steps().take(WATCHED as usize);
        // A step that is not finite is one that has run away.
        let far = steps.position(|step| step.map_or(true, |step| step.position.abs() > away));
        Ok(far.map_or(f64::INFINITY, |index| index as f64))
    };
    let (below, above) = (runaway(0.98 * limit)?, runaway(1.02 * limit)?);
    Ok(Check::new("stability", "51")
        .reading()
        .computed("Δt_max", limit, "s")
        .computed("n(|x_n| > 1000 A), Δt = 98 % Δt_max", below, "1")
        .computed("n(|x_n| > 1000 A), Δt = 102 % Δt_max", above, "1")
        .expected("Δt_max", f64::INFINITY, "s")
        .expected("n", f64::INFINITY, "1")
        .judged(above.is_infinite()))
}

/// “2. Ordnung”: how fast the error of (52) falls. Where the third derivative vanishes at the release it is of second
/// order by chance.
fn start_quotient(laboratory: &Laboratory) -> Result<Check> {
    let release = laboratory.undamped.release();
    let motion = Motion::new(*laboratory.stokes.oscillator(), release)?;
    let exact = motion.at(0.0)?.acceleration;
    let State { position, velocity } = release;
    let quotient = |h: f64| ((at(&motion, h) - position) / h - velocity) / (0.5 * h) - exact;
    let observed = order(0.2 * radian(&laboratory.stokes), quotient);
    Ok(Check::new("start-order", "52")
        .reading()
        .computed("p(52)", observed, "1")
        .expected("2", 2.0, "1")
        .judged_by_chance((observed - 2.0).abs() < NEAR))
}

/// Whether the first step (54) satisfies (53).
fn start(case: &Case) -> Result<Check> {
    let oscillator = case.oscillator();
    let check = Check::new("start-stokes", "53–54");
    start_check(check, case, |State { position, velocity }| {
        [
            2.0 * oscillator.damping_rate() * velocity,
            oscillator.stiffness() / oscillator.mass() * position,
        ]
    })
}

/// Whether the first step of the scheme satisfies the equation with the quotient (52), where `terms` gives the other
/// terms for the release.
pub fn start_check(check: Check, case: &Case, terms: impl Fn(State) -> [f64; 2]) -> Result<Check> {
    let scheme = scheme(case)?;
    let (h, release) = (scheme.time_step(), case.release());
    let first = scheme.run(1)?[1];
    let acceleration = ((first - release.position) / h - release.velocity) / (0.5 * h);
    let [one, other] = terms(release);
    let largest = largest_of([acceleration, one, other].into_iter());
    let left = (acceleration + one + other).abs();
    Ok(residual_check(check, Some((left, largest)), case, h))
}

/// The graph: numeric and analytic solution on one line.
fn agreement(case: &Case) -> Result<Check> {
    let check = Check::new("agreement-stokes", "46, 51");
    let until = end(case).min(24.0 * half_period(case));
    let Ok(distance) = scheme_deviation(case, until) else { return Ok(check) };
    let share = distance / case.motion.amplitude();
    Ok(check.computed("max|Δx|/x₀", share, "1").expected("0", 0.0, "1").judged(share <= LINE_WIDTH))
}
