//! What is nothing but rounding: shown to a person as zero. Files keep their numbers.

use std::io;

use federpendel::{Outcome, Rest};

use crate::record::Record;

/// Below what a value of this record is rounding.
#[derive(Debug, Clone, Copy)]
pub(in crate::output) struct Noise {
    length: f64,
    potential: f64,
    kinetic: f64,
    phase: f64,
}

impl Noise {
    /// From the bound on the errors of the motion.
    pub(in crate::output) fn of(record: &Record) -> io::Result<Self> {
        let motion = &record.motion;
        let length = motion.error_bound(record.duration).map_err(io::Error::other)?;
        let oscillator = motion.oscillator();
        let phase = motion.phase_error(record.duration);
        let energy = |length: f64| 0.5 * oscillator.stiffness() * length * length;
        Ok(Self { length, potential: energy(length), kinetic: energy(length + phase), phase })
    }

    /// A position, m.
    pub(super) fn length(self, position: f64) -> f64 {
        if position.abs() <= self.length { 0.0 } else { position }
    }

    /// A potential energy at the end of the record, J.
    pub(super) fn potential(self, energy: f64) -> f64 {
        if energy <= self.potential { 0.0 } else { energy }
    }

    /// A kinetic energy at the end of the record, J.
    pub(super) fn kinetic(self, energy: f64) -> f64 {
        if energy <= self.kinetic { 0.0 } else { energy }
    }

    /// Whether another method that is `distance` (m) away is as good as the motion: formulas know
    /// their phase no better than the time.
    pub(super) fn agrees(self, distance: f64) -> bool {
        distance <= self.length + self.phase
    }

    /// How the motion ends.
    pub(in crate::output) fn outcome(self, outcome: Outcome) -> Outcome {
        match outcome {
            Outcome::Rests(rest) => {
                Outcome::Rests(Rest { position: self.length(rest.position), ..rest })
            }
            Outcome::Creeps { limit } => Outcome::Creeps { limit: self.length(limit) },
            other => other,
        }
    }
}
