//! Minima between the jumps of an acceleration.
//!
//! Dry friction makes the acceleration jump by 2a_c at every turning point. A value recorded close to one
//! changes sides as the parameters move, and the sum of squares jumps: it has many small minima around the lowest.

use crate::Quantity;
use crate::covariance::variance;
use crate::extremes::median;
use crate::least_squares::{Effort, Minimum, minimise, solve};
use crate::problem::{COULOMB, Loss, Problem, Vector};

/// The lowest minimum found around `minimum`, where the recording has such jumps.
pub fn settle(problem: &mut Problem, minimum: Minimum, free: &[bool; 7]) -> Minimum {
    if problem.quantity != Quantity::Acceleration || minimum.at[COULOMB] == 0.0 {
        return minimum;
    }
    let mut best = unswayed(problem, &minimum, free).unwrap_or(minimum);
    // Then steps of most of a standard error, each parameter in turn and the others following.
    for share in [0.7, 0.25] {
        for i in (0..6).filter(|&i| free[i]) {
            for way in [share, -share] {
                let Some(start) = beside(problem, &best, free, i, way) else { continue };
                let found = minimise(problem, &start, free, best.ending, BRIEF);
                best = found.filter(|f| f.normal.cost < best.normal.cost).unwrap_or(best);
            }
        }
    }
    minimise(problem, &best.at, free, best.ending, Effort::FINE).unwrap_or(best)
}

const BRIEF: Effort = Effort { steps: 6, gain: 1e-2 };

/// The lower one of `minimum` and what is reached from it over a loss that does not count values on the wrong
/// side of a jump.
fn unswayed(problem: &mut Problem, minimum: &Minimum, free: &[bool; 7]) -> Option<Minimum> {
    let loss = problem.loss;
    let residuals = problem.residuals(&minimum.at, minimum.ending)?;
    let mut sizes: Vec<f64> = residuals.iter().map(|r| r.abs()).collect();
    let scale = 1.4826 * median(&mut sizes)?;
    if scale <= 0.0 {
        return None;
    }
    problem.loss = (Loss::Tukey, scale);
    let robust = minimise(problem, &minimum.at, free, minimum.ending, Effort::COARSE);
    problem.loss = loss;
    let found = minimise(problem, &robust?.at, free, minimum.ending, Effort::COARSE)?;
    (found.normal.cost < minimum.normal.cost).then_some(found)
}

/// Where parameter `i` is `shift` of its standard error away and the others follow.
fn beside(
    problem: &Problem,
    minimum: &Minimum,
    free: &[bool; 7],
    i: usize,
    shift: f64,
) -> Option<Vector> {
    let mut unit = Vector::zeros();
    unit[i] = 1.0;
    // A column of the inverse, scaled: the step along which χ² grows least for this parameter.
    let column = solve(&minimum.normal.information, &unit, free, 0.0)?;
    let stderr = (column[i] * variance(minimum, free, problem.len())).sqrt();
    let mut start = minimum.at + column * (shift * stderr / column[i]);
    crate::problem::LAWS.iter().for_each(|&law| start[law] = start[law].max(0.0));
    start.iter().all(|x| x.is_finite()).then_some(start)
}
