//! The record of a motion: its samples, and how long it is.

mod drawn;
mod method;
mod stability;
mod turning;

pub use method::Method;
pub(crate) use method::{Other, Source};
pub(crate) use stability::TooLong;
pub(crate) use turning::MOST_POINTS;

use federpendel::{Error, Ledger, Motion, Outcome, Sample, motion};

use crate::experiment::Experiment;
use crate::progress::Progress;

/// Samples that are computed between two signs of progress.
const CHUNK: usize = 65_536;

/// Bytes that a sample takes in memory: exactly, by another method, its time.
pub(crate) const BYTES_PER_SAMPLE: u64 = (2 * size_of::<Sample>() + size_of::<f64>()) as u64;

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
    /// The exact motion at even times.
    pub exact: Vec<Sample>,
    /// The same by the method asked for, if that is another.
    pub other: Option<Other>,
}

impl Record {
    /// Computes it; `time_step` is for numeric schemes.
    ///
    /// # Errors
    /// Whatever the core refuses.
    pub(crate) fn compute(
        experiment: Experiment,
        method: Method,
        time_step: Option<f64>,
        progress: &Progress,
    ) -> federpendel::Result<Self> {
        let motion = Motion::new(experiment.oscillator, experiment.release)?;
        let outcome = motion.outcome();
        let duration = experiment.duration.unwrap_or_else(|| motion.default_duration());
        let times = motion::even_times(duration, experiment.samples)?;
        let other = Other::compute(method, time_step, &motion, &times, progress)?;
        let mut exact = Vec::with_capacity(times.len());
        for chunk in times.chunks(CHUNK) {
            exact.extend(motion.samples(chunk)?);
            progress.advance(chunk.len() as u64);
        }
        Ok(Self { experiment, method, motion, outcome, duration, exact, other })
    }

    /// The samples by the method asked for.
    pub(crate) fn samples(&self) -> &[Sample] {
        self.other.as_ref().map_or(&self.exact, |other| &other.samples)
    }

    /// Where the method asked for is farthest from the exact motion: time (s) and distance (m).
    pub(crate) fn largest_deviation(&self) -> Option<(f64, f64)> {
        let pairs = self.other.as_ref()?.samples.iter().zip(&self.exact);
        pairs
            .map(|(other, exact)| (exact.time, (other.position - exact.position).abs()))
            .max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The method's own kinetic and potential energy at the end of the record, J.
    pub(crate) fn other_energy(&self) -> Option<(f64, f64)> {
        let oscillator = self.motion.oscillator();
        let last = self.other.as_ref()?.samples.last();
        let end = last.map_or(self.motion.release(), Sample::state);
        Some((oscillator.kinetic_energy(end), oscillator.potential_energy(end)))
    }

    /// The energies of the exact motion at the end of the record.
    ///
    /// # Errors
    /// Whatever the core refuses.
    pub(crate) fn ledger_at_end(&self) -> federpendel::Result<Ledger> {
        let ledger = self.motion.ledger(&[self.duration])?;
        ledger.first().copied().ok_or(Error::Length { name: "ledger", found: 0, expected: 1 })
    }
}
