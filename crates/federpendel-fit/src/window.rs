//! Which part of a recording is a free decay.

use crate::check::FEWEST;
use crate::extremes::{Extreme, Look, bounds, look, median};
use crate::held::held;
use crate::stopped::decay;
use crate::{Quantity, Recording};

/// Why a window begins or ends where it does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Edge {
    /// The recording does.
    Recording,
    /// It was asked for.
    Given,
    /// Before this the mass was held, or lay still.
    Held,
    /// Before this something else moved the mass: its swings were growing.
    Driven,
    /// The first values do not belong to the motion that follows.
    Misfit,
    /// After this nothing moves: longer rest would tell nothing more.
    Still,
    /// After this something else moves the mass.
    Disturbed,
    /// After this swings no longer shrink: something else keeps the mass in motion, as the ground
    /// does.
    Unrest,
    /// After this a hand or the like stopped the mass.
    Stopped,
    /// Before this the sensor clipped the swings.
    Clipped,
}

/// The part of a recording that is fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// Index of its first value.
    pub first: usize,
    /// Index after its last.
    pub end: usize,
    /// Time of its first value, s.
    pub from: f64,
    /// Time of its last, s.
    pub to: f64,
    /// Why it begins there.
    pub begins: Edge,
    /// Why it ends there.
    pub ends: Edge,
}

impl Window {
    /// The window between two indices.
    pub fn between(times: &[f64], first: usize, end: usize, begins: Edge, ends: Edge) -> Self {
        Self { first, end, from: times[first], to: times[end - 1], begins, ends }
    }
}

/// A window and what a first look at it found.
#[derive(Debug, Clone)]
pub struct Found {
    /// The window.
    pub window: Window,
    /// Its extremes and noise; none if it turns too seldom.
    pub look: Option<Look>,
}

/// The window of `recording`, with its edges from `from` and `to` where given.
pub fn find(recording: &Recording, from: Option<f64>, to: Option<f64>) -> Found {
    let times = &recording.times;
    let given = |given: Option<f64>| if given.is_some() { Edge::Given } else { Edge::Recording };
    let first = from.map_or(0, |from| times.partition_point(|&t| t < from));
    let end = to.map_or(times.len(), |to| times.partition_point(|&t| t <= to)).max(first + 1);
    let mut window = Window::between(times, first.min(end - 1), end, given(from), given(to));
    let seen = |window: &Window| {
        let part = window.first..window.end;
        look(&times[part.clone()], &recording.values[part])
    };
    let given = window.first..window.end;
    let mut held = held(&times[given.clone()], &recording.values[given]).filter(|_| from.is_none());
    if let Some(plateau) = held {
        window = Window::between(times, window.first + plateau.end, end, Edge::Held, window.ends);
    }
    let mut whole = seen(&window);
    let looked_at = window.first..window.end;
    let part = whole.as_ref().map(|look| decay(&times[looked_at.clone()], look));
    let part = part.unwrap_or_default();
    if let Some((last, edge)) = part.to.filter(|_| to.is_none()) {
        window = cut(times, window, last, edge);
    }
    if let Some(tried) = part.from.filter(|_| from.is_none()) {
        let first = times.partition_point(|&t| t < tried);
        window = Window::between(times, first, window.end, Edge::Held, window.ends);
        // It was held again, and the window begins within that.
        held = None;
    }
    if (window.first..window.end) != looked_at {
        whole = seen(&window);
    }
    let Window { first, end, begins, ends, .. } = window;
    if let Some(look) = &whole {
        if from.is_none() {
            let level = held.map(|plateau| plateau.level);
            let (start, edge) = start(&times[first..], look, level, recording.quantity);
            if edge != Edge::Recording {
                let first = times.partition_point(|&t| t < start).min(end - 1);
                window = Window::between(times, first, end, edge, window.ends);
            }
        }
        if to.is_none() {
            window = ended(&recording.times, window, look);
        }
    }
    // Too little would be left: rather the whole.
    if window.end - window.first < FEWEST {
        window = Window::between(times, first.min(end - 1), end, begins, ends);
    }
    let look =
        if window.end - window.first < end - first { seen(&window).or(whole) } else { whole };
    Found { window, look }
}

/// Of so many turns the first can be spared: the verdict warns of fewer than five swings.
const MANY: usize = 6;

