//! Minima between the jumps of an acceleration.
//!
//! Dry friction makes the acceleration jump by 2a_c at every turning point. A value recorded close
//! to one changes sides as the parameters move, and the sum of squares jumps: it has many small
//! minima around the lowest. With the jumps spread over some values it is smooth; its minimum shows
//! the way.

use crate::Quantity;
use crate::least_squares::{Effort, Minimum, minimise};
use crate::model::Course;
use crate::problem::{COULOMB, Ending, OMEGA, POSITION, Problem, VELOCITY, Vector};

/// The lowest minimum found around `minimum`, where the recording has such jumps; only the nearest
/// if not `thoroughly`.
pub fn settle(
    problem: &mut Problem,
    minimum: Minimum,
    free: &[bool; 7],
    thoroughly: bool,
) -> Minimum {
    let Some(spread) = problem.spread.take() else { return minimum };
    let hard = |problem: &mut Problem, at: &Vector, effort: Effort| {
        problem.spread = None;
        minimise(problem, at, free, minimum.ending, effort)
    };
    let mut at = minimum.at;
    let mut best = hard(problem, &at, Effort::COARSE);
    // Ever steeper: where the lowest minimum lies at the very edge of where a value changes sides,
    // none of the searches with sharp jumps could slide along that edge.
    let steeper: &[f64] = if thoroughly { &[3.0, 1.0, 0.3, 0.1, 0.03, 0.01] } else { &[] };
    for share in steeper {
        problem.spread = Some(share * spread);
        at = minimise(problem, &at, free, minimum.ending, Effort::COARSE)
            .map_or(at, |found| found.at);
        let found = hard(problem, &at, BRIEF);
        best = match (best, found) {
            (Some(best), Some(found)) if found.normal.cost < best.normal.cost => Some(found),
            (best, found) => best.or(found),
        };
    }
    let mut best = best.and_then(|best| hard(problem, &best.at, Effort::FINE)).unwrap_or(minimum);
    problem.spread = None;
    if thoroughly {
        let lower = |found: &Minimum, than: &Minimum| found.normal.cost < than.normal.cost;
        let held = released_at_rest(problem, &best, free).filter(|found| lower(found, &best));
        best = held.unwrap_or(best);
    }
    problem.spread = Some(spread);
    best
}

/// A velocity at the beginning that is so small a share of the swing's is that of a release at rest.
const AT_REST: f64 = 1e-3;

/// The minimum next to one of a release at rest, found with that held: where the first velocity changes its sign
/// dry friction does too, and all values up to the first turn jump.
fn released_at_rest(problem: &mut Problem, from: &Minimum, free: &[bool; 7]) -> Option<Minimum> {
    let mut at = from.at;
    if at[VELOCITY].abs() > AT_REST * at[OMEGA] * at[POSITION].abs() {
        return None;
    }
    at[VELOCITY] = 0.0;
    let mut held = *free;
    held[VELOCITY] = false;
    minimise(problem, &at, &held, from.ending, Effort::FINE)
}

const BRIEF: Effort = Effort { steps: 3, gain: 1e-1 };

/// A value of the model whose jump is spread: value and derivatives as they were and as they are
/// now.
pub struct Change {
    /// Which value.
    pub index: usize,
    /// As it was.
    pub was: (f64, Vector),
    /// As it is.
    pub is: (f64, Vector),
}

/// The values within `half` seconds of a jump, with the jump spread evenly over that time to both
/// sides. Leaves the model and derivatives of the problem at `p`.
pub fn spread(problem: &mut Problem, p: &Vector, ending: Ending, half: f64) -> Option<Vec<Change>> {
    // v = 0 at the jump: with the parameters it moves by −(∂v/∂θ)/a.
    let quantity = std::mem::replace(&mut problem.quantity, Quantity::Velocity);
    let course = problem.course(p, ending, true);
    problem.quantity = quantity;
    let jumps = jumps(problem, p, &course?, half);
    let rows: Vec<Vector> = jumps.iter().map(|jump| problem.row(jump.moves_as).1).collect();
    problem.course(p, ending, true)?;
    let changed = |(jump, mut row): (&Jump, Vector)| {
        let was = problem.row(jump.index);
        let share = jump.share - f64::from(u8::from(jump.over));
        let mut is = (was.0 + jump.height * share, was.1);
        is.1[COULOMB] += 2.0 * jump.side * share;
        row[6] = 0.0;
        if jump.slope != 0.0 {
            is.1 += row * (jump.height / (2.0 * half) / jump.slope);
        }
        Change { index: jump.index, was, is }
    };
    Some(jumps.iter().zip(rows).map(changed).collect())
}

/// A value close to a jump.
struct Jump {
    /// Which value.
    index: usize,
    /// How far through the spread jump its time is, from 0 to 1.
    share: f64,
    /// Whether it is behind the jump.
    over: bool,
    /// The acceleration after the jump, less that before.
    height: f64,
    /// The acceleration where the value lies.
    slope: f64,
    /// The direction of motion before the jump.
    side: f64,
    /// The value whose velocity tells how the jump moves: at rest that of one before.
    moves_as: usize,
}

/// The values within `half` seconds of the turning points.
fn jumps(problem: &Problem, p: &Vector, course: &Course, half: f64) -> Vec<Jump> {
    let mut found = Vec::new();
    let mut side = if p[5] == 0.0 { -p[4].signum() } else { p[5].signum() };
    for (number, point) in course.turning_points.iter().enumerate() {
        let spring = -p[OMEGA] * p[OMEGA] * point.position;
        let before = spring - side * p[COULOMB];
        let rests = course.rest.is_some() && number + 1 == course.turning_points.len();
        let after = if rests { 0.0 } else { spring + side * p[COULOMB] };
        let first = problem.times.partition_point(|&t| t < point.time - half);
        let end = problem.times.partition_point(|&t| t < point.time + half);
        for index in first..end {
            let over = problem.times[index] >= point.time;
            found.push(Jump {
                index,
                share: (problem.times[index] - point.time + half) / (2.0 * half),
                over,
                height: after - before,
                slope: if over && !rests { after } else { before },
                side,
                moves_as: if rests { first.saturating_sub(1) } else { index },
            });
        }
        side = -side;
    }
    found
}
