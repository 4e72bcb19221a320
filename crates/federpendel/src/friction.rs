//! The three laws of friction, any subset of which acts at once.

use std::fmt;

use crate::error::{Error, Result, derived};
use crate::parameter;

/// Viscous friction, force −D v (article eq. 29).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stokes {
    damping: f64,
}

impl Stokes {
    /// Stokes friction with damping D ≥ 0 in kg/s.
    ///
    /// # Errors
    /// [`Error::Parameter`] if `damping` is negative, NaN or infinite.
    pub fn new(damping: f64) -> Result<Self> {
        Ok(Self { damping: parameter::DAMPING.check(damping)? })
    }

    /// The damping D at which γ = ω0, 2√(mC) (article eq. 36 with one root), kg/s; not finite where m C is not.
    pub fn critical_damping(mass: f64, stiffness: f64) -> f64 {
        2.0 * (mass * stiffness).sqrt()
    }

    /// Damping D, kg/s.
    pub fn damping(&self) -> f64 {
        self.damping
    }
}

/// The force that presses the mass on its guide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NormalForce {
    /// The weight m g (article eq. 55), for this gravity g in m/s².
    Weight(f64),
    /// A force of its own, N.
    Given(f64),
}

impl NormalForce {
    /// The force F_N on a body of `mass` (kg), N.
    pub fn force(self, mass: f64) -> f64 {
        match self {
            NormalForce::Weight(gravity) => mass * gravity,
            NormalForce::Given(force) => force,
        }
    }
}

/// Dry friction, force −sign(v) μ F_N while moving; at rest it holds up to μ_s F_N
/// (article eqs. 55–57; the article has no static friction, see [`crate::article`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coulomb {
    kinetic: f64,
    static_: f64,
    normal_force: NormalForce,
}

impl Coulomb {
    /// Coulomb friction with kinetic coefficient μ ≥ 0 and static coefficient μ_s ≥ μ.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a value out of range, [`Error::StaticBelowKinetic`], and
    /// [`Error::NoNormalForce`] if a coefficient is above zero but nothing presses the mass down.
    pub fn new(kinetic: f64, static_: f64, normal_force: NormalForce) -> Result<Self> {
        parameter::KINETIC.check(kinetic)?;
        parameter::STATIC.check(static_)?;
        if static_ < kinetic {
            return Err(Error::StaticBelowKinetic { static_, kinetic });
        }
        let (info, value) = match normal_force {
            NormalForce::Weight(gravity) => (parameter::GRAVITY, gravity),
            NormalForce::Given(force) => (parameter::NORMAL_FORCE, force),
        };
        if info.check(value)? == 0.0 && static_ > 0.0 {
            return Err(Error::NoNormalForce { name: info.name, value });
        }
        Ok(Self { kinetic, static_, normal_force })
    }

    /// Kinetic coefficient μ.
    pub fn kinetic(&self) -> f64 {
        self.kinetic
    }

    /// Static coefficient μ_s.
    pub fn static_coefficient(&self) -> f64 {
        self.static_
    }

    /// What presses the mass on its guide.
    pub fn normal_force(&self) -> NormalForce {
        self.normal_force
    }
}

/// Quadratic friction, force −k v|v| with k = ½ρc_wA (article eq. 81).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newton {
    coefficient: f64,
}

impl Newton {
    /// Newton friction with coefficient k = ½ρc_wA ≥ 0 in kg/m.
    ///
    /// # Errors
    /// [`Error::Parameter`] if `coefficient` is negative, NaN or infinite.
    pub fn new(coefficient: f64) -> Result<Self> {
        Ok(Self { coefficient: parameter::NEWTON_COEFFICIENT.check(coefficient)? })
    }

    /// Newton friction of a body in a medium: density ρ in kg/m³, drag coefficient c_w, frontal
    /// area A in m², all ≥ 0.
    ///
    /// # Errors
    /// [`Error::Parameter`] naming the first value out of range, [`Error::Derived`] if ½ρc_wA
    /// overflows or underflows.
    pub fn from_drag(density: f64, drag_coefficient: f64, area: f64) -> Result<Self> {
        parameter::DENSITY.check(density)?;
        parameter::DRAG_COEFFICIENT.check(drag_coefficient)?;
        parameter::AREA.check(area)?;
        let coefficient = 0.5 * density * drag_coefficient * area;
        let vanishes = density == 0.0 || drag_coefficient == 0.0 || area == 0.0;
        const OF: &[&str] = &["density", "drag_coefficient", "area"];
        Self::new(derived("newton_coefficient", OF, coefficient, !vanishes)?)
    }

    /// Coefficient ½ρc_wA, kg/m.
    pub fn coefficient(&self) -> f64 {
        self.coefficient
    }
}

/// Any subset of the three laws.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Friction {
    /// Viscous friction, if it acts.
    pub stokes: Option<Stokes>,
    /// Dry friction, if it acts.
    pub coulomb: Option<Coulomb>,
    /// Quadratic friction, if it acts.
    pub newton: Option<Newton>,
}

impl Friction {
    /// No friction at all.
    pub const NONE: Friction = Friction { stokes: None, coulomb: None, newton: None };

    /// Which laws act, that is, have a coefficient above zero.
    pub fn mix(&self) -> Mix {
        Mix {
            stokes: self.stokes.is_some_and(|law| law.damping > 0.0),
            coulomb: self.coulomb.is_some_and(|law| law.static_ > 0.0),
            newton: self.newton.is_some_and(|law| law.coefficient > 0.0),
        }
    }
}

impl From<Stokes> for Friction {
    fn from(law: Stokes) -> Self {
        Friction { stokes: Some(law), ..Friction::NONE }
    }
}

impl From<Coulomb> for Friction {
    fn from(law: Coulomb) -> Self {
        Friction { coulomb: Some(law), ..Friction::NONE }
    }
}

impl From<Newton> for Friction {
    fn from(law: Newton) -> Self {
        Friction { newton: Some(law), ..Friction::NONE }
    }
}

/// Which laws of friction act together; there are eight mixes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Mix {
    /// Stokes friction acts.
    pub stokes: bool,
    /// Coulomb friction acts.
    pub coulomb: bool,
    /// Newton friction acts.
    pub newton: bool,
}

impl fmt::Display for Mix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = [(self.stokes, "stokes"), (self.coulomb, "coulomb"), (self.newton, "newton")];
        let acting: Vec<_> =
            names.iter().filter(|(acts, _)| *acts).map(|(_, name)| *name).collect();
        f.write_str(&if acting.is_empty() { "none".to_owned() } else { acting.join("+") })
    }
}
