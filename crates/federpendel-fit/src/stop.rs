//! When dry friction ends the motion: refits for each number of turning points until then.
//!
//! The sum of squares jumps where the number changes, so no search by slopes finds it; with the
//! number given it is smooth.

use crate::least_squares::{Effort, Minimum, minimise, solve};
use crate::model::Stop;
use crate::problem::{COULOMB, Ending, LAWS, OMEGA, Problem, Vector};

/// The best of the minima with the natural rule and with rest after each number of turning points
/// near `seen` and near what the natural rule gives; downhill in that number.
pub fn search(
    problem: &mut Problem,
    start: &Minimum,
    free: &[bool; 7],
    seen: Option<u64>,
) -> Option<Minimum> {
    let mut best = minimise(problem, &start.at, free, start.ending, Effort::COARSE)?;
    let mut candidates = Vec::new();
    if let Ending::Turn { turn, near } = start.ending {
        candidates.push((turn, near));
    } else {
        let ending = |number| Ending::after(number, &best.at);
        // Its own rest, or the last turning point: the mass may hold there, too near the end to be
        // seen.
        let course = problem.course(&best.at, best.ending, false)?;
        let last = course.rest.map_or(course.turning_points.len() as u64, |rest| rest.number);
        let numbers = [last].into_iter().chain(seen).filter(|&number| number > 0);
        for number in numbers {
            if let Ending::Turn { turn, near } = ending(number) {
                candidates.push((turn, near));
            }
        }
    }
    candidates.dedup();
    let mut tried: Vec<i64> = Vec::new();
    for (mut turn, near) in candidates {
        // Downhill from each candidate, one turning point at a time.
        loop {
            let mut moved = false;
            for next in [turn, turn - 1, turn + 1, turn - 2, turn + 2] {
                if tried.contains(&next) || next < 1 {
                    continue;
                }
                tried.push(next);
                let ending = Ending::Turn { turn: next, near };
                let Some(start) = slack(problem, &best, free, ending) else { continue };
                let Some(found) = minimise(problem, &start, free, ending, BRIEF) else { continue };
                if found.normal.cost < best.normal.cost {
                    best = found;
                    moved = next != turn;
                    turn = next;
                }
            }
            if !moved {
                break;
            }
        }
    }
    let best = minimise(problem, &best.at, free, best.ending, Effort::FINE)?;
    Some(without_whim(problem, best, free))
}

/// So many variances a rest that the natural rule does not give must lower the sum of squares by: noise
/// lowers it a little for one of several turning points tried.
const REST_SHOWS: f64 = 12.0;

/// `minimum`, or that of the natural rule where the rest forced on the motion is not shown by the recording.
fn without_whim(problem: &mut Problem, minimum: Minimum, free: &[bool; 7]) -> Minimum {
    let Stop::After(number) = minimum.ending.stop(&minimum.at) else { return minimum };
    let found = minimise(problem, &minimum.at, free, Ending::Natural, Effort::FINE);
    let Some(natural) = found else { return minimum };
    let course = problem.course(&natural.at, natural.ending, false);
    let same = course.is_some_and(|course| course.rest.is_some_and(|rest| rest.number == number));
    let shows = 1.0 + REST_SHOWS / problem.len() as f64;
    if !same && natural.normal.cost < shows * minimum.normal.cost { natural } else { minimum }
}

/// `minimum`, or beside it, where the mass goes on to the end that `ending` says: kinetic friction
/// may hold it before that, and is lowered then, the other parameters following.
fn slack(
    problem: &mut Problem,
    minimum: &Minimum,
    free: &[bool; 7],
    ending: Ending,
) -> Option<Vector> {
    let mut held = *free;
    held[COULOMB] = false;
    for share in [0.0, 0.1, 0.25, 0.5, 0.75] {
        let mut moved = Vector::zeros();
        moved[COULOMB] = -share * minimum.at[COULOMB];
        let right = -(minimum.normal.information * moved);
        let mut start =
            minimum.at + moved + solve(&minimum.normal.information, &right, &held, 0.0)?;
        LAWS.iter().for_each(|&law| start[law] = start[law].max(0.0));
        let Stop::After(number) = ending.stop(&start) else { return Some(start) };
        let course = problem.course(&start, ending, false)?;
        if course.rest.is_none_or(|rest| rest.number >= number) {
            return Some(start);
        }
    }
    None
}

/// Steps enough to see which number is best.
const BRIEF: Effort = Effort { steps: 12, gain: 1e-1 };

/// Where and when the mass came to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// Time, s, on the clock of the recording.
    pub time: f64,
    /// Position from the middle, in the unit of a length of the recording.
    pub position: f64,
    /// How many turning points it took from the beginning of the window, the rest among them.
    pub turning_points: u64,
    /// μ_s F_N/m lies between these, as far as noise tells: the mass held here, and not one turning point
    /// earlier (none: no earlier one is known).
    pub static_acceleration: (f64, Option<f64>),
    /// Whether the rest needs a static friction above the kinetic one.
    pub static_above_kinetic: bool,
}

/// The rest of a fitted motion within the window, if there is one. `blur` is how far a position is unsure, in the
/// unit of a length, and `dry` how far the kinetic friction over mass is.
pub fn rest(problem: &mut Problem, minimum: &Minimum, (blur, dry): (f64, f64)) -> Option<Rest> {
    let p = &minimum.at;
    let course = problem.course(p, minimum.ending, false)?;
    let rest = course.rest?;
    let force = |distance: f64| p[OMEGA] * p[OMEGA] * distance.max(0.0);
    let (_, earlier) = course.turning_points.split_last()?;
    // A swing that noise hides may not have been one: the mass has moved on from farther away for sure.
    let moved_on = |position: f64| (position - rest.position).abs() > blur;
    let before = earlier.iter().rev().find(|point| moved_on(point.position));
    let distance = rest.position.abs();
    Some(Rest {
        time: rest.time,
        position: rest.position,
        turning_points: rest.number,
        static_acceleration: (
            force(distance - blur).max(p[COULOMB] - dry).max(0.0),
            before.map(|point| force(point.position.abs() + blur)),
        ),
        static_above_kinetic: force(distance) > p[COULOMB],
    })
}
