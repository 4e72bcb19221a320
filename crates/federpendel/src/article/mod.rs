//! The article's results by equation number, as printed and corrected, to be held beside the exact
//! motion.
//!
//! “The article” is *Das Federpendel mit verschiedenen Arten von Reibung* (The spring pendulum with
//! different kinds of friction), in German. Wherever this crate gives an equation number it is one
//! of that article's.
//!
//! The article solves three experiments: no friction (its section 1), Stokes friction alone (2) and
//! Coulomb friction alone (3). Everything here refuses other mixes with [`Error::NotInArticle`].
//! It knows no static friction, so a static coefficient above the kinetic one has no effect here.
//!
//! [`Formula::printed`] and [`Formula::corrected`] pick the equation that answers a release; the
//! functions named `eq_…` give every equation by itself. What is wrong in print:
//!
//! | equation | error |
//! |---|---|
//! | (27), (28) | the brace under C̃1 − C̃2 loses the factor i, see [`ComplexForm`] |
//! | (68), (69), (79) | the three sides of (68) have three values, see [`DecaySides`] |
//! | (61), (69) | the amplitude grows for x0 < 0, see [`eq_61`] |
//! | (77), (79) | the arctangent loses the quadrant for v0 < 0, see [`eq_77`] |
//! | (61), (69), (78), (79) | no solution of (57), and no rest: see [`Formula::amplitude_end`] |
//!
//! ```
//! use federpendel::article::Formula;
//! use federpendel::{Coulomb, NormalForce, Oscillator, State};
//!
//! let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81))?;
//! let oscillator = Oscillator::new(0.5, 20.0, dry)?;
//! let release = State::new(0.1, 0.0)?;
//! let printed = Formula::printed(&oscillator, release)?.at(20.0)?;
//! let corrected = Formula::corrected(&oscillator, release)?.at(20.0)?;
//! assert!((printed.position - -5.279).abs() < 1e-3);
//! assert!((corrected.position - -0.19964).abs() < 1e-5);
//! # Ok::<(), federpendel::Error>(())
//! ```

mod complex;
mod coulomb;
mod stokes;
mod undamped;

pub use complex::Complex;
pub use coulomb::{DecaySides, eq_61, eq_67, eq_68, eq_69, eq_76, eq_77, eq_78, eq_79};
pub use stokes::{DampedRates, critical, eq_36, eq_41, eq_46, overdamped};
pub use undamped::{ComplexForm, eq_16, eq_20, eq_70};

use crate::error::{Error, Result};
use crate::friction::Mix;
use crate::motion::{Mode, Sample};
use crate::oscillator::{Oscillator, Regime, State};
use crate::parameter;

/// How an equation of the article is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Reading {
    /// As it stands in print, with its errors.
    Printed,
    /// With the errors named in [`crate::article`] put right.
    Corrected,
}

/// Which solution of the article a [`Formula`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Equation {
    /// (20), no friction.
    Eq20,
    /// (46), Stokes friction below critical damping.
    Eq46,
    /// Stokes friction above critical damping, the first remark on further cases after (47).
    Overdamped,
    /// Stokes friction at critical damping, the second remark on further cases after (47).
    Critical,
    /// (61), Coulomb friction, released from rest, with the decay velocity Δx/(T/2).
    Eq61,
    /// (69), Coulomb friction, released from rest, with the decay velocity written out.
    Eq69,
    /// (78), Coulomb friction, any release, with the decay velocity Δx/(T/2).
    Eq78,
    /// (79), Coulomb friction, any release, with the decay velocity written out.
    Eq79,
}

impl Equation {
    /// The label in files: the number in the article, or `overdamped` or `critical` for the two
    /// solutions that it gives without a number.
    pub fn name(self) -> &'static str {
        match self {
            Equation::Eq20 => "20",
            Equation::Eq46 => "46",
            Equation::Overdamped => "overdamped",
            Equation::Critical => "critical",
            Equation::Eq61 => "61",
            Equation::Eq69 => "69",
            Equation::Eq78 => "78",
            Equation::Eq79 => "79",
        }
    }
}

/// One of the article's solutions x(t) for one oscillator and one release.
///
/// Evaluated in plain double precision: the phase ω0 t is known to about ε ω0 t, which shows after
/// some 1e6 periods. The exact motion is [`crate::Motion`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Formula {
    equation: Equation,
    shape: Shape,
}

/// What the solutions are made of.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    Underdamped(stokes::Underdamped),
    Aperiodic(stokes::Aperiodic),
    LinearDecay(coulomb::LinearDecay),
}

/// Position, velocity and acceleration: a formula and its two derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Derivatives {
    position: f64,
    velocity: f64,
    acceleration: f64,
}

