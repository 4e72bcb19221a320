//! Why there is no plan.

use crate::model::ModelError;

/// Why there is no plan.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// A number that has to be above zero.
    #[error("{name} = {value} is not finite and above zero")]
    NotPositive {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The damping is too strong for swings.
    #[error("the damping ratio is {ratio}; the mass does not swing")]
    NoSwings {
        /// The damping ratio.
        ratio: f64,
    },
    /// Fewer than four values per swing.
    #[error("a rate of {rate} Hz is too low; at least {least} Hz are needed")]
    RateTooLow {
        /// The rate, Hz.
        rate: f64,
        /// The lowest allowed, Hz.
        least: f64,
    },
    /// The limit is below five swings.
    #[error("{duration} s are too short; at least {least} s are needed")]
    TooShort {
        /// The limit, s.
        duration: f64,
        /// The shortest allowed, s.
        least: f64,
    },
    /// Static friction holds the mass even at the largest amplitude.
    #[error("released at {amplitude} m the mass does not move; it does beyond {held} m")]
    Sticks {
        /// The largest amplitude, m.
        amplitude: f64,
        /// Half width of the sticking band, m.
        held: f64,
    },
    /// The smallest amplitude is not below the largest.
    #[error("amplitudes from {from} m to {to} m are none")]
    Reversed {
        /// The smallest, m.
        from: f64,
        /// The largest, m.
        to: f64,
    },
    /// Even the largest amplitude is hardly above the noise.
    #[error("an amplitude of {amplitude} m drowns in noise of {noise} m")]
    Drowned {
        /// The noise as an amplitude, m.
        noise: f64,
        /// The largest amplitude, m.
        amplitude: f64,
    },
    /// The motion cannot be computed.
    #[error(transparent)]
    Model(#[from] ModelError),
}
