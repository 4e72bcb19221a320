//! The experiment as the page holds it: every value, acting or not, so that a law that is switched off keeps its own.

use std::collections::BTreeMap;

use federpendel::{
    Coulomb, Friction, Mix, Motion, Newton, NormalForce, Oscillator, Result, State, Stokes,
    parameter,
};
use serde::{Deserialize, Serialize};

/// All that the page's controls say.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Experiment {
    /// Values by the names of parameters, SI.
    pub values: BTreeMap<String, f64>,
    /// Which laws are switched on.
    pub laws: Laws,
    /// Whether the mass hangs: then its weight pulls at the spring and presses on no guide, where `normal_force` counts.
    pub hanging: bool,
    /// Length of the record, s.
    pub duration: f64,
}

/// The laws that are switched on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Laws {
    /// Viscous friction.
    pub stokes: bool,
    /// Dry friction.
    pub coulomb: bool,
    /// Quadratic friction.
    pub newton: bool,
}

impl From<Laws> for Mix {
    fn from(Laws { stokes, coulomb, newton }: Laws) -> Self {
        Mix { stokes, coulomb, newton }
    }
}

impl Experiment {
    /// A value by its name; NaN, which every range refuses, where it is missing.
    pub fn value(&self, name: &str) -> f64 {
        self.values.get(name).copied().unwrap_or(f64::NAN)
    }

    /// What presses the mass on its guide.
    fn normal_force(&self) -> NormalForce {
        if self.hanging {
            NormalForce::Given(self.value("normal_force"))
        } else {
            NormalForce::Weight(self.value("gravity"))
        }
    }

    /// The laws that are switched on, with their coefficients.
    fn friction(&self) -> Result<Friction> {
        let value = |name| self.value(name);
        let stokes = || Stokes::new(value("damping"));
        let coulomb = || Coulomb::new(value("kinetic"), value("static"), self.normal_force());
        let newton =
            || Newton::from_drag(value("density"), value("drag_coefficient"), value("area"));
        Ok(Friction {
            stokes: self.laws.stokes.then(stokes).transpose()?,
            coulomb: self.laws.coulomb.then(coulomb).transpose()?,
            newton: self.laws.newton.then(newton).transpose()?,
        })
    }

    /// The oscillator.
    ///
    /// # Errors
    /// The first value that the core refuses.
    pub fn oscillator(&self) -> Result<Oscillator> {
        Oscillator::new(self.value("mass"), self.value("stiffness"), self.friction()?)
    }

    /// The motion.
    ///
    /// # Errors
    /// The first value that the core refuses.
    pub fn motion(&self) -> Result<Motion> {
        let oscillator = self.oscillator()?;
        parameter::DURATION.check(self.duration)?;
        Motion::new(oscillator, State::new(self.value("position"), self.value("velocity"))?)
    }

    /// The weight along the motion, N: m g downwards, towards positive positions, where the mass hangs; where it lies, the
    /// guide carries it.
    ///
    /// # Errors
    /// A gravity that is not allowed.
    pub fn weight(&self) -> Result<f64> {
        if !self.hanging {
            return Ok(0.0);
        }
        Ok(self.value("mass") * parameter::GRAVITY.check(self.value("gravity"))?)
    }

    /// The damping that lets the mass creep home fastest, kg/s.
    pub fn critical_damping(&self) -> f64 {
        Stokes::critical_damping(self.value("mass"), self.value("stiffness"))
    }
}
