//! Intervals from the profile of the sum of squares: how far a parameter may move with all others
//! following, until the fit is worse by what 95 % allow. They need not be symmetric.

use crate::least_squares::{Effort, Minimum, minimise, solve};
use crate::problem::{LAWS, Problem, Vector};

/// What a profile is measured in.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// What one unit of χ² is in the sum of squares: the variance of a value times the excess of
    /// its noise.
    pub unit: f64,
    /// The standard error of the parameter, for the first guess.
    pub stderr: f64,
    /// How many standard deviations make the interval.
    pub quantile: f64,
}

/// The interval of parameter `i` around `minimum`; an end that is not reached is none.
pub fn interval(
    problem: &mut Problem,
    minimum: &Minimum,
    free: &[bool; 7],
    i: usize,
    measure: Measure,
) -> (Option<f64>, Option<f64>) {
    let low = end(problem, minimum, free, i, measure, -1.0);
    let high = end(problem, minimum, free, i, measure, 1.0);
    (low, high)
}

/// The search for one end is over when the deviation is right to this share.
const CLOSE: f64 = 0.02;

fn end(
    problem: &mut Problem,
    minimum: &Minimum,
    free: &[bool; 7],
    i: usize,
    measure: Measure,
    way: f64,
) -> Option<f64> {
    let value = minimum.at[i];
    let limit = if LAWS.contains(&i) && way < 0.0 { value } else { f64::INFINITY };
    let mut distance = (measure.quantile * measure.stderr).min(limit);
    if limit == 0.0 || !distance.is_finite() {
        return (limit == 0.0).then_some(0.0);
    }
    // The deviation √(Δ/unit) is nearly linear in the distance: a few secants do.
    let (mut inner, mut outer) = ((0.0, 0.0), None);
    for _ in 0..6 {
        let fitted = held(problem, minimum, free, i, way * distance)?;
        let worse = (fitted.normal.cost - minimum.normal.cost).max(0.0);
        let deviation = (worse / measure.unit).sqrt();
        if distance >= limit && deviation <= measure.quantile {
            return Some(0.0);
        }
        if (deviation / measure.quantile - 1.0).abs() < CLOSE {
            return Some(value + way * distance * measure.quantile / deviation);
        }
        if deviation < measure.quantile {
            inner = (distance, deviation);
        } else {
            outer = Some((distance, deviation));
        }
        distance = match outer {
            Some((far, at_far)) => {
                let share = (measure.quantile - inner.1) / (at_far - inner.1);
                inner.0 + (far - inner.0) * share.clamp(0.05, 0.95)
            }
            None => inner.0 * (measure.quantile / deviation.max(0.3)).clamp(1.05, 4.0),
        }
        .min(limit);
    }
    Some(value + way * distance)
}

/// The minimum with parameter `i` held `shift` from where it was.
fn held(
    problem: &mut Problem,
    minimum: &Minimum,
    free: &[bool; 7],
    i: usize,
    shift: f64,
) -> Option<Minimum> {
    let mut free = *free;
    free[i] = false;
    let mut moved = Vector::zeros();
    moved[i] = shift;
    let right = -(minimum.normal.information * moved);
    moved += solve(&minimum.normal.information, &right, &free, 0.0)?;
    let mut start = minimum.at + moved;
    LAWS.iter().for_each(|&law| start[law] = start[law].max(0.0));
    minimise(problem, &start, &free, minimum.ending, HELD)
}

/// Gains below this share of a unit of χ² do not matter to an interval.
const HELD: Effort = Effort { steps: 10, gain: 2e-2 };
