//! A method on its way, with a limit to its steps.

use crate::error::{Error, Result};
use crate::oscillator::State;
use crate::scheme::{Integration, Scheme, Setting};

/// Most steps that a method takes here before it is given up.
pub const MOST_STEPS: u64 = 10_000_000;

/// Most steps of a method that chooses them itself: where dry friction has stopped the mass they can shrink
/// without end.
const MOST_CHOSEN_STEPS: u64 = 1_000_000;

/// A method on its way through a motion, step after step.
pub struct Course {
    integration: Box<dyn Integration>,
    steps: u64,
    limit: u64,
    /// A position beyond this has run away, m.
    farthest: f64,
    time_step: f64,
    adaptive: bool,
}

/// Amplitudes that a method may be away from the middle. No motion goes beyond one, and what is so far off is no motion.
const FARTHEST: f64 = 1e3;

impl Course {
    /// The method at the release.
    ///
    /// # Errors
    /// As [`Scheme::start`].
    pub fn new(scheme: &Scheme, setting: &Setting) -> Result<Self> {
        let limit = if scheme.adaptive { MOST_CHOSEN_STEPS } else { MOST_STEPS };
        Ok(Course {
            integration: scheme.start(setting)?,
            steps: 0,
            limit,
            farthest: FARTHEST * setting.amplitude(),
            time_step: setting.time_step(),
            adaptive: scheme.adaptive,
        })
    }

    /// Refuses more steps to `time` (s) than are taken before the first of them is.
    ///
    /// # Errors
    /// [`Error::TooManySteps`]; never for a method that chooses its steps.
    pub fn check(&self, time: f64) -> Result<()> {
        let (time_step, steps, limit) = (self.time_step, time / self.time_step, self.limit);
        if self.adaptive || steps <= limit as f64 {
            Ok(())
        } else {
            Err(Error::TooManySteps { time, time_step, steps, limit })
        }
    }

    /// Steps taken so far.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The time reached, s, and the state there.
    pub fn now(&self) -> (f64, State) {
        (self.integration.time(), self.integration.state())
    }

    /// Takes a step.
    ///
    /// # Errors
    /// As [`Integration::step`]; [`Error::Diverged`] also where the position has left a thousand amplitudes behind;
    /// [`Error::StepLimit`] after [`MOST_STEPS`], or a million steps that the method chose itself.
    pub fn step(&mut self) -> Result<()> {
        if self.steps >= self.limit {
            return Err(Error::StepLimit { time: self.integration.time(), limit: self.limit });
        }
        self.steps += 1;
        self.integration.step()?;
        let (time, State { position, .. }) = self.now();
        if position.abs() > self.farthest {
            return Err(Error::Diverged { time_step: self.time_step, time });
        }
        Ok(())
    }

    /// The state at `time` (s), which must not lie before the last step.
    ///
    /// # Errors
    /// As [`Course::step`].
    pub fn at(&mut self, time: f64) -> Result<State> {
        while self.integration.time() < time {
            self.step()?;
        }
        Ok(self.integration.within(time))
    }
}
