//! Turning points of a record: all of them, or few that show them.

use federpendel::{Outcome, TurningPoint};

use super::Record;

/// Most turning points that are gone through; of more only the number is told.
pub(crate) const MOST_POINTS: f64 = 1e7;

/// Turning points that a plot can show.
const PLOTTED: usize = 4096;

impl Record {
    /// The turning points of the exact motion within the record.
    pub(crate) fn turning_points(&self) -> impl Iterator<Item = TurningPoint> + '_ {
        self.motion.turning_points().take_while(|point| point.time <= self.duration)
    }

    /// About how many there are.
    pub(crate) fn expected_turning_points(&self) -> f64 {
        // Newton friction makes swings longer, never shorter.
        let frequency = self.motion.oscillator().frequency().unwrap_or(0.0);
        let within = 2.0 * frequency * self.duration + 1.0;
        match self.outcome {
            Outcome::Rests(rest) => within.min(rest.swings as f64),
            _ => within,
        }
    }

    /// Turning points for a plot: of very many, neighbours evenly chosen; of more than
    /// [`MOST_POINTS`], none.
    pub(crate) fn plotted_turning_points(&self) -> Vec<TurningPoint> {
        if self.expected_turning_points() > MOST_POINTS {
            return Vec::new();
        }
        let mut kept = Vec::new();
        let mut stride = 1;
        for (index, point) in self.turning_points().enumerate() {
            // Neighbours in pairs, so that both sides are seen.
            if (index / 2) % stride == 0 {
                kept.push(point);
            }
            if kept.len() >= 2 * PLOTTED {
                kept = kept.chunks(4).flat_map(|four| four.iter().take(2)).copied().collect();
                stride *= 2;
            }
        }
        kept
    }
}
