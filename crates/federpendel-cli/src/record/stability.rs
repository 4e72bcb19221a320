//! Whether the step of a scheme was too long.

use federpendel::scheme::article::Scheme;
use federpendel::{Oscillator, State};

use super::{Record, Source};

/// Part of a step that is merely too coarse that is proposed instead.
const FINER: f64 = 0.1;

/// A step that makes a scheme run away from the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum TooLong {
    /// The scheme is unstable with it.
    Unstable {
        /// The step, s.
        time_step: f64,
        /// Below this it is stable, s.
        longest: f64,
        /// The step that is taken when none is given, or a shorter one that is stable, s.
        proposed: f64,
    },
    /// It is stable, but its error has become larger than the motion.
    Coarse {
        /// The step, s.
        time_step: f64,
        /// A finer one, s.
        proposed: f64,
    },
}

impl TooLong {
    /// What `time_step` is too long for; `None` below the limit of stability.
    pub(crate) fn unstable(
        oscillator: &Oscillator,
        release: State,
        time_step: f64,
    ) -> Option<Self> {
        let longest = Scheme::longest_stable_step(oscillator, release);
        let proposed = Scheme::default_time_step(oscillator).min(FINER * longest);
        (time_step >= longest).then_some(TooLong::Unstable { time_step, longest, proposed })
    }
}

impl Record {
    /// Whether the scheme has run away: farther from the motion than that ever is from the centre.
    pub(crate) fn too_long_step(&self) -> Option<TooLong> {
        let Source::Steps { time_step, .. } = self.other.as_ref()?.source else { return None };
        let reach = self.exact.iter().fold(0.0, |reach: f64, s| reach.max(s.position.abs()));
        let (_, distance) = self.largest_deviation()?;
        if distance <= reach {
            return None;
        }
        let (oscillator, release) = (self.motion.oscillator(), self.motion.release());
        let coarse = TooLong::Coarse { time_step, proposed: FINER * time_step };
        Some(TooLong::unstable(oscillator, release, time_step).unwrap_or(coarse))
    }
}
