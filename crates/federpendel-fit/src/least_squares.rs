//! Bounded least squares: Levenberg–Marquardt with coefficients that stay at or above zero.
//!
//! A page of our own, since the published crate has no bounds: seven parameters at most, so the
//! normal equations are a small matrix, gathered in one pass over the values. Damping follows
//! Nielsen (1999), the bounds are an active set within each step.

use crate::problem::{Ending, LAWS, Matrix, Normal, OMEGA, Problem, Vector};

/// Why a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StopReason {
    /// A further step would lower the sum of squares by less than rounding or noise can tell.
    Converged,
    /// No step lowered it, though the linear model expected one to: a kink or a jump is near.
    NoProgress,
    /// So many steps were taken that it was given up.
    StepLimit,
}

/// The end of a search.
#[derive(Debug, Clone, Copy)]
pub struct Minimum {
    /// The parameters.
    pub at: Vector,
    /// Sum of squares and derivatives there.
    pub normal: Normal,
    /// How the motion ends in it.
    pub ending: Ending,
    /// Why the search ended.
    pub reason: StopReason,
}

/// How far to search.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Steps at most.
    pub steps: usize,
    /// The search ends where the next step would gain less than this many variances of one value.
    pub gain: f64,
}

impl Effort {
    /// For a result on the way to another.
    pub const COARSE: Effort = Effort { steps: 15, gain: 1e-2 };
    /// For a result: parameters to a thousandth of their standard errors.
    pub const FINE: Effort = Effort { steps: 50, gain: 1e-6 };
}

/// The step that minimises the quadratic model with `free` parameters, damped by `lambda`, such
/// that no coefficient falls below zero.
pub fn bounded_step(
    normal: &Normal,
    at: &Vector,
    free: &[bool; 7],
    lambda: f64,
) -> Option<(Vector, f64)> {
    let mut free = *free;
    let mut step = Vector::zeros();
    // A coefficient at zero that the slope holds there stays.
    for i in LAWS {
        free[i] &= at[i] > 0.0 || normal.gradient[i] > 0.0;
    }
    for _ in 0..=LAWS.len() {
        let right = normal.gradient - normal.information * step;
        let solved = solve(&normal.information, &right, &free, lambda)?;
        let trial = Vector::from_fn(|i, _| if free[i] { solved[i] } else { step[i] });
        let below = LAWS.iter().find(|&&i| free[i] && at[i] + trial[i] < 0.0);
        let Some(&i) = below else {
            let expected =
                2.0 * normal.gradient.dot(&trial) - trial.dot(&(normal.information * trial));
            return Some((trial, expected));
        };
        (free[i], step[i]) = (false, -at[i]);
    }
    None
}

/// Solves `matrix` x = `right` for the `free` unknowns, the diagonal raised by the share `lambda`.
pub fn solve(matrix: &Matrix, right: &Vector, free: &[bool; 7], lambda: f64) -> Option<Vector> {
    // Scaled to a unit diagonal, so that units do not matter to the factorisation.
    let scale = Vector::from_fn(|i, _| matrix[(i, i)].sqrt());
    let idle = |i: usize| !free[i] || scale[i] == 0.0;
    let scaled = Matrix::from_fn(|i, j| match i == j {
        true => 1.0 + lambda + 1e-13,
        false if idle(i) || idle(j) => 0.0,
        false => matrix[(i, j)] / (scale[i] * scale[j]),
    });
    let right = Vector::from_fn(|i, _| if idle(i) { 0.0 } else { right[i] / scale[i] });
    let solved = scaled.cholesky()?.solve(&right);
    Some(Vector::from_fn(|i, _| if idle(i) { 0.0 } else { solved[i] / scale[i] }))
}

