//! What a plan is made for.

use std::f64::consts::PI;

use federpendel::{Mix, Oscillator};

use super::{Law, PlanError};
use crate::start;
use crate::{Parameters, Quantity};

/// An experiment that is to be recorded, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setup {
    /// Mass, spring and the friction that is expected.
    pub oscillator: Oscillator,
    /// Laws that the fit takes besides the expected ones.
    pub also: Mix,
    /// What is recorded.
    pub quantity: Quantity,
    /// Standard deviation of a value, in the unit of the quantity.
    pub noise: f64,
    /// Values per second.
    pub rate: f64,
    /// The smallest amplitude of release, m; from the noise if not given.
    pub min_amplitude: Option<f64>,
    /// The largest, m.
    pub max_amplitude: f64,
    /// The longest recording, s; a thousand periods if not given.
    pub longest: Option<f64>,
}

/// Fewest values per swing, half a period.
const PER_SWING: f64 = 4.0;

/// Fewest swings in a recording: of fewer, fits from a cold start often go astray, however low the noise.
pub(super) const FEWEST_SWINGS: u64 = 5;

/// The longest recording without a limit of the user's, periods.
const LONGEST: f64 = 1000.0;

/// The smallest amplitude over the noise, and the largest over the smallest, where none is given.
const OVER_NOISE: f64 = 10.0;
const RANGE: f64 = 1000.0;

impl Setup {
    /// The laws that are expected to act.
    pub fn expected(&self) -> Mix {
        start::mix(Law::ALL.map(|law| law.coefficient(&self.oscillator) > 0.0))
    }

    /// The laws that are fitted together.
    pub fn fitted(&self) -> Mix {
        start::mix(Law::ALL.map(|law| law.is_in(self.also) || law.is_in(self.expected())))
    }

    /// The shortest recording that anything is planned for, s.
    pub(super) fn shortest(&self) -> f64 {
        0.5 * FEWEST_SWINGS as f64 * self.period()
    }

    /// The longest recording, s.
    pub fn longest(&self) -> f64 {
        self.longest.unwrap_or(LONGEST * self.period())
    }

    /// The smallest amplitude, m.
    pub fn smallest(&self) -> f64 {
        let visible = (OVER_NOISE * self.noise_length()).max(self.oscillator.sticking_offset());
        self.min_amplitude.unwrap_or(visible.max(self.max_amplitude / RANGE))
    }

    /// The parameters after a release from rest.
    pub(super) fn parameters(&self, amplitude: f64) -> Parameters {
        let [damping_rate, coulomb_acceleration, newton_rate] =
            Law::ALL.map(|law| law.coefficient(&self.oscillator));
        Parameters {
            angular_frequency: self.oscillator.angular_frequency(),
            damping_rate,
            coulomb_acceleration,
            newton_rate,
            position0: amplitude,
            velocity0: 0.0,
            equilibrium: 0.0,
        }
    }

    /// The amplitude whose largest value is as large as the noise.
    pub(super) fn noise_length(&self) -> f64 {
        self.noise / start::per_length(self.quantity, self.oscillator.angular_frequency())
    }

    fn period(&self) -> f64 {
        2.0 * PI / self.oscillator.angular_frequency()
    }

    /// Whether a plan can be made.
    pub(super) fn check(&self) -> Result<(), PlanError> {
        let given = [("min_amplitude", self.min_amplitude), ("duration", self.longest)];
        let all =
            [("noise", self.noise), ("rate", self.rate), ("max_amplitude", self.max_amplitude)]
                .into_iter()
                .chain(given.into_iter().filter_map(|(name, value)| Some((name, value?))));
        for (name, value) in all {
            if !(value.is_finite() && value > 0.0) {
                return Err(PlanError::NotPositive { name, value });
            }
        }
        let (ratio, period) = (self.oscillator.damping_ratio(), self.period());
        if ratio >= 1.0 {
            return Err(PlanError::NoSwings { ratio });
        }
        let least = 2.0 * PER_SWING / period;
        if self.rate < least {
            return Err(PlanError::RateTooLow { rate: self.rate, least });
        }
        if self.longest() < self.shortest() {
            return Err(PlanError::TooShort { duration: self.longest(), least: self.shortest() });
        }
        let held = self.oscillator.sticking_offset();
        if self.max_amplitude <= held {
            return Err(PlanError::Sticks { amplitude: self.max_amplitude, held });
        }
        match self.min_amplitude {
            Some(from) if from >= self.max_amplitude => {
                Err(PlanError::Reversed { from, to: self.max_amplitude })
            }
            None if self.smallest() >= self.max_amplitude => Err(PlanError::Drowned {
                noise: self.noise_length(),
                amplitude: self.max_amplitude,
            }),
            _ => Ok(()),
        }
    }
}
