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
    pub from: Option<f64>,
    /// The largest, m.
    pub to: f64,
    /// The longest recording, s; a thousand periods if not given.
    pub longest: Option<f64>,
}

/// Fewest values per swing, half a period.
const PER_SWING: f64 = 4.0;

/// The shortest recording that anything is planned for, periods.
const SHORTEST: f64 = 2.0;

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

    /// The longest recording, s.
    pub fn longest(&self) -> f64 {
        self.longest.unwrap_or(LONGEST * self.period())
    }

    /// The smallest amplitude, m.
    pub fn from(&self) -> f64 {
        let visible = (OVER_NOISE * self.noise_length()).max(self.oscillator.sticking_offset());
        self.from.unwrap_or(visible.max(self.to / RANGE))
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
        let given = [("from_amplitude", self.from), ("duration", self.longest)];
        let all = [("noise", self.noise), ("rate", self.rate), ("to_amplitude", self.to)]
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
        let shortest = SHORTEST * period;
        if self.longest() < shortest {
            return Err(PlanError::TooShort { duration: self.longest(), least: shortest });
        }
        let held = self.oscillator.sticking_offset();
        if self.to <= held {
            return Err(PlanError::Sticks { amplitude: self.to, held });
        }
        match self.from {
            Some(from) if from >= self.to => Err(PlanError::Reversed { from, to: self.to }),
            None if self.from() >= self.to => {
                Err(PlanError::Drowned { noise: self.noise_length(), amplitude: self.to })
            }
            _ => Ok(()),
        }
    }
}