/// The minimum of `problem` over the `free` parameters that lies downhill from `start`.
pub fn minimise(
    problem: &mut Problem,
    start: &Vector,
    free: &[bool; 7],
    ending: Ending,
    effort: Effort,
) -> Option<Minimum> {
    let mut at = *start;
    let mut normal = problem.normal(&at, ending)?;
    let (mut lambda, mut growth) = (1e-4, 2.0);
    let floor = f64::EPSILON.powi(2) * problem.values.iter().map(|x| x * x).sum::<f64>();
    let mut reason = StopReason::StepLimit;
    for _ in 0..effort.steps {
        let Some((step, expected)) = bounded_step(&normal, &at, free, lambda) else {
            (lambda, growth) = (lambda * growth, growth * 2.0);
            continue;
        };
        let variance = normal.cost / problem.len() as f64;
        if expected <= effort.gain * variance * (1.0 + lambda).recip() || normal.cost <= floor {
            reason = StopReason::Converged;
            break;
        }
        let trial = at + step;
        let most = problem.fastest.min(2.0 * at[OMEGA]);
        let sane = trial[OMEGA] > 0.5 * at[OMEGA] && trial[OMEGA] < most;
        let tried = if sane { problem.normal(&trial, ending) } else { None };
        match tried {
            Some(next) if next.cost < normal.cost => {
                let ratio = (normal.cost - next.cost) / expected;
                lambda *= (1.0 - (2.0 * ratio - 1.0).powi(3)).clamp(0.1, 2.0);
                (at, normal, growth) = (trial, next, 2.0);
            }
            _ => (lambda, growth) = (lambda * growth, growth * 2.0),
        }
        if lambda > 1e8 {
            reason = StopReason::NoProgress;
            break;
        }
    }
    Some(Minimum { at, normal, ending, reason })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::Quantity;

    const ALL: [bool; 7] = [true; 7];

    /// ½ Σ h_i (x_i − c_i)², coupled by `coupling` between the first two laws.
    fn bowl(at: &Vector, centre: &Vector, coupling: f64) -> Normal {
        let mut information = Matrix::identity();
        information[(1, 2)] = coupling;
        information[(2, 1)] = coupling;
        let away = centre - at;
        let gradient = information * away;
        Normal { cost: away.dot(&gradient), gradient, information }
    }

    #[test]
    fn a_step_stays_where_coefficients_may_be() {
        let centre = Vector::from([2.0, -1.0, 3.0, 0.5, -4.0, 5.0, 6.0]);
        let at = Vector::from([1.0, 0.5, 0.1, 0.2, 0.0, 0.0, 0.0]);
        let (step, expected) =
            bounded_step(&bowl(&at, &centre, 0.3), &at, &ALL, 0.0).expect("solvable");
        let end = at + step;
        assert!(LAWS.iter().all(|&i| end[i] >= 0.0) && end[1] == 0.0, "{end}");
        // With the first at zero the coupled one moves: its own minimum is c2 + 0.3 (c1 − 0).
        assert!((end[2] - (3.0 - 0.3)).abs() < 1e-9, "{end}");
        let fell = bowl(&at, &centre, 0.3).cost - bowl(&end, &centre, 0.3).cost;
        assert!((fell - expected).abs() < 1e-9 * fell, "{fell} {expected}");
    }

    #[test]
    fn a_coefficient_at_zero_stays_if_the_slope_holds_it_there() {
        let at = Vector::from([1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let centre = Vector::from([1.0, -1.0, 2.0, 0.0, 0.0, 0.0, 0.0]);
        let (step, _) = bounded_step(&bowl(&at, &centre, 0.0), &at, &ALL, 0.0).expect("solvable");
        assert_eq!(step[1], 0.0);
        assert!((step[2] - 2.0).abs() < 1e-9);
    }

    #[test]
    fn no_frequency_beyond_that_of_the_values_is_looked_for() {
        // From each value to the next it swings 1.05 times; a search from 0.995 times on goes there if it may.
        let times: Vec<f64> = (0..16).map(f64::from).collect();
        let values = times.iter().map(|time| (1.05 * PI * time).sin()).collect();
        let mut problem = Problem::new(times, values, Quantity::Position);
        let omega = 0.995 * PI;
        let start = Vector::from([omega, 0.0, 0.0, 0.0, 0.0, omega, 0.0]);
        let free = [true, false, false, false, false, false, false];
        let found = minimise(&mut problem, &start, &free, Ending::Natural, Effort::FINE);
        let omega = found.map(|found| found.at[OMEGA]);
        assert!(omega.is_some_and(|omega| omega < PI), "{omega:?}");
    }
}
