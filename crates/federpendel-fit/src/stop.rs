//! When dry friction ends the motion: refits for each number of turning points until then.
//!
//! The sum of squares jumps where the number changes, so no search by slopes finds it; with the
//! number given it is smooth.

use crate::least_squares::{Effort, Minimum, minimise, solve};
use crate::model::{Course, Stop, TurningPoint};
use crate::problem::{COULOMB, Ending, LAWS, OMEGA, Problem, Vector};

/// The best of the minima with the natural rule and with rest after each number of turning points
/// near `seen` and near what the natural rule gives; downhill in that number. Beside it the minima
/// with another rest that fit about as well.
pub fn search(
    problem: &mut Problem,
    start: &Minimum,
    free: &[bool; 7],
    seen: Option<u64>,
) -> Option<(Minimum, Vec<Minimum>)> {
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
    let mut all: Vec<Minimum> = Vec::new();
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
                all.push(found);
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
    let natural = minimise(problem, &best.at, free, Ending::Natural, Effort::FINE);
    let shown = natural.map_or(best, |natural| without_whim(problem, best, natural));
    all.extend(natural);
    Some((shown, beside(problem, &shown, &all, free)))
}

/// So many variances a rest that the natural rule does not give must lower the sum of squares by: noise
/// lowers it a little for one of several turning points tried.
const REST_SHOWS: f64 = 12.0;

/// `minimum`, or the `natural` one where the rest forced on the motion is not shown by the recording.
fn without_whim(problem: &mut Problem, minimum: Minimum, natural: Minimum) -> Minimum {
    let Stop::After(number) = minimum.ending.stop(&minimum.at) else { return minimum };
    let same = number_at_rest(problem, &natural) == Some(number);
    let shows = 1.0 + REST_SHOWS / problem.len() as f64;
    if !same && natural.normal.cost < shows * minimum.normal.cost { natural } else { minimum }
}

/// After how many turning points the mass rests, if it does.
fn number_at_rest(problem: &mut Problem, minimum: &Minimum) -> Option<u64> {
    let course = problem.course(&minimum.at, minimum.ending, false);
    course.and_then(|course| course.rest).map(|rest| rest.number)
}

/// So many variances above the shown minimum another number of swings until rest is kept: 95 % of noise
/// that counts ten times as much as white noise.
const BESIDE: f64 = 40.0;

/// The minima of `all` with another rest than `shown`, the lowest for each, that fit about as well.
fn beside(
    problem: &mut Problem,
    shown: &Minimum,
    all: &[Minimum],
    free: &[bool; 7],
) -> Vec<Minimum> {
    let mut numbers = vec![number_at_rest(problem, shown)];
    let limit = shown.normal.cost * (1.0 + BESIDE / problem.len() as f64);
    let mut near: Vec<&Minimum> = all.iter().filter(|found| found.normal.cost < limit).collect();
    near.sort_by(|a, b| a.normal.cost.total_cmp(&b.normal.cost));
    let mut kept = Vec::new();
    for found in near {
        let fine = minimise(problem, &found.at, free, found.ending, Effort::FINE);
        let Some(fine) = fine else { continue };
        let number = number_at_rest(problem, &fine);
        if !numbers.contains(&number) {
            numbers.push(number);
            kept.push(fine);
        }
    }
    kept
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
    /// The earliest and the latest time at which it may have come to rest as well, s; the latest is none where it
    /// may have gone on to the end of the window.
    pub between: (f64, Option<f64>),
    /// How many turning points it took from the beginning of the window, the rest among them.
    pub turning_points: u64,
    /// μ_s F_N/m lies between these, as far as noise tells: the mass held here, and not one turning point
    /// earlier (none: no earlier one is known).
    pub static_acceleration: (f64, Option<f64>),
    /// Whether the rest needs a static friction above the kinetic one.
    pub static_above_kinetic: bool,
    /// What is left to say where only one swing precedes it.
    pub early: Option<Early>,
}

/// What one swing before a rest tells of dry friction: its offset and the middle only together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Early {
    /// The least a_c.
    pub least_kinetic: f64,
    /// So much farther from the middle are positions with that than with the a_c of the fit.
    pub shift: f64,
    /// When the swing ends.
    time: f64,
}

impl Rest {
    /// This rest, or as well `other`; where that is none within the window, static friction is no less than
    /// this.
    pub(crate) fn or(self, other: Result<Rest, f64>) -> Self {
        let (low, high) = self.static_acceleration;
        let other = match other {
            Ok(other) => other,
            Err(least) => {
                let static_acceleration = (low.min(least), high);
                let between = (self.between.0, None);
                return Self { static_acceleration, between, static_above_kinetic: false, ..self };
            }
        };
        let latest = self.between.1.zip(other.between.1).map(|(one, other)| one.max(other));
        let (other_low, other_high) = other.static_acceleration;
        Self {
            between: (self.between.0.min(other.between.0), latest),
            static_acceleration: (
                low.min(other_low),
                high.zip(other_high).map(|(one, other)| one.max(other)),
            ),
            static_above_kinetic: self.static_above_kinetic && other.static_above_kinetic,
            ..self
        }
    }
}

/// The rest of a fitted motion within the window, if there is one. `blur` is how far a position is unsure, in the
/// unit of a length, and `dry` how far the kinetic friction over mass is.
pub fn rest(problem: &mut Problem, minimum: &Minimum, (blur, dry): (f64, f64)) -> Option<Rest> {
    let p = &minimum.at;
    let course = problem.course(p, minimum.ending, false)?;
    let rest = course.rest?;
    let force = |distance: f64| p[OMEGA] * p[OMEGA] * distance.max(0.0);
    let (_, earlier) = course.turning_points.split_last()?;
    let early = early(&course, minimum, blur);
    let time = early.map_or(rest.time, |early| early.time);
    // A swing that noise hides may not have been one: the mass has moved on from farther away for sure.
    let moved_on = |position: f64| (position - rest.position).abs() > blur;
    let before = earlier.iter().rev().find(|point| moved_on(point.position));
    let distance = rest.position.abs();
    Some(Rest {
        time,
        between: (time, Some(time)),
        position: rest.position + early.map_or(0.0, |early| early.shift),
        turning_points: rest.number,
        static_acceleration: match early {
            Some(early) => (early.least_kinetic, None),
            None => (
                force(distance - blur).max(p[COULOMB] - dry).max(0.0),
                before.map(|point| force(point.position.abs() + blur)),
            ),
        },
        static_above_kinetic: force(distance) > p[COULOMB],
        early,
    })
}

/// What is left to say where only one swing precedes the rest.
///
/// A swing goes around its own middle, which lies f = a_c/ω0² from that of the spring. A place of rest so tells its
/// distance A from that middle alone; with static friction as large as the kinetic one the mass stays where A ≤ 2f.
fn early(course: &Course, minimum: &Minimum, blur: f64) -> Option<Early> {
    let p = &minimum.at;
    let mut from = p[4];
    let moved = |point: &&TurningPoint| {
        let moved = (point.position - from).abs() > blur;
        from = if moved { point.position } else { from };
        moved
    };
    let swings: Vec<&TurningPoint> = course.turning_points.iter().filter(moved).collect();
    let [swing] = swings[..] else { return None };
    let square = p[OMEGA] * p[OMEGA];
    let (way, offset) = ((swing.position - p[4]).signum(), p[COULOMB] / square);
    let least = (way * swing.position + offset - blur).max(0.0) / 2.0;
    let shift = way * (offset - least);
    Some(Early { least_kinetic: square * least, shift, time: swing.time })
}
