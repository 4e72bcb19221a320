//! What is found of one method beside the exact motion.

use crate::error::Result;
use crate::motion::Motion;
use crate::oscillator::State;
use crate::outcome::Outcome;
use crate::scheme::{Scheme, Setting};

use super::{Candidate, Course, Ending, Errors, Gauge, Ladder, ending, errors, ladder};

/// What was found of one method.
#[derive(Debug, Clone)]
pub struct Findings {
    /// How far it is from the exact motion: a numeric method on its own steps, a formula at the samples.
    pub errors: Errors,
    /// Its errors at six halvings of the step; empty for a formula.
    pub ladder: Ladder,
    /// Whether it lets the mass rest, if the mass does; `None` if it never does.
    pub sticks: Option<bool>,
    /// How fast its place changes after the rest, m/s; none where it still swings.
    pub creep: Option<f64>,
}

/// A rest that comes after more lengths of the record than this is not waited for.
const PATIENCE: f64 = 10.0;

impl Findings {
    /// Holds `candidate` beside `motion` up to the last of `times` (s), at which it has these `states`.
    ///
    /// # Errors
    /// Why the method fails.
    pub fn of(
        candidate: Candidate,
        motion: &Motion,
        (times, states): (&[f64], &[State]),
        setting: &Setting,
    ) -> Result<Self> {
        let duration = times.last().copied().unwrap_or(0.0);
        // A rest long after the record does not show in it.
        let waited_for =
            matches!(motion.outcome(), Outcome::Rests(rest) if rest.time <= PATIENCE * duration);
        match candidate {
            Candidate::Formula(_) => Self::formula(motion, times, states, waited_for),
            Candidate::Scheme(scheme) => {
                Self::scheme(scheme, motion, duration, setting, waited_for)
            }
        }
    }

    fn formula(motion: &Motion, times: &[f64], states: &[State], waited_for: bool) -> Result<Self> {
        let mut gauge = Gauge::new(motion);
        for (time, state) in times.iter().zip(states) {
            gauge.add(*time, *state)?;
        }
        // The formulas know no rest: they swing on.
        let sticks = waited_for.then_some(false);
        Ok(Self { errors: gauge.finish(0)?, ladder: Ladder::default(), sticks, creep: None })
    }

    fn scheme(
        scheme: &Scheme,
        motion: &Motion,
        duration: f64,
        setting: &Setting,
        waited_for: bool,
    ) -> Result<Self> {
        let errors = errors(motion, &mut Course::new(scheme, setting)?, duration)?;
        let ending: Option<Ending> = if waited_for {
            // A method that fails after the record has no ending that is known.
            ending(motion, scheme, setting).ok().flatten()
        } else {
            None
        };
        Ok(Self {
            errors,
            ladder: ladder(motion, scheme, setting, duration),
            sticks: ending.map(|ending| ending.sticks),
            creep: ending.and_then(|ending| ending.creep),
        })
    }
}
