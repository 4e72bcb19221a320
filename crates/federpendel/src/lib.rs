//! The motion of a mass on a spring, slowed by Stokes (viscous), Coulomb (dry, it sticks) or Newton
//! (quadratic) friction, or any mix of them: swing by swing, as exactly as each mix allows.

pub mod article;
mod chain;
mod double;
pub mod energy;
pub mod error;
pub mod friction;
pub mod motion;
pub mod oscillator;
pub mod outcome;
pub mod parameter;
pub mod problems;
mod sampling;
pub mod scheme;
mod sticking;
mod swing;

pub use energy::{Heat, Ledger};
pub use error::{Error, Result};
pub use friction::{Coulomb, Friction, Mix, Newton, NormalForce, Stokes};
pub use motion::{Kind, Mode, Motion, Sample, Ties, TurningPoint, even_times};
pub use oscillator::{Oscillator, Regime, State};
pub use outcome::{Outcome, Rest};

/// Newton friction without Stokes friction: turning points and v(x) from a first integral.
pub mod first_integral {
    pub use crate::swing::first_integral::{next_amplitude, speed};
}

/// The examples of the README, compiled and run with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
pub struct Readme;
