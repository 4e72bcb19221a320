//! Experiments: what a file and the command line's overrides say, checked as a whole.

mod draft;
mod error;
mod field;
mod file;
mod repair;
mod resolve;
mod syntax;

pub use draft::{Draft, Given, Origin};
pub use error::{Allowed, Error};
pub use field::Field;
pub use file::{LARGEST_FILE, parse};
pub use syntax::Syntax;

use federpendel::{NormalForce, Oscillator, State};

/// The experiment that runs when no file is given.
pub const BUILT_IN: &str = include_str!("experiment/built-in.toml");

/// A file that says all that one can say, for the help.
pub const EXAMPLE: &str = include_str!("experiment/example.toml");

/// A complete experiment, checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Experiment {
    /// The mass, the spring and the friction.
    pub oscillator: Oscillator,
    /// What presses the mass on its guide, whether or not Coulomb friction acts.
    pub normal_force: NormalForce,
    /// Where and how fast it is released.
    pub release: State,
    /// The drag coefficient c_w, if Newton friction is given by it.
    pub drag_coefficient: Option<f64>,
    /// Length of the record, s, if it is given.
    pub duration: Option<f64>,
    /// Number of samples.
    pub samples: usize,
}

#[cfg(test)]
mod tests;
