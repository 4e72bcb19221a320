//! Any method with located reversals and true sticking.
//!
//! Within a swing friction keeps its direction, so that the method sees a smooth force. Where its velocity
//! changes sign within a step the time of that is found on the method's own path, the step is cut there, and
//! it is decided whether the mass sticks or turns. Two reversals within one step are both found, unless the
//! velocity has its old sign again at the end of the step.

use super::equation::{Directed, Equation, Field};
use super::integration::{Clock, Integration, finite};
use super::stepper::{Path, Stepper};
use crate::error::{Error, Result};
use crate::oscillator::State;

/// Halvings in search of a time at which the mass moves forward, and then of the time at which it stops: more than an
/// interval has room for.
const HALVINGS: u32 = 200;

/// Reversals within one step; where there are more the step is no step.
const MOST_PARTS: usize = 10_000;

/// A method that turns and sticks where it ought to.
pub struct Located<S: Stepper<Directed>> {
    equation: Equation,
    stepper: S,
    clock: Clock,
    state: State,
    /// Direction of motion; 0 at rest.
    direction: f64,
    /// The parts of the last step, in order.
    parts: Vec<Part<S::Path>>,
}

/// Part of a step, within which the direction is one.
struct Part<P> {
    start: f64,
    from: State,
    /// None at rest.
    path: Option<P>,
}

impl<S: Stepper<Directed>> Located<S> {
    /// From `release` on.
    pub fn new(equation: Equation, stepper: S, release: State) -> Self {
        let mut located = Located {
            equation,
            stepper,
            clock: Clock::default(),
            state: release,
            direction: release.velocity.signum(),
            parts: Vec::new(),
        };
        if release.velocity == 0.0 {
            located.turn();
        }
        located
    }

    /// Decides what happens where the velocity is zero.
    fn turn(&mut self) {
        let position = self.state.position;
        self.state.velocity = 0.0;
        let towards = -position.signum();
        let pulled = towards * Directed(self.equation, towards).acceleration(self.state) > 0.0;
        let holds = position == 0.0 || self.equation.holds(position) || !pulled;
        self.direction = if holds { 0.0 } else { towards };
    }

    /// Goes on to the end of a path or to its reversal, and returns how long that took.
    fn follow(&mut self, path: S::Path) -> Result<f64> {
        let start = self.clock.time();
        let end = path.at(path.duration());
        let reversal =
            (self.direction * end.velocity <= 0.0).then(|| reversal(&path, self.direction));
        let (after, state) = match reversal {
            Some(after) => (after, path.at(after)),
            None => (path.duration(), end),
        };
        self.clock.advance(after);
        self.parts.push(Part { start, from: self.state, path: Some(path) });
        self.state = finite(state, after, self.clock.time())?;
        if reversal.is_some() {
            self.turn();
        }
        Ok(after)
    }
}

/// When the velocity along `path` falls to zero; next to nothing if it never has `direction` at all.
fn reversal(path: &impl Path, direction: f64) -> f64 {
    let forward = |after: f64| direction * path.at(after).velocity > 0.0;
    // From a turning point the velocity rises from zero: somewhere in front it is positive.
    let mut high = path.duration();
    let mut low = 0.5 * high;
    for _ in 0..HALVINGS {
        if forward(low) {
            break;
        }
        (high, low) = (low, 0.5 * low);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if forward(middle) { low = middle } else { high = middle }
    }
    high
}

impl<S: Stepper<Directed>> Integration for Located<S> {
    fn step(&mut self) -> Result<()> {
        self.parts.clear();
        let mut rest = self.stepper.time_step().unwrap_or(f64::INFINITY);
        loop {
            if self.direction == 0.0 {
                self.parts.push(Part { start: self.clock.time(), from: self.state, path: None });
                self.clock.advance(rest);
                return Ok(());
            }
            let field = Directed(self.equation, self.direction);
            let path = self.stepper.advance(&field, self.clock.time(), self.state, rest)?;
            let duration = self.follow(path)?;
            if self.parts.len() > MOST_PARTS {
                let limit = MOST_PARTS as u64;
                return Err(Error::StepLimit { time: self.clock.time(), limit });
            }
            // A method that chooses its steps ends this one here.
            if rest.is_infinite() || duration >= rest {
                return Ok(());
            }
            rest -= duration;
        }
    }

    fn time(&self) -> f64 {
        self.clock.time()
    }

    fn state(&self) -> State {
        self.state
    }

    fn within(&self, time: f64) -> State {
        let later = self.parts.partition_point(|part| part.start <= time);
        let part = later.checked_sub(1).and_then(|index| self.parts.get(index));
        match part {
            Some(part) if time < self.clock.time() => match &part.path {
                Some(path) => path.at((time - part.start).min(path.duration())),
                None => part.from,
            },
            _ => self.state,
        }
    }
}
