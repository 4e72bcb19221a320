//! What is found of one method, and what it costs.

use std::time::{Duration, Instant};

use federpendel::lens::{Candidate, Errors, Findings, Ladder};
use federpendel::scheme::Setting;
use federpendel::{Result, State};

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
    /// Runs `candidate` on the motion of `record`: once for the samples, which is timed, and once more to be held to
    /// the exact motion step by step.
    ///
    /// # Errors
    /// Why the method fails.
    pub(super) fn of(candidate: Candidate, record: &Record, setting: &Setting) -> Result<Self> {
        let times: Vec<_> = record.exact.iter().map(|sample| sample.time).collect();
        let began = Instant::now();
        let states = candidate.states(&record.motion, &times, setting)?;
        let run_time = began.elapsed();
        let Findings { errors, ladder, sticks, creep } =
            Findings::of(candidate, &record.motion, (&times, &states), setting)?;
        Ok(Measured { errors, ladder, sticks, creep, run_time, states })
    }
}
