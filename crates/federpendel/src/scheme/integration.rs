//! A method on its way: step after step, with dry friction as its field has it.

use super::stepper::{Path, Stepper};
use crate::error::{Error, Result};
use crate::oscillator::State;

/// A method on its way through a motion.
pub trait Integration {
    /// Takes one step.
    ///
    /// # Errors
    /// [`Error::Diverged`] when the numbers are no longer finite, [`Error::StepUnderflow`] when no step is short
    /// enough for the tolerance. Nothing of use follows then.
    fn step(&mut self) -> Result<()>;

    /// The time reached, s.
    fn time(&self) -> f64;

    /// The state there.
    fn state(&self) -> State;

    /// The state at a time (s) within the last step, as the method gives it.
    fn within(&self, time: f64) -> State;
}

/// A time that many steps add up to, with what rounding leaves out of every sum.
#[derive(Debug, Clone, Copy, Default)]
pub struct Clock {
    time: f64,
    rest: f64,
}

impl Clock {
    /// The time, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Goes on by `duration`, s.
    pub fn advance(&mut self, duration: f64) {
        // The sum by Knuth, whose error is exact.
        let step = duration + self.rest;
        let sum = self.time + step;
        let part = sum - self.time;
        self.rest = (self.time - (sum - part)) + (step - part);
        self.time = sum;
    }
}

/// Steps along a field, whatever happens on the way.
pub struct Plain<F, S: Stepper<F>> {
    field: F,
    stepper: S,
    clock: Clock,
    before: f64,
    state: State,
    path: Option<S::Path>,
}

impl<F, S: Stepper<F>> Plain<F, S> {
    /// From `release` on.
    pub fn new(field: F, stepper: S, release: State) -> Self {
        Plain { field, stepper, clock: Clock::default(), before: 0.0, state: release, path: None }
    }
}

impl<F, S: Stepper<F>> Integration for Plain<F, S> {
    fn step(&mut self) -> Result<()> {
        let time = self.clock.time();
        let path = self.stepper.advance(&self.field, time, self.state, f64::INFINITY)?;
        self.before = time;
        self.clock.advance(path.duration());
        self.state = finite(path.at(path.duration()), path.duration(), self.clock.time())?;
        self.path = Some(path);
        Ok(())
    }

    fn time(&self) -> f64 {
        self.clock.time()
    }

    fn state(&self) -> State {
        self.state
    }

    fn within(&self, time: f64) -> State {
        match &self.path {
            Some(path) if time < self.clock.time() => path.at(time - self.before),
            _ => self.state,
        }
    }
}

/// `state`, or the error that a step of `duration` to `time` diverged.
pub fn finite(state: State, duration: f64, time: f64) -> Result<State> {
    if state.position.is_finite() && state.velocity.is_finite() {
        Ok(state)
    } else {
        Err(Error::Diverged { time_step: duration, time })
    }
}
