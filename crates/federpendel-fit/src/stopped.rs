//! A hand, or the like, that ends a decay: the swings fall as no friction makes them fall.
//!
//! Dry friction takes the same from every half swing and brings the mass to rest where the spring pulls less than static
//! friction holds: the swings before a rest are small beside what each loses. Swings that lose little and then, all of a
//! sudden, are gone, were stopped by something else.

use crate::extremes::{Extreme, Look, median};
use crate::window::{Edge, GAP};

/// So many swings, each much like the one before, are a decay.
const STEADY: usize = 8;
/// A swing is like the one before if it lasts about half a period
const LASTS: std::ops::RangeInclusive<f64> = 0.6..=1.5;
/// and is about as wide.
const AS_WIDE: std::ops::RangeInclusive<f64> = 0.6..=1.15;
/// Swings that lose more than this share each may come to rest by themselves: dry friction with a static one of at most
/// 2/0.07 times the kinetic one.
const LOSS: f64 = 0.07;
/// Swings that were stopped are less wide than this share of those before.
const GONE: f64 = 0.5;
/// A hand takes so many half periods at most: what is left after that is told from what was before.
const HAND: f64 = 3.5;
/// Wider swings than this many of the last are not those of the same decay.
const WIDER: f64 = 1.3;
/// So many half periods without a turn are none of a motion.
const PAUSE: f64 = 2.0;
/// So many swings are another decay, be it a try.
const TRY: usize = 4;
/// So many swings tell what is left: of more a free decay may have lost as much.
const SOON: usize = 3;
/// Widths this many standard deviations of noise apart differ.
const BEYOND_NOISE: f64 = 8.0;
/// Swings below this share of the widest tell too little.
const SMALL: f64 = 0.2;
/// Of swings above this share of the widest most are those of the mass.
const WIDE: f64 = 0.1;
/// Swings less than so many standard deviations of noise too.
const NOISY: f64 = 20.0;

/// Where a decay begins and ends that the whole recording goes beyond.
#[derive(Debug, Default)]
pub struct Part {
    /// When the mass was held before it, after another decay.
    pub from: Option<f64>,
    /// Its last time if something ended it, and what.
    pub to: Option<(f64, Edge)>,
}

/// Of the decays in a recording the last that is not much shorter than the longest: others may have been tries.
pub fn decay(times: &[f64], look: &Look) -> Part {
    let swings: Vec<f64> = look.extremes.windows(2).map(width).collect();
    let Some(half) = half(&look.extremes, &swings) else { return Part::default() };
    let runs = runs(look, half, &swings);
    let length = |run: &(usize, usize)| run.1 - run.0;
    let longest = runs.iter().map(length).max().unwrap_or(0);
    let chosen = runs.iter().rposition(|run| 2 * length(run) >= longest);
    let Some(chosen) = chosen.filter(|_| longest >= STEADY) else { return Part::default() };
    let decay = Decay { times, look, half, swings: &swings };
    let (from, to) = runs[chosen];
    Part { from: decay.held_before(&runs[..chosen], from), to: decay.broken_off(from, to) }
}

/// A recording and its swings.
struct Decay<'a> {
    times: &'a [f64],
    look: &'a Look,
    half: f64,
    swings: &'a [f64],
}

impl Decay<'_> {
    /// When the mass was held between the last of `tries` and swing `from`.
    fn held_before(&self, tries: &[(usize, usize)], from: usize) -> Option<f64> {
        let wide = GONE * self.swings[from];
        let swings = |run: &(usize, usize)| run.1 - run.0 >= TRY && self.swings[run.0] > wide;
        let tried = tries.iter().rfind(|run| swings(run))?.1;
        let held = (tried..from).rev().find(|&swing| self.pauses(swing))?;
        Some(self.look.extremes[held].time + 0.5 * self.half)
    }

    /// The last time of the swings `from` to `to`, and why then, if something broke them off.
    fn broken_off(&self, from: usize, to: usize) -> Option<(f64, Edge)> {
        if to - from < STEADY || !keeps_on(&self.swings[from..to], self.look.left) {
            return None;
        }
        let extremes = &self.look.extremes;
        let (last, turn) = (median(&mut self.swings[to - 3..to].to_vec())?, extremes[to].time);
        let settled = turn + HAND * self.half;
        let later = extremes.windows(2).filter(|pair| pair[0].time > settled);
        let mut later: Vec<f64> = later.map(width).collect();
        let widest = later.iter().copied().fold(0.0, f64::max);
        let end = self.times[self.times.len() - 1];
        let breaks = to < self.swings.len() || end > turn + PAUSE * self.half;
        later.truncate(SOON);
        let gone = median(&mut later).is_none_or(|usual| usual < GONE * last);
        let beyond_noise = BEYOND_NOISE * self.look.left;
        // Of values that stay any may look like a turn.
        let held = self.pauses(to) || self.pauses(to + 1);
        // The last turn may be the hand's already.
        (breaks && (gone || held || widest > WIDER * last + beyond_noise)).then(|| {
            let edge = if gone || held { Edge::Stopped } else { Edge::Disturbed };
            (extremes[to - 1].time, edge)
        })
    }

    /// Whether a swing lasts far too long, though values were recorded.
    fn pauses(&self, swing: usize) -> bool {
        let Some(pair) = self.look.extremes.get(swing..swing + 2) else { return false };
        let during = |&&[one, next]: &&[f64; 2]| next > pair[0].time && one < pair[1].time;
        let mut steps = self.times.array_windows().filter(during);
        pair[1].time - pair[0].time > PAUSE * self.half
            && steps.all(|[one, next]| next - one < GAP * self.half)
    }
}

/// Half a period, s, as most of the wider swings say: the widest may be those of the hand.
fn half(extremes: &[Extreme], swings: &[f64]) -> Option<f64> {
    let widest = swings.iter().copied().fold(0.0, f64::max);
    let wide = extremes.windows(2).zip(swings).filter(|(_, swing)| **swing > WIDE * widest);
    median(&mut wide.map(|(pair, _)| pair[1].time - pair[0].time).collect::<Vec<_>>())
}

fn width(pair: &[Extreme]) -> f64 {
    (pair[1].value - pair[0].value).abs()
}

/// The first and the end of every stretch of swings that are each like the one before.
fn runs(look: &Look, half: f64, swings: &[f64]) -> Vec<(usize, usize)> {
    let noise = BEYOND_NOISE * look.left;
    let lasts: Vec<bool> = look
        .extremes
        .windows(2)
        .map(|pair| LASTS.contains(&((pair[1].time - pair[0].time) / half)))
        .collect();
    let goes_on = |i: usize| {
        let (low, high) = (AS_WIDE.start() * swings[i - 1], AS_WIDE.end() * swings[i - 1]);
        lasts[i] && lasts[i - 1] && (low - noise..=high + noise).contains(&swings[i])
    };
    let mut runs = Vec::new();
    let mut from = 0;
    for i in 1..=swings.len() {
        if i == swings.len() || !goes_on(i) {
            runs.push((from, i));
            from = i;
        }
    }
    runs
}

/// Whether the last of these swings are wide and lose so little that they would have gone on.
fn keeps_on(swings: &[f64], noise: f64) -> bool {
    let of = STEADY / 2;
    // The last may be the hand's already.
    let end = swings.len() - 2;
    let (before, last) = (swings[end - of], swings[end]);
    let widest = swings.iter().copied().fold(0.0, f64::max);
    before - last < LOSS * of as f64 * last && last > SMALL * widest && last > NOISY * noise
}