/// When the free motion begins, and why then; `held` is the level where the mass was held until the first of `times`.
fn start(times: &[f64], look: &Look, held: Option<f64>, quantity: Quantity) -> (f64, Edge) {
    let widest = widest(&look.extremes);
    let still = still_until(times, look, widest);
    // Half a swing around a turn stays within 2 % of the width for a fifth of it at most.
    let lay_still = held.is_none() && still - times[0] > 0.3 * look.half;
    let moving = look.extremes.partition_point(|extreme| lay_still && extreme.time <= still);
    let extremes = &look.extremes[moving..];
    // Free swings only shrink: the decay begins with the first of the widest.
    let wide = |pair: &[Extreme]| (pair[1].value - pair[0].value).abs() >= 0.9 * widest;
    let first = extremes.windows(2).position(wide).unwrap_or(0);
    // A little later than an extreme, where nothing jumps.
    let after = |extreme: &Extreme| extreme.time + 0.1 * look.half;
    let level = held.unwrap_or(look.smooth[0]);
    let pushed = (level - middle(look, widest)).abs() < 0.25 * widest;
    // Velocity and acceleration begin from there where a mass is let go, too: if it is known when it set off and few
    // swings follow, the first is kept.
    let spare = held.is_none() || quantity == Quantity::Position || extremes.len() >= MANY;
    match extremes.get(first) {
        Some(extreme) if first > 0 => (after(extreme), Edge::Driven),
        _ if !lay_still && held.is_none() => (times[0], Edge::Recording),
        // From where it rests it was pushed: by its first turn that is over. So it looks, and no
        // more than a swing is lost, where a velocity or an acceleration was recorded.
        Some(next) if pushed && spare => (after(next), Edge::Held),
        _ if held.is_some() => (times[0], Edge::Held),
        _ => (still + 0.1 * look.half, Edge::Held),
    }
}

/// The widest swing between neighbouring extremes.
fn widest(extremes: &[Extreme]) -> f64 {
    extremes.windows(2).map(|pair| (pair[1].value - pair[0].value).abs()).fold(0.0, f64::max)
}

/// Where the recorded quantity ends up: its level at the end if it is still there, else the middle
/// between the last extremes.
fn middle(look: &Look, widest: f64) -> f64 {
    let end = &look.smooth[look.smooth.len() - look.smooth.len().div_ceil(5)..];
    let (low, high) = bounds(end);
    if high - low < 0.1 * widest {
        return (low + high) / 2.0;
    }
    let last = &look.extremes[look.extremes.len().saturating_sub(7)..];
    let mut middles: Vec<f64> = last.windows(2).map(|w| (w[0].value + w[1].value) / 2.0).collect();
    median(&mut middles).unwrap_or(look.smooth[0])
}

/// Until when the smoothed values stay where they begin.
fn still_until(times: &[f64], look: &Look, width: f64) -> f64 {
    let band = 0.02 * width + 4.0 * look.left;
    let until = look.smooth.iter().position(|value| (value - look.smooth[0]).abs() > band);
    // The smoothed values set off earlier by up to the reach of smoothing; half of that is made up for in
    // `start`.
    until.map_or(times[0], |i| times[i])
}

/// The window with its end where the decay does.
fn ended(times: &[f64], window: Window, look: &Look) -> Window {
    let extremes: Vec<&Extreme> =
        look.extremes.iter().filter(|e| e.time >= window.from - 0.1 * look.half).collect();
    let swings: Vec<f64> = extremes.windows(2).map(|w| (w[1].value - w[0].value).abs()).collect();
    let widest = swings.iter().copied().fold(0.0, f64::max);
    let gaps = gaps(times, look.half);
    let near_gap = |pair: &[&Extreme]| {
        let reach = GAP * look.half;
        gaps.iter().any(|gap| gap.1 > pair[0].time - reach && gap.0 < pair[1].time + reach)
    };
    let whole: Vec<bool> = extremes.windows(2).map(|pair| !near_gap(pair)).collect();
    let mut smallest = f64::INFINITY;
    for (i, &swing) in swings.iter().enumerate().skip(1) {
        if whole[i - 1] {
            smallest = smallest.min(swings[i - 1]);
        }
        if whole[i] && swing > 1.3 * smallest + 8.0 * look.left + 0.03 * widest {
            let stop = extremes[i].time - look.half;
            return cut(times, window, stop, Edge::Disturbed);
        }
    }
    if let Some(i) = unrest(&swings, widest) {
        return cut(times, window, extremes[i].time, Edge::Unrest);
    }
    let Some(last) = extremes.last() else { return window };
    let still = (3.0 * look.half).max(0.3 * (last.time - window.from));
    cut(times, window, last.time + still, Edge::Still)
}

/// Steps without values longer than this share of half a period hide turning points, and values beside them
/// look like some.
pub const GAP: f64 = 0.3;

/// Where longer steps begin and end.
fn gaps(times: &[f64], half: f64) -> Vec<(f64, f64)> {
    let long = |pair: &[f64]| (pair[1] - pair[0] > GAP * half).then(|| (pair[0], pair[1]));
    times.windows(2).filter_map(long).collect()
}

/// The first swing that is not clearly wider than those that go on at the end without shrinking.
fn unrest(swings: &[f64], widest: f64) -> Option<usize> {
    let n = swings.len();
    let usual = |from: usize, to: usize| median(&mut swings[from..to].to_vec());
    let (before, last) = (usual(n / 2, n - n / 4)?, usual(n - n / 4, n)?);
    let goes_on = last < 0.05 * widest && last > 0.7 * before;
    let reached = swings.iter().position(|&swing| swing < 2.0 * last)?;
    (n >= 12 && goes_on).then_some(reached)
}

fn cut(times: &[f64], window: Window, to: f64, edge: Edge) -> Window {
    let end = times.partition_point(|&t| t <= to);
    if end >= window.end || end <= window.first + 1 {
        return window;
    }
    Window::between(times, window.first, end, window.begins, edge)
}