impl Formula {
    /// The article's solution for this release as it stands in print: (20) without friction, (46)
    /// or a remark after (47) for Stokes friction, and for Coulomb friction (69) if v0 = 0, else
    /// (79).
    ///
    /// At x0 = v0 = 0 the phase (77) of (79) is 0/0; (69) is its limit and lets the mass start to
    /// swing out of its rest, which [`Formula::amplitude_end`] = 0 betrays.
    ///
    /// # Errors
    /// [`Error::NotInArticle`] for any other mix; [`Error::Parameter`] for a release that is not
    /// finite.
    pub fn printed(oscillator: &Oscillator, release: State) -> Result<Self> {
        Self::new(oscillator, release, Reading::Printed)
    }

    /// The same with its errors put right: (61) and (78) with v_A = Δx/(T/2), the sign of x0 in
    /// front, and the phase of the right quadrant. Without Coulomb friction nothing is wrong.
    ///
    /// Still no solution of (57): between turning points it is off by up to the offset f, for
    /// v0 ≠ 0 at the turning points too, and it knows no rest.
    ///
    /// # Errors
    /// As [`Formula::printed`].
    pub fn corrected(oscillator: &Oscillator, release: State) -> Result<Self> {
        Self::new(oscillator, release, Reading::Corrected)
    }

    fn new(oscillator: &Oscillator, release: State, reading: Reading) -> Result<Self> {
        let mix = oscillator.friction().mix();
        if mix.coulomb && release.velocity == 0.0 {
            return match reading {
                Reading::Printed => eq_69(oscillator, release.position, reading),
                Reading::Corrected => eq_61(oscillator, release.position, reading),
            };
        }
        if mix.coulomb {
            return match reading {
                Reading::Printed => eq_79(oscillator, release, reading),
                Reading::Corrected => eq_78(oscillator, release, reading),
            };
        }
        match oscillator.regime() {
            _ if mix.newton => Err(Error::NotInArticle { mix }),
            Regime::Undamped => eq_20(oscillator, release),
            Regime::Underdamped => eq_46(oscillator, release),
            Regime::Critical => critical(oscillator, release),
            Regime::Overdamped => overdamped(oscillator, release),
        }
    }

    /// Which equation this is.
    pub fn equation(&self) -> Equation {
        self.equation
    }

    /// Position, velocity and acceleration at `time` ≥ 0 (s), the last two as derivatives of the
    /// formula; the mode is the direction of that velocity, since the formulas know no rest.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a negative time, NaN or infinity; [`Error::Derived`] where the
    /// formula leaves the finite numbers.
    pub fn at(&self, time: f64) -> Result<Sample> {
        let time = parameter::TIME.check(time)?;
        let values = match &self.shape {
            Shape::Underdamped(shape) => shape.at(time),
            Shape::Aperiodic(shape) => shape.at(time),
            Shape::LinearDecay(shape) => shape.at(time),
        };
        values.sample(time)
    }

    /// The time, s, at which the linearly falling amplitude of (61), (69), (78), (79) has passed
    /// through zero; from there on these formulas *grow*, while the mass has come to rest at about
    /// this time. `None` for the other equations, and if the amplitude does not fall.
    ///
    /// The printed v_A and the printed sign for x0 < 0 are taken as they are; an amplitude that
    /// only ever grows ends at 0.
    pub fn amplitude_end(&self) -> Option<f64> {
        match &self.shape {
            Shape::LinearDecay(shape) => shape.amplitude_end(),
            Shape::Underdamped(_) | Shape::Aperiodic(_) => None,
        }
    }
}

impl Derivatives {
    fn sample(self, time: f64) -> Result<Sample> {
        let finite = |quantity, value: f64| {
            let of = &["time"];
            if value.is_finite() { Ok(value) } else { Err(Error::Derived { quantity, value, of }) }
        };
        Ok(Sample {
            time,
            position: finite("position", self.position)?,
            velocity: finite("velocity", self.velocity)?,
            acceleration: finite("acceleration", self.acceleration)?,
            mode: direction(self.velocity, self.acceleration),
        })
    }
}

/// The direction of a motion just after a time at which it has this velocity and acceleration.
pub(crate) fn direction(velocity: f64, acceleration: f64) -> Mode {
    let leading = if velocity == 0.0 { acceleration } else { velocity };
    if leading > 0.0 {
        Mode::Forward
    } else if leading < 0.0 {
        Mode::Backward
    } else {
        Mode::Stuck
    }
}

/// The mix of this oscillator if `solved` says that the article's equation covers it.
fn require(oscillator: &Oscillator, solved: impl Fn(Mix) -> bool) -> Result<()> {
    let mix = oscillator.friction().mix();
    if solved(mix) { Ok(()) } else { Err(Error::NotInArticle { mix }) }
}
