//! From start values to the whole recording: a window that grows.
//!
//! Started on the whole, a search ends in a wrong minimum as soon as the phase is off by half a
//! turn at the far end. Over few swings it cannot be; and what few swings tell is good for some
//! more.

use crate::check::FEWEST;
use crate::least_squares::{Effort, Minimum, minimise};
use crate::problem::{Ending, Problem, Vector};

/// Swings in the first window.
const FIRST: f64 = 6.0;
/// Each window is so many times longer than the one before.
const GROWTH: f64 = 1.7;
/// Values per swing that windows on the way are thinned to.
const PER_SWING: f64 = 12.0;

/// Every how many values to take on the way, with swings of `half` seconds.
pub fn stride(problem: &Problem, half: f64) -> usize {
    let span = problem.times[problem.len() - 1] - problem.times[0];
    let per_swing = problem.len() as f64 * (half / span).min(1.0);
    (per_swing / PER_SWING).floor().max(1.0) as usize
}

/// The best minimum of the whole, reached from any of `starts` with swings of about `half` seconds;
/// coarsely, and on thinned values.
pub fn grow(
    problem: &mut Problem,
    starts: &[Vector],
    free: &[bool; 7],
    ending: Ending,
    half: f64,
) -> Option<Minimum> {
    let stride = stride(problem, half);
    let mut swings = FIRST;
    let mut best: Option<Minimum> = None;
    loop {
        let until = problem.times[0] + swings * half;
        let count = problem.times.partition_point(|&t| t <= until).max(FEWEST).min(problem.len());
        let stride = stride.min((count / 24).max(1));
        let mut part = problem.part(count, stride);
        let from = best.map_or(starts.to_vec(), |best| vec![best.at]);
        let ends = from
            .iter()
            .filter_map(|start| minimise(&mut part, start, free, ending, Effort::COARSE))
            .min_by(|a, b| a.normal.cost.total_cmp(&b.normal.cost));
        problem.evaluations += part.evaluations;
        best = ends.or(best);
        if count == problem.len() || best.is_none() {
            return best;
        }
        swings *= GROWTH;
    }
}
