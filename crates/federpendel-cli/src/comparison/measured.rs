//! What is found of one method.

use std::time::{Duration, Instant};

use federpendel::article::{Formula, Reading};
use federpendel::lens::{self, Course, Ending, Errors, Gauge, Ladder};
use federpendel::scheme::{Scheme, Setting};
use federpendel::{Outcome, Result, State};

use super::Candidate;
use crate::record::Record;

/// What was found of one method.
pub(crate) struct Measured {
    /// How far it is from the exact motion: a numeric method on its own steps, a formula at the samples.
    pub errors: Errors,
    /// Its errors at six halvings of the step; empty for a formula.
    pub ladder: Ladder,
    /// Whether it lets the mass rest, if the mass does; `None` if it never does.
    pub sticks: Option<bool>,
    /// How fast its place changes after the rest, m/s; none where it still swings.
    pub creep: Option<f64>,
    /// How long it took to compute the motion.
    pub run_time: Duration,
    /// Its states at the times of the record.
    pub states: Vec<State>,
}

impl Measured {
    /// Runs `candidate` on the motion of `record`.
    ///
    /// # Errors
    /// Why the method fails.
    pub(super) fn of(candidate: Candidate, record: &Record, setting: &Setting) -> Result<Self> {
        match candidate {
            Candidate::Formula(reading) => Self::formula(reading, record),
            Candidate::Scheme(scheme) => Self::scheme(scheme, record, setting),
        }
    }

    fn formula(reading: Reading, record: &Record) -> Result<Self> {
        let (oscillator, release) = (record.motion.oscillator(), record.motion.release());
        let began = Instant::now();
        let formula = match reading {
            Reading::Printed => Formula::printed(oscillator, release)?,
            Reading::Corrected => Formula::corrected(oscillator, release)?,
        };
        let at = |time: f64| formula.at(time).map(|sample| sample.state());
        let states =
            record.exact.iter().map(|sample| at(sample.time)).collect::<Result<Vec<_>>>()?;
        let run_time = began.elapsed();
        let mut gauge = Gauge::new(&record.motion);
        for (sample, state) in record.exact.iter().zip(&states) {
            gauge.add(sample.time, *state)?;
        }
        // The formulas know no rest: they swing on.
        let sticks = waited_for(record).then_some(false);
        Ok(Measured {
            errors: gauge.finish(0)?,
            ladder: Ladder::default(),
            sticks,
            creep: None,
            run_time,
            states,
        })
    }

    fn scheme(scheme: &Scheme, record: &Record, setting: &Setting) -> Result<Self> {
        let motion = &record.motion;
        // Once for the samples, which is timed, and once more to be held to the exact motion step by step.
        let began = Instant::now();
        let mut course = Course::new(scheme, setting)?;
        course.check(record.duration)?;
        let states =
            record.exact.iter().map(|sample| course.at(sample.time)).collect::<Result<_>>()?;
        let run_time = began.elapsed();
        let errors = lens::errors(motion, &mut Course::new(scheme, setting)?, record.duration)?;
        let ending = ending(scheme, record, setting);
        Ok(Measured {
            errors,
            ladder: lens::ladder(motion, scheme, setting, record.duration),
            sticks: ending.map(|ending| ending.sticks),
            creep: ending.and_then(|ending| ending.creep),
            run_time,
            states,
        })
    }
}

/// A rest that comes after more lengths of the record than this is not waited for.
const PATIENCE: f64 = 10.0;

/// Whether the exact motion comes to rest soon enough to see what methods do then.
fn waited_for(record: &Record) -> bool {
    matches!(record.outcome, Outcome::Rests(rest) if rest.time <= PATIENCE * record.duration)
}

/// What the method does after the rest, as far as that is known.
fn ending(scheme: &Scheme, record: &Record, setting: &Setting) -> Option<Ending> {
    if !waited_for(record) {
        return None;
    }
    lens::ending(&record.motion, scheme, setting).ok().flatten()
}
