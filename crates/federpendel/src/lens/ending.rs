//! Whether a method lets the mass rest.

use std::f64::consts::PI;

use super::Course;
use crate::error::Result;
use crate::motion::Motion;
use crate::outcome::Outcome;
use crate::scheme::{Scheme, Setting};

/// What a method does after the mass has come to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ending {
    /// Whether it rests there too: no velocity, and no change of place.
    pub sticks: bool,
    /// How fast its place changes on average, m/s; zero if it sticks, none if it goes about in more than half of the
    /// sticking band: then it still swings.
    pub creep: Option<f64>,
}

/// Undamped periods after rest in which a method may still settle, and in which it is watched then.
const SETTLING: f64 = 1.0;
const WATCHED: f64 = 1.0;

/// Watches `scheme` in the second undamped period after the rest of `motion`; `None` if that never rests,
/// or only after more steps than are taken.
///
/// # Errors
/// What makes the method fail until then.
pub fn ending(motion: &Motion, scheme: &Scheme, setting: &Setting) -> Result<Option<Ending>> {
    let Outcome::Rests(rest) = motion.outcome() else { return Ok(None) };
    let period = 2.0 * PI / motion.oscillator().angular_frequency();
    let mut course = Course::new(scheme, setting)?;
    let from = rest.time + SETTLING * period;
    let until = from + WATCHED * period;
    if course.check(until).is_err() {
        return Ok(None);
    }
    let first = course.at(from)?;
    let mut still = first.velocity == 0.0;
    let (mut low, mut high) = (first.position, first.position);
    while course.now().0 < until {
        course.step()?;
        let state = course.now().1;
        still &= state.velocity == 0.0 && state.position == first.position;
        (low, high) = (low.min(state.position), high.max(state.position));
    }
    let (time, last) = course.now();
    let creep = (last.position - first.position).abs() / (time - from);
    let swings = high - low > motion.oscillator().sticking_offset();
    Ok(Some(Ending { sticks: still, creep: (!swings).then_some(if still { 0.0 } else { creep }) }))
}
