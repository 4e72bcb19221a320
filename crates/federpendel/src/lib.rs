//! The motion of a mass on a spring, slowed by Stokes (viscous), Coulomb (dry, it sticks) or Newton
//! (quadratic) friction, or any mix of them: swing by swing, as exactly as each mix allows.
//!
//! m x″ = −C x − D x′ − sign(x′) μ F_N − sign(x′) ½ρc_wA x′²; where x′ = 0 the mass holds for ever if
//! C|x| ≤ μ_s F_N.
//!
//! An [`Oscillator`] is the mass, the spring and the [`Friction`]; with the [`State`] of a release it
//! makes a [`Motion`], which answers for any time t ≥ 0: [`Motion::at`], [`Motion::sample_even`] and
//! [`Motion::sample`] for whole records, [`Motion::turning_points`], [`Motion::outcome`],
//! [`Motion::ledger`] for energy and heat. [`Motion::kind`] says how it is known and
//! [`Motion::error_bound`] how well.
//!
//! Every number is in SI units. Equation numbers are those of the article that [`article`] names.
//! What is refused is refused with an [`Error`] that names the value and what is allowed; nothing
//! here panics on input.
//!
//! ```
//! use federpendel::{Friction, Motion, Newton, Oscillator, State, Stokes};
//!
//! let friction = Friction {
//!     stokes: Some(Stokes::new(0.05)?),  // kg/s
//!     newton: Some(Newton::new(0.047)?), // kg/m
//!     ..Friction::NONE
//! };
//! let motion = Motion::new(Oscillator::new(0.5, 20.0, friction)?, State::new(0.1, 0.0)?)?;
//! let (mut x, mut v) = ([0.0; 1001], [0.0; 1001]);
//! motion.sample_even(10.0, &mut x, &mut v)?; // m and m/s, every 10 ms
//! let turn = motion.turning_points().next().expect("it swings");
//! assert!((turn.time - 0.497).abs() < 1e-3 && turn.position < 0.0);
//! assert!(motion.error_bound(10.0)? < 1e-14);
//! # Ok::<(), federpendel::Error>(())
//! ```

pub mod article;
mod chain;
mod double;
mod duration;
pub mod energy;
pub mod error;
pub mod forces;
pub mod friction;
pub mod lens;
pub mod motion;
pub mod oscillator;
pub mod outcome;
pub mod parameter;
pub mod problems;
mod quadrature;
mod sampling;
pub mod scheme;
mod sticking;
mod swing;

pub use energy::{Heat, Ledger};
pub use error::{Error, Result};
pub use forces::Forces;
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
