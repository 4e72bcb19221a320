//! A sensor that clips: it says the same largest value at several turns, and beyond that nothing.

use crate::extremes::{bounds, median};
use crate::window::{Edge, Found, Window, find};
use crate::{Options, Recording};

/// Where the sensor clips the swings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clipping {
    /// The lowest value, if the swings stop there.
    pub low: Option<f64>,
    /// The highest, if they stop there.
    pub high: Option<f64>,
    /// At so many turns.
    pub turns: usize,
    /// The time after the last of them, s.
    pub until: f64,
    /// Whether enough swings follow to fit those alone.
    pub enough: bool,
    /// Whether those alone were fitted.
    pub left_out: bool,
}

/// At so many turns with so many equal values
const TURNS: usize = 2;
const EQUAL: usize = 3;
/// that are so many times as many as at other turns the sensor clips: those of a coarse one are the fewer the wider the
/// swing.
const BEYOND_OTHERS: f64 = 2.5;
/// Where there are not so many others
const OTHERS: usize = 3;
/// so many times as many as just beside: a coarse sensor has at most five times as many at a turn as one step below.
const BEYOND_BESIDE: f64 = 8.0;
/// A swing to one side counts if it leaves the middle by this share of the range.
const LEAVES: f64 = 0.1;
/// So many turns have to follow: five swings.
const FOLLOW: usize = 6;

/// A stretch of values on one side of the middle.
#[derive(Debug, Clone, Copy)]
struct Side {
    /// Its farthest value.
    value: f64,
    /// How often in a row it stands there.
    equal: usize,
    /// How often the values before and after that stand in a row.
    beside: usize,
    /// The index after the stretch.
    end: usize,
}

/// How a sensor clips `values`, if it does.
pub fn clipping(times: &[f64], values: &[f64]) -> Option<Clipping> {
    let (low, high) = bounds(values);
    let sides = sides(values, (low + high) / 2.0, LEAVES * (high - low));
    let at = |level: f64| sides.iter().filter(move |side| side.value == level);
    let others: Vec<&Side> =
        sides.iter().filter(|side| side.value != low && side.value != high).collect();
    let usual = median_of(others.iter().map(|side| side.equal)).unwrap_or(1.0);
    let clips = |level: f64| {
        let equal = median_of(at(level).map(|side| side.equal)).unwrap_or(0.0);
        let beside = median_of(at(level).map(|side| side.beside)).unwrap_or(1.0);
        let least =
            if others.len() < OTHERS { BEYOND_BESIDE * beside } else { BEYOND_OTHERS * usual };
        at(level).count() >= TURNS && equal >= EQUAL as f64 && equal >= least
    };
    let [low, high] = [low, high].map(|level| Some(level).filter(|&level| clips(level)));
    let clipped = |side: &Side| Some(side.value) == low || Some(side.value) == high;
    let last = sides.iter().rposition(clipped)?;
    Some(Clipping {
        low,
        high,
        turns: sides.iter().filter(|side| clipped(side)).count(),
        until: times[sides[last].end.min(times.len() - 1)],
        enough: sides.len() - 1 - last >= FOLLOW,
        left_out: false,
    })
}

/// The window of `recording`, which holds all values or their means, after the swings that the sensor clipped if enough
/// follow.
pub(crate) fn unclipped(
    all: &Recording,
    recording: &Recording,
    options: &Options,
) -> (Found, Option<Clipping>) {
    let found = find(recording, options.from, options.to);
    let Window { from, to, .. } = found.window;
    let index = |time: f64| all.times.partition_point(|&t| t < time);
    let part = index(from)..index(to);
    let clipped = clipping(&all.times[part.clone()], &all.values[part]);
    let Some(clipping) = clipped.filter(|clipping| clipping.enough && options.from.is_none())
    else {
        return (found, clipped);
    };
    let mut found = find(recording, Some(clipping.until), options.to);
    found.window.begins = Edge::Clipped;
    (found, Some(Clipping { left_out: true, ..clipping }))
}

/// The median of numbers of values.
fn median_of(numbers: impl Iterator<Item = usize>) -> Option<f64> {
    median(&mut numbers.map(|number| number as f64).collect::<Vec<_>>())
}

/// The stretches on alternating sides of the middle that leave it by `least`.
fn sides(values: &[f64], middle: f64, least: f64) -> Vec<Side> {
    let mut sides: Vec<Side> = Vec::new();
    let (mut first, mut way) = (0, 0.0);
    for end in 1..=values.len() {
        // It ends where the other side begins: what only touches the middle is no turn.
        let next = values.get(end).map(|value| value - middle);
        let here = values[end - 1] - middle;
        if here.abs() > least {
            way = here.signum();
        }
        let over = next.is_none_or(|next| next.abs() > least && next.signum() == -way);
        if over && way != 0.0 {
            sides.push(side(values, first, end, way));
            first = end;
        }
    }
    sides
}

/// The stretch from `first` to `end`, above the middle (`way` +1) or below (−1).
fn side(values: &[f64], first: usize, end: usize, way: f64) -> Side {
    let part = &values[first..end];
    let (low, high) = bounds(part);
    let value = if way > 0.0 { high } else { low };
    let runs: Vec<&[f64]> = part.chunk_by(|one, next| one == next).collect();
    let longest = |&i: &usize| runs[i].len();
    let at = (0..runs.len()).filter(|&i| runs[i][0] == value).max_by_key(longest).unwrap_or(0);
    let length = |i: Option<usize>| i.and_then(|i| runs.get(i)).map_or(1, |run| run.len());
    let beside = length(at.checked_sub(1)).max(length(at.checked_add(1)));
    Side { value, equal: runs[at].len(), beside, end }
}
