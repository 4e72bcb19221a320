//! One table of the quantities that a user gives: name, symbol, unit, range, default.
//!
//! Command-line help, Python docstrings, the page's sliders and every error message read it, so a
//! quantity is called the same everywhere.

use std::fmt;

use crate::error::{Error, Result};

/// Which finite numbers a parameter may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NonNegative,
    /// Any finite number.
    Finite,
    /// A whole number, at least two.
    CountFromTwo,
    /// Greater than zero and less than one.
    Fraction,
}

impl Range {
    /// Whether `value` is allowed. NaN and infinities never are.
    pub fn contains(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Range::Positive => value > 0.0,
                Range::NonNegative => value >= 0.0,
                Range::Finite => true,
                Range::Fraction => value > 0.0 && value < 1.0,
                Range::CountFromTwo => value >= 2.0 && value.fract() == 0.0,
            }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Range::Positive => "a finite number greater than 0",
            Range::NonNegative => "a finite number, 0 or greater",
            Range::Finite => "a finite number",
            Range::CountFromTwo => "a whole number, 2 or greater",
            Range::Fraction => "a number greater than 0 and less than 1",
        })
    }
}

/// A quantity that a user gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterInfo {
    /// Name in experiment files, on the command line (with `-` for `_`), in Python and in JSON.
    pub name: &'static str,
    /// Symbol in formulas, as in the article where it has one.
    pub symbol: &'static str,
    /// SI unit; `1` for a pure number.
    pub unit: &'static str,
    /// What is allowed.
    pub range: Range,
    /// Value taken when nothing is given; `None` where it must be given or depends on others.
    pub default: Option<f64>,
}

impl ParameterInfo {
    /// The value itself if it is allowed.
    ///
    /// # Errors
    /// [`Error::Parameter`] with this parameter's name and range.
    pub fn check(&self, value: f64) -> Result<f64> {
        if self.range.contains(value) {
            Ok(value)
        } else {
            Err(Error::Parameter { name: self.name, value, range: self.range })
        }
    }
}

macro_rules! parameters {
    ($($(#[$doc:meta])* $constant:ident = $name:literal, $symbol:literal, $unit:literal, $range:ident, $default:expr;)*) => {
        $($(#[$doc])* pub const $constant: ParameterInfo = ParameterInfo {
            name: $name, symbol: $symbol, unit: $unit, range: Range::$range, default: $default,
        };)*
        /// All parameters, in the order in which an experiment file gives them.
        pub const PARAMETERS: &[ParameterInfo] = &[$($constant),*];
    };
}

parameters! {
    /// Mass of the body, m.
    MASS = "mass", "m", "kg", Positive, None;
    /// Stiffness of the spring, C (article eq. 2).
    STIFFNESS = "stiffness", "C", "N/m", Positive, None;
    /// Acceleration of gravity, which presses the mass on its guide with F_N = m g (eq. 55).
    GRAVITY = "gravity", "g", "m/s^2", NonNegative, Some(9.81);
    /// Normal force F_N given directly, instead of gravity.
    NORMAL_FORCE = "normal_force", "F_N", "N", NonNegative, None;
    /// Damping D of Stokes friction, force −D v (eq. 29).
    DAMPING = "damping", "D", "kg/s", NonNegative, None;
    /// Kinetic coefficient μ of Coulomb friction (eq. 55).
    KINETIC = "kinetic", "μ", "1", NonNegative, None;
    /// Static coefficient of Coulomb friction, at least the kinetic one; defaults to it.
    STATIC = "static", "μ_s", "1", NonNegative, None;
    /// Density ρ of the medium of Newton friction (eq. 81).
    DENSITY = "density", "ρ", "kg/m^3", NonNegative, None;
    /// Drag coefficient c_w of Newton friction (eq. 81).
    DRAG_COEFFICIENT = "drag_coefficient", "c_w", "1", NonNegative, None;
    /// Frontal area A of Newton friction (eq. 81).
    AREA = "area", "A", "m^2", NonNegative, None;
    /// Newton coefficient ½ρc_wA, force −½ρc_wA v|v| (eq. 81).
    NEWTON_COEFFICIENT = "newton_coefficient", "½ρc_wA", "kg/m", NonNegative, None;
    /// Position of release x0.
    POSITION = "position", "x0", "m", Finite, None;
    /// Velocity of release v0.
    VELOCITY = "velocity", "v0", "m/s", Finite, Some(0.0);
    /// Length of the record.
    DURATION = "duration", "t_end", "s", Positive, None;
    /// Number of samples of the record, both ends included.
    SAMPLES = "samples", "n", "1", CountFromTwo, Some(2001.0);
    /// Time step Δt of a numeric scheme.
    TIME_STEP = "dt", "Δt", "s", Positive, None;
    /// Error that a method which chooses its steps may make in one, over the amplitude.
    TOLERANCE = "tolerance", "ε", "1", Fraction, Some(1e-6);
    /// Width of smooth friction μF_N tanh(v/width), which stands in for the sign of v.
    WIDTH = "width", "v_w", "m/s", Positive, None;
    /// A time at which the motion is asked for.
    TIME = "time", "t", "s", NonNegative, None;
}
