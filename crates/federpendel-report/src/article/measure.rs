//! What several checks measure.

use std::f64::consts::PI;

use federpendel::article::Formula;
use federpendel::scheme::{self, article};
use federpendel::{Motion, Outcome, Result, State, TurningPoint, even_times, lens};

use super::Case;
use super::laboratory::one_digit;

/// Times at which curves are compared.
const POINTS: usize = 2001;

/// How long after the release the mass is looked at again, in times until it rests.
const LATER: f64 = 4.0;

/// The time in which a displacement runs through one radian, s.
pub fn radian(case: &Case) -> f64 {
    1.0 / case.oscillator().angular_frequency()
}

/// Half a period without friction, T/2 = π/ω0, s.
pub fn half_period(case: &Case) -> f64 {
    PI * radian(case)
}

/// The first `count` turning points; none if there are fewer.
pub fn turning_points(motion: &Motion, count: usize) -> Option<Vec<TurningPoint>> {
    let points: Vec<_> = motion.turning_points().take(count).collect();
    (points.len() == count).then_some(points)
}

/// Largest magnitude of a function of time on even times until `until`, s.
pub fn largest(until: f64, value: impl Fn(f64) -> f64) -> f64 {
    let at = |i: usize| until * i as f64 / (POINTS - 1) as f64;
    largest_of((0..POINTS).map(|i| value(at(i))))
}

/// Largest magnitude of some numbers; NaN if one of them is, so that what cannot be computed never looks small.
pub fn largest_of(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(
        0.0,
        |most, value| if value.is_nan() || value.abs() > most { value.abs() } else { most },
    )
}

/// Largest distance of a curve x(t) (m) from the motion until the time `until` (s).
pub fn deviation(motion: &Motion, until: f64, curve: impl Fn(f64) -> f64) -> Result<f64> {
    let times = even_times(until, POINTS)?;
    let samples = motion.samples(&times)?;
    Ok(largest_of(samples.iter().map(|sample| curve(sample.time) - sample.position)))
}

/// Largest distance of a formula from the motion until the time `until`, m.
pub fn formula_deviation(motion: &Motion, until: f64, formula: &Formula) -> Result<f64> {
    deviation(motion, until, |time| position(formula, time))
}

/// The position that a formula gives, m; NaN where it gives none.
pub fn position(formula: &Formula, time: f64) -> f64 {
    formula.at(time).map_or(f64::NAN, |sample| sample.position)
}

/// Time of the rest, or else the end of the record, s.
pub fn end(case: &Case) -> f64 {
    match case.motion.outcome() {
        Outcome::Rests(rest) if rest.time > 0.0 => rest.time,
        _ => case.duration,
    }
}

/// A time well after the rest, s: four times as late, rounded to its leading digit.
pub fn later(case: &Case) -> f64 {
    one_digit(LATER * end(case))
}

/// The article's difference scheme at its usual step.
pub fn scheme(case: &Case) -> Result<article::Scheme> {
    let time_step = case.setting().time_step();
    article::Scheme::new(case.oscillator(), case.release(), time_step)
}

/// Largest distance of that scheme from the motion, on its steps until the time `until`, m.
pub fn scheme_deviation(case: &Case, until: f64) -> Result<f64> {
    let setting = case.setting();
    let mut course = lens::Course::new(article_scheme(), &setting)?;
    Ok(lens::errors(&case.motion, &mut course, until)?.largest)
}

/// The observed order of that scheme; none where it shows none.
pub fn scheme_order(case: &Case) -> Option<f64> {
    lens::ladder(&case.motion, article_scheme(), &case.setting(), case.duration).order()
}

/// The article's scheme among the numeric methods.
pub fn article_scheme() -> &'static scheme::Scheme {
    &article::SCHEME
}

/// The slope of log `error` against log `step` between steps of `first` and `first`/64: the observed order.
pub fn order(first: f64, error: impl Fn(f64) -> f64) -> f64 {
    let steps = (0..=6).map(|k| first * 0.5f64.powi(k));
    let rungs: Vec<_> = steps
        .map(|time_step| lens::Rung {
            time_step,
            tolerance: None,
            error: error(time_step).abs(),
            steps: 1,
        })
        .collect();
    lens::order(&rungs).unwrap_or(f64::NAN)
}

/// What is beyond so many amplitudes has run away.
pub const RUNAWAY: f64 = 1e3;

/// What a scheme leaves of its equation over its first thousand steps, and the largest of the terms that cancel in it:
/// `terms` gives them for three positions in order. None if the scheme runs away.
pub fn residual<const N: usize>(
    case: &Case,
    scheme: &article::Scheme,
    terms: impl Fn(f64, f64, f64) -> [f64; N],
) -> Option<(f64, f64)> {
    let positions = scheme.run(1000).ok()?;
    let away = RUNAWAY * case.motion.amplitude();
    if positions.iter().any(|position| position.abs() > away) {
        return None;
    }
    let all = || positions.windows(3).map(|three| terms(three[0], three[1], three[2]));
    let left = largest_of(all().map(|terms| terms.iter().sum()));
    Some((left, largest_of(all().flatten())))
}

/// The states of the motion while it moves, at even times until it rests or the record ends, with the force of
/// friction (N) that its acceleration tells of.
pub fn friction(case: &Case) -> Result<Vec<(State, f64)>> {
    let oscillator = case.oscillator();
    let samples = case.motion.samples(&even_times(end(case), POINTS)?)?;
    let moving = samples.iter().filter(|sample| sample.velocity != 0.0);
    let force = |sample: &federpendel::Sample| {
        oscillator.mass() * sample.acceleration + oscillator.stiffness() * sample.position
    };
    Ok(moving.map(|sample| (sample.state(), force(sample))).collect())
}

/// Least and largest of some numbers.
pub fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}
