//! What each swing of a recording costs, before anything is fitted.

use crate::extremes::{Look, look};
use crate::report::FitReport;
use crate::start::per_length;
use crate::{Quantity, Recording};

/// A swing of a recording, or the mean of some that follow each other, in the unit of a length of the recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// Mean amplitude.
    pub amplitude: f64,
    /// Amplitude lost per swing.
    pub loss: f64,
}

impl Look {
    /// The swings between its extremes, by widths from extreme to extreme, in which the zero of the sensor cancels: widths P
    /// and P' one after the other lose (P − P')/2 per swing at the mean amplitude (P + P')/4.
    ///
    /// Extremes of a velocity or an acceleration stand for amplitudes times ω0 or ω0², `omega` being ω0.
    pub fn swings(&self, quantity: Quantity, omega: f64) -> Vec<Swing> {
        let scale = per_length(quantity, omega);
        let widths: Vec<f64> =
            self.extremes.windows(2).map(|w| (w[1].value - w[0].value).abs() / scale).collect();
        let swing = |w: &[f64]| Swing { amplitude: (w[0] + w[1]) / 4.0, loss: (w[0] - w[1]) / 2.0 };
        widths.windows(2).map(swing).collect()
    }
}

impl FitReport {
    /// The swings that `recording`, of which this is the fit, shows in the fitted part, and of how many each is the mean: so
    /// many that at most `most` are left, since the noise of a mean loss falls with their number. Of the fit they take ω0,
    /// and only for velocities and accelerations.
    pub fn swings(&self, recording: &Recording, most: usize) -> (Vec<Swing>, usize) {
        let part = self.window.first..self.window.end;
        let look = look(&recording.times[part.clone()], &recording.values[part]);
        let omega = self.best().map_or(f64::NAN, |model| model.value("angular_frequency"));
        let swings = look.map_or_else(Vec::new, |look| look.swings(self.quantity, omega));
        let together = swings.len().div_ceil(most.max(1)).max(1);
        // As even groups as can be: a last one of few would be the most unsure.
        let groups = swings.len().div_ceil(together);
        let edge = |group: usize| group * swings.len() / groups;
        ((0..groups).map(|i| mean(&swings[edge(i)..edge(i + 1)])).collect(), together)
    }
}

fn mean(swings: &[Swing]) -> Swing {
    let mean = |of: fn(&Swing) -> f64| swings.iter().map(of).sum::<f64>() / swings.len() as f64;
    Swing { amplitude: mean(|swing| swing.amplitude), loss: mean(|swing| swing.loss) }
}
