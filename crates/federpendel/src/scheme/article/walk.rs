//! The scheme at rising times, one after the other, so that a long run can be interrupted.

use super::terms::Pair;
use super::{MAX_STEPS, Scheme};
use crate::error::{Error, Result};
use crate::motion::Sample;
use crate::parameter;

/// Follows a [`Scheme`] through rising times. What it says does not depend on where it has stopped.
///
/// ```
/// # use federpendel::{Friction, Oscillator, State, scheme::article::Scheme};
/// let oscillator = Oscillator::new(1.0, 1.0, Friction::NONE)?;
/// let scheme = Scheme::new(&oscillator, State::new(1.0, 0.0)?, 0.1)?;
/// let mut walk = scheme.walk();
/// walk.advance(3.0)?;
/// assert_eq!([walk.sample(7.0)?], scheme.sample(&[7.0])?.samples[..]);
/// # Ok::<(), federpendel::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Walk {
    scheme: Scheme,
    /// At least 1: the release is known without its pair.
    index: u64,
    pair: Pair,
    time: f64,
    interpolated: bool,
}

impl Scheme {
    /// A walk along this scheme, beginning at the release.
    pub fn walk(&self) -> Walk {
        Walk { scheme: *self, index: 1, pair: self.start(), time: 0.0, interpolated: false }
    }
}

impl Walk {
    /// Takes all steps until `time` (s), which must not lie before the last one asked for.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a time that is negative, NaN or infinite; [`Error::Order`] for one
    /// that lies before the last; [`Error::TooManySteps`] for one beyond [`MAX_STEPS`];
    /// [`Error::Diverged`] if the scheme diverges until then.
    pub fn advance(&mut self, time: f64) -> Result<()> {
        self.go(time).map(|_| ())
    }

    /// The scheme at `time` (s), as [`Scheme::sample`] gives it.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn sample(&mut self, time: f64) -> Result<Sample> {
        let (below, fraction) = self.go(time)?;
        let mut step = self.scheme.step(below, self.pair)?;
        if fraction > 0.0 {
            let next = if below == 0 { self.pair } else { self.scheme.next(self.pair) };
            step = step.towards(self.scheme.step(below + 1, next)?, fraction);
            self.interpolated = true;
        }
        Ok(step.sample(time))
    }

    /// Whether a sample so far lay between two steps, so that it was interpolated.
    pub fn interpolated(&self) -> bool {
        self.interpolated
    }

    /// Goes to the step at or below `time`; that step, and how far beyond it the time lies.
    fn go(&mut self, time: f64) -> Result<(u64, f64)> {
        parameter::TIME.check(time)?;
        self.scheme.check_steps(time, time * self.scheme.terms.per_step, MAX_STEPS)?;
        if time < self.time {
            return Err(Error::Order { name: "times", value: time, before: self.time });
        }
        self.time = time;
        let (below, fraction) = self.scheme.grid_place(time);
        if below > self.index {
            self.pair = self.scheme.follow(self.index, self.pair, below)?;
            self.index = below;
        }
        Ok((below, fraction))
    }
}
