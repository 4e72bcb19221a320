//! The record of a motion: its samples by one method, and how long it is.

mod duration;
mod method;

pub(crate) use duration::default_duration;
pub use method::Method;

use federpendel::{Ledger, Motion, Outcome, Sample, TurningPoint, motion};

use crate::experiment::Experiment;
use crate::progress::Progress;

/// Samples that are computed between two signs of progress.
const CHUNK: usize = 65_536;

/// Bytes that a sample takes in memory, with its time.
pub(crate) const BYTES_PER_SAMPLE: u64 = (size_of::<Sample>() + size_of::<f64>()) as u64;

/// An experiment with everything that was computed from it.
pub(crate) struct Record {
    /// What was asked.
    pub experiment: Experiment,
    /// By which method.
    pub method: Method,
    /// The exact motion.
    pub motion: Motion,
    /// How the exact motion ends.
    pub outcome: Outcome,
    /// Length, s.
    pub duration: f64,
    /// By the method asked for, at even times.
    pub samples: Vec<Sample>,
}

impl Record {
    /// Computes it.
    ///
    /// # Errors
    /// Whatever the core refuses.
    pub(crate) fn compute(
        experiment: Experiment,
        method: Method,
        progress: &Progress,
    ) -> federpendel::Result<Self> {
        let motion = Motion::new(experiment.oscillator, experiment.release)?;
        let outcome = motion.outcome();
        let duration = experiment.duration.unwrap_or_else(|| default_duration(&motion, &outcome));
        let times = motion::even_times(duration, experiment.samples)?;
        let mut samples = Vec::with_capacity(times.len());
        for chunk in times.chunks(CHUNK) {
            samples.extend(motion.samples(chunk)?);
            progress.advance(chunk.len() as u64);
        }
        Ok(Self { experiment, method, motion, outcome, duration, samples })
    }

    /// The turning points of the exact motion within the record.
    pub(crate) fn turning_points(&self) -> impl Iterator<Item = TurningPoint> + '_ {
        self.motion.turning_points().take_while(|point| point.time <= self.duration)
    }

    /// The energies of the exact motion at the end of the record.
    ///
    /// # Errors
    /// Whatever the core refuses.
    pub(crate) fn ledger_at_end(&self) -> federpendel::Result<Ledger> {
        let ledger = self.motion.ledger(&[self.duration])?;
        ledger.first().copied().ok_or(federpendel::Error::Length {
            name: "ledger",
            found: 0,
            expected: 1,
        })
    }
}
