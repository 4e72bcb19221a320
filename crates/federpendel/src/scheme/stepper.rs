//! Ways to go from one state to the next, and what lies between the two.

use super::equation::Field;
use crate::error::Result;
use crate::oscillator::State;

/// Goes on from a state along a field.
pub trait Stepper<F> {
    /// What lies between the ends of a step.
    type Path: Path;

    /// Duration of every step, s; `None` if the method chooses it.
    fn time_step(&self) -> Option<f64>;

    /// A step from `from` at `time` (s), not longer than `longest` (s).
    ///
    /// # Errors
    /// If no step can be taken.
    fn advance(&mut self, field: &F, time: f64, from: State, longest: f64) -> Result<Self::Path>;
}

/// The states from one end of a step to the other.
pub trait Path: Clone {
    /// Duration of the step, s.
    fn duration(&self) -> f64;

    /// The state so long (s) after its start.
    fn at(&self, after: f64) -> State;
}

/// A method whose every step depends on the state before it alone.
pub trait OneStep<F>: Clone {
    /// The state after `duration`, s.
    fn step(&self, field: &F, from: State, duration: f64) -> State;
}

/// Steps of one length with a [`OneStep`] method.
#[derive(Debug, Clone, Copy)]
pub struct Fixed<M> {
    /// The method.
    pub method: M,
    /// Duration of every step, s.
    pub time_step: f64,
}

impl<F: Clone, M: OneStep<F>> Stepper<F> for Fixed<M> {
    type Path = Shorter<M, F>;

    fn time_step(&self) -> Option<f64> {
        Some(self.time_step)
    }

    fn advance(&mut self, field: &F, _: f64, from: State, longest: f64) -> Result<Self::Path> {
        let duration = self.time_step.min(longest);
        let to = self.method.step(field, from, duration);
        Ok(Shorter { method: self.method.clone(), field: field.clone(), from, to, duration })
    }
}

/// Within a step the method's own shorter step: as good as the method itself.
#[derive(Debug, Clone)]
pub struct Shorter<M, F> {
    method: M,
    field: F,
    from: State,
    to: State,
    duration: f64,
}

impl<F: Clone, M: OneStep<F>> Path for Shorter<M, F> {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn at(&self, after: f64) -> State {
        if after == self.duration {
            self.to
        } else {
            self.method.step(&self.field, self.from, after)
        }
    }
}

/// x′ and x″ at a state.
#[inline]
pub fn slope(field: &impl Field, state: State) -> State {
    State { position: state.velocity, velocity: field.acceleration(state) }
}

/// `state` + `duration`·(c₁k₁ + c₂k₂ + …).
#[inline]
pub fn shifted<const N: usize>(
    state: State,
    duration: f64,
    slopes: &[State; N],
    c: &[f64; N],
) -> State {
    let sum = |part: fn(&State) -> f64| {
        slopes.iter().zip(c).fold(0.0, |sum, (slope, c)| sum + c * part(slope))
    };
    State {
        position: state.position + duration * sum(|slope| slope.position),
        velocity: state.velocity + duration * sum(|slope| slope.velocity),
    }
}
