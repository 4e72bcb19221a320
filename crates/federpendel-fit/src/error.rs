//! Why a recording could not be fitted.

use thiserror::Error;

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// Times and values differ in number.
    #[error("{times} times, but {values} values")]
    Length {
        /// Number of times.
        times: usize,
        /// Number of values.
        values: usize,
    },
    /// Too few values to fit.
    #[error("{found} values from {from} s to {to} s; at least {needed} are needed")]
    TooFew {
        /// How many there are.
        found: usize,
        /// How many it takes.
        needed: usize,
        /// Begin of the window, s.
        from: f64,
        /// End of it, s.
        to: f64,
    },
    /// A time that is not after the one before it, or a number that is not finite.
    #[error("line of values number {index}: {what} = {value} is not {allowed}")]
    Value {
        /// Which of them, from 0.
        index: usize,
        /// `time` or `value`.
        what: &'static str,
        /// What it is.
        value: f64,
        /// What it has to be.
        allowed: &'static str,
    },
    /// A choice that makes no sense.
    #[error("{name} = {value} is not {allowed}")]
    Option {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it has to be.
        allowed: &'static str,
    },
    /// All values in the window are the same.
    #[error("nothing moves from {from} s to {to} s")]
    Still {
        /// Begin of the window, s.
        from: f64,
        /// End of it, s.
        to: f64,
    },
    /// Nothing swings: the values tell no motion of a mass on a spring from noise or a ramp.
    #[error("no oscillation from {from} s to {to} s")]
    NoOscillation {
        /// Begin of the window, s.
        from: f64,
        /// End of it, s.
        to: f64,
    },
    /// No search came to an end.
    #[error("no motion could be fitted from {from} s to {to} s")]
    NoFit {
        /// Begin of the window, s.
        from: f64,
        /// End of it, s.
        to: f64,
    },
}
