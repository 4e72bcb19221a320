//! The laws of friction by the coefficients that a fit finds.

use federpendel::{Mix, Oscillator};

use crate::Parameters;
use crate::problem::LAWS;
use crate::start;

/// A law of friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Law {
    /// Viscous: γ, 1/s.
    Stokes,
    /// Dry: a_c, m/s².
    Coulomb,
    /// Quadratic: κ, 1/m.
    Newton,
}

impl Law {
    /// All of them, in the order of [`Parameters`].
    pub const ALL: [Law; 3] = [Law::Stokes, Law::Coulomb, Law::Newton];

    /// The place of its coefficient in [`Parameters`].
    pub fn index(self) -> usize {
        LAWS[self as usize]
    }

    /// The name of its coefficient.
    pub fn parameter(self) -> &'static str {
        Parameters::NAMES[self.index()]
    }

    /// The SI unit of its coefficient.
    pub fn unit(self) -> &'static str {
        ["1/s", "m/s^2", "1/m"][self as usize]
    }

    /// Its coefficient in this oscillator, SI; zero where it does not act.
    pub fn coefficient(self, oscillator: &Oscillator) -> f64 {
        match self {
            Law::Stokes => oscillator.damping_rate(),
            Law::Coulomb => oscillator.offset() * oscillator.angular_frequency().powi(2),
            Law::Newton => oscillator.newton_rate(),
        }
    }

    /// Whether it is one of `mix`.
    pub fn is_in(self, mix: Mix) -> bool {
        start::laws(mix)[self as usize]
    }

    /// The mix of this law alone.
    pub fn alone(self) -> Mix {
        start::mix(Law::ALL.map(|law| law == self))
    }

    /// `mix` with this law.
    pub fn beside(self, mix: Mix) -> Mix {
        start::mix(Law::ALL.map(|law| law == self || law.is_in(mix)))
    }
}
