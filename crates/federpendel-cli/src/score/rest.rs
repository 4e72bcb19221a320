//! What samples do where the mass rests.

use std::f64::consts::PI;

use federpendel::{Motion, Outcome};

use super::samples::Samples;

/// A solver may come to rest this much later than the mass, over the time until its rest …
const LATE: f64 = 0.04;

/// … but not later than this many undamped periods.
const LATEST: f64 = 1.0;

/// Positions that differ by no more than this, over the amplitude, are the same up to rounding.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// What the samples do after the rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AfterRest {
    /// When the mass comes to rest, s.
    pub time: f64,
    /// Where, m.
    pub position: f64,
    /// From when on the samples are watched, s.
    pub watched_from: f64,
    /// How many are watched.
    pub samples: usize,
    /// What they do; nothing is known from fewer than two times.
    pub found: Option<Found>,
}

/// How the samples that are watched move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    /// Whether they stand still.
    pub sticks: bool,
    /// How fast their place changes from the first to the last, m/s; zero if they stand still.
    pub creep: f64,
    /// Distance of the first place from the last, m.
    pub drift: f64,
    /// Distance of the farthest places, m.
    pub range: f64,
}

impl AfterRest {
    /// Watches `samples`, whose positions are compared with `scale`, after the rest of `motion`; none
    /// if that never rests.
    pub(super) fn of(motion: &Motion, samples: &Samples, scale: f64) -> Option<Self> {
        let Outcome::Rests(rest) = motion.outcome() else { return None };
        let period = 2.0 * PI / motion.oscillator().angular_frequency();
        let watched_from = rest.time + (LATE * rest.time).min(LATEST * period);
        let mut watched: Vec<(f64, f64)> = samples
            .times
            .iter()
            .copied()
            .zip(samples.positions.iter().copied())
            .filter(|(time, _)| *time >= watched_from)
            .collect();
        watched.sort_by(|a, b| a.0.total_cmp(&b.0));
        Some(AfterRest {
            time: rest.time,
            position: rest.position,
            watched_from,
            samples: watched.len(),
            found: found(&watched, scale),
        })
    }
}

/// How (time, position) move, times rising.
fn found(watched: &[(f64, f64)], scale: f64) -> Option<Found> {
    let (first, last) = (watched.first()?, watched.last()?);
    let span = last.0 - first.0;
    if span <= 0.0 {
        return None;
    }
    let places = || watched.iter().map(|(_, position)| *position);
    let range = places().fold(f64::MIN, f64::max) - places().fold(f64::MAX, f64::min);
    let sticks = range <= ROUNDING * scale;
    let drift = (last.1 - first.1).abs();
    let creep = if sticks { 0.0 } else { drift / span };
    Some(Found { sticks, creep, drift, range })
}
