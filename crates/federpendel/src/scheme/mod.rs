//! Numeric methods, to be held beside the exact motion: one file each, and one list of them all.
//!
//! ```
//! use federpendel::scheme::{self, Setting};
//! use federpendel::{Coulomb, NormalForce, Oscillator, State};
//!
//! let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81))?;
//! let oscillator = Oscillator::new(0.5, 20.0, dry)?;
//! let setting = Setting::new(oscillator, State::new(0.1, 0.0)?)?;
//! let rk4 = scheme::named("rk4-located").expect("a name of the list");
//! let mut integration = rk4.start(&setting)?;
//! while integration.time() < 6.0 {
//!     integration.step()?;
//! }
//! assert!((integration.state().position - 0.0019).abs() < 1e-8); // it sticks there
//! # Ok::<(), federpendel::Error>(())
//! ```

pub mod article;
mod dopri5;
mod equation;
mod integration;
mod located;
mod moreau_jean;
mod rk4;
mod setting;
mod stepper;
mod symplectic_euler;
mod verlet;

pub use integration::Integration;
pub use setting::Setting;

use equation::{Directed, Equation, Signed};
use integration::Plain;
use located::Located;
use stepper::Stepper;

use crate::error::Result;

/// How a method deals with dry friction, whose force jumps where the velocity changes sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum DryFriction {
    /// sign(x′) in the right-hand side, with sign(0) = 0, as in a textbook.
    Sign,
    /// Reversals are located, and the mass sticks or turns there.
    Located,
    /// A smooth function in place of the sign.
    Smoothed,
    /// An inclusion solved in every step: the mass sticks by construction.
    Inclusion,
}

/// A numeric method.
#[derive(Debug, Clone, Copy)]
pub struct Scheme {
    /// Its name on the command line and in files.
    pub name: &'static str,
    /// Order p: where the motion is smooth the error falls as Δtᵖ. With friction it may fall more slowly.
    pub order: u32,
    /// Whether it chooses its steps by a tolerance.
    pub adaptive: bool,
    /// What it makes of dry friction.
    pub dry: DryFriction,
    start: fn(&Setting) -> Result<Box<dyn Integration>>,
}

/// All methods. A new one is a file of its own and a line here.
pub const SCHEMES: [Scheme; 10] = [
    article::SCHEME,
    symplectic_euler::SCHEME,
    verlet::SCHEME,
    verlet::LOCATED,
    rk4::SCHEME,
    rk4::LOCATED,
    rk4::SMOOTHED,
    dopri5::SCHEME,
    dopri5::LOCATED,
    moreau_jean::SCHEME,
];

/// The method of this name.
pub fn named(name: &str) -> Option<&'static Scheme> {
    const LIST: &[Scheme] = &SCHEMES;
    LIST.iter().find(|scheme| scheme.name == name)
}

impl Scheme {
    /// The method at the release.
    ///
    /// # Errors
    /// [`Error::Derived`](crate::Error::Derived) or [`Error::Diverged`](crate::Error::Diverged) where the first
    /// step cannot be made of the setting.
    pub fn start(&self, setting: &Setting) -> Result<Box<dyn Integration>> {
        (self.start)(setting)
    }
}

/// A stepper along a field of its own.
fn along<F: 'static, S: Stepper<F> + 'static>(
    setting: &Setting,
    field: F,
    stepper: S,
) -> Result<Box<dyn Integration>> {
    Ok(Box::new(Plain::new(field, stepper, setting.release)))
}

/// A stepper with the sign of the velocity in the right-hand side.
fn plain<S: Stepper<Signed> + 'static>(
    setting: &Setting,
    stepper: S,
) -> Result<Box<dyn Integration>> {
    along(setting, Signed(Equation::new(&setting.oscillator)), stepper)
}

/// A stepper with located reversals and true sticking.
fn located<S: Stepper<Directed> + 'static>(
    setting: &Setting,
    stepper: S,
) -> Result<Box<dyn Integration>> {
    let equation = Equation::new(&setting.oscillator);
    Ok(Box::new(Located::new(equation, stepper, setting.release)))
}
