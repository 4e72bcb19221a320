//! The oscillator: mass, spring and friction, and what follows from them alone.

use std::f64::consts::PI;

use crate::double::Double;
use crate::error::{Result, derived};
use crate::friction::{Friction, NormalForce};
use crate::parameter;

/// A mass on a spring, slowed by any mix of friction: m x″ = −C x + F_R(x′).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oscillator {
    mass: f64,
    stiffness: f64,
    friction: Friction,
    reduced: Reduced,
}

/// Where the mass is and how fast it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Displacement x from the place where the spring is relaxed, m.
    pub position: f64,
    /// Velocity v = x′, m/s.
    pub velocity: f64,
}

impl State {
    /// The state of a release at `position` (m) with `velocity` (m/s).
    ///
    /// # Errors
    /// [`Error::Parameter`](crate::Error::Parameter) for NaN or an infinity.
    pub fn new(position: f64, velocity: f64) -> Result<Self> {
        parameter::POSITION.check(position)?;
        parameter::VELOCITY.check(velocity)?;
        Ok(Self { position, velocity })
    }
}

/// How strongly Stokes friction alone damps the spring: a label for people. The motion itself comes from one
/// formula for all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Regime {
    /// γ = 0.
    Undamped,
    /// γ < ω0: the mass swings.
    Underdamped,
    /// |γ² − ω0²| ≤ 8 ε ω0².
    Critical,
    /// γ > ω0: the mass creeps.
    Overdamped,
}

impl Regime {
    /// The label in files: `undamped`, `underdamped`, `critical` or `overdamped`.
    pub fn name(self) -> &'static str {
        match self {
            Regime::Undamped => "undamped",
            Regime::Underdamped => "underdamped",
            Regime::Critical => "critical",
            Regime::Overdamped => "overdamped",
        }
    }
}

/// The coefficients of the equation of motion in the time τ = ω0 t:
/// x″ + 2ζ x′ + sign(x′) κ x′² + x + sign(x′) f = 0.
///
/// Those that accumulate over many swings are kept in double-double: one rounding of C/m alone
/// would cost 1e-14 of phase in 60 swings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reduced {
    /// ω0 = √(C/m), 1/s.
    pub omega0: Double,
    /// 1/ω0, s.
    pub time_unit: Double,
    /// Damping ratio ζ = γ/ω0 = D/(2√(C m)).
    pub zeta: Double,
    /// Offset f = μ F_N/C, m.
    pub offset: Double,
    /// Half width of the sticking band f_s = μ_s F_N/C, m.
    pub sticking_offset: Double,
    /// κ = ½ρc_wA/m, 1/m.
    pub kappa: f64,
}

impl Reduced {
    fn new(mass: f64, stiffness: f64, friction: &Friction) -> Self {
        let damping = friction.stokes.map_or(0.0, |law| law.damping());
        let root = Double::product(stiffness, mass).sqrt();
        let (offset, sticking_offset) = match friction.coulomb {
            // Without a coefficient the force may be so large that its product would be no number.
            Some(law) if law.static_coefficient() > 0.0 => {
                let force = match law.normal_force() {
                    NormalForce::Weight(gravity) => Double::product(mass, gravity),
                    NormalForce::Given(force) => force.into(),
                };
                let stretch = force / stiffness;
                (stretch * law.kinetic(), stretch * law.static_coefficient())
            }
            _ => (0.0.into(), 0.0.into()),
        };
        let omega0 = (Double::from(stiffness) / mass).sqrt();
        Reduced {
            omega0,
            time_unit: 1.0 / omega0,
            zeta: damping * 0.5 / root,
            offset,
            sticking_offset,
            kappa: friction.newton.map_or(0.0, |law| law.coefficient()) / mass,
        }
    }

    /// 1 − ζ², the square of the damped frequency over ω0: positive when the linear part swings.
    pub fn discriminant(&self) -> Double {
        (1.0 - self.zeta) * (1.0 + self.zeta)
    }
}

/// Whether all that follows from these values can be computed with.
fn check_magnitudes(mass: f64, stiffness: f64, friction: &Friction) -> Result<()> {
    const SPRING: &[&str] = &["mass", "stiffness"];
    derived("stiffness/mass", SPRING, stiffness / mass, true)?;
    derived("stiffness*mass", SPRING, stiffness * mass, true)?;
    if let Some(law) = friction.stokes {
        const OF: &[&str] = &["mass", "stiffness", "damping"];
        let ratio = 0.5 * law.damping() / (stiffness * mass).sqrt();
        derived("damping", &["damping"], law.damping(), law.damping() > 0.0)?;
        derived("damping_ratio", OF, ratio, law.damping() > 0.0)?;
        // 1 − ζ² must stay in the range too.
        derived("damping_ratio^2", OF, 1.0 + ratio * ratio, true)?;
    }
    if let Some(law) = friction.coulomb {
        const OF: &[&str] = &["mass", "stiffness", "normal_force", "gravity", "kinetic", "static"];
        let (kinetic, holding) = (law.kinetic(), law.static_coefficient());
        let force = law.normal_force().force(mass);
        derived("static", &["static"], holding, holding > 0.0)?;
        derived("kinetic", &["kinetic"], kinetic, kinetic > 0.0)?;
        derived("gravity", &["gravity", "normal_force", "mass"], force / mass, holding > 0.0)?;
        derived("normal_force", OF, force, holding > 0.0)?;
        derived("offset", OF, kinetic * (force / stiffness), kinetic > 0.0)?;
        derived("sticking_offset", OF, holding * (force / stiffness), holding > 0.0)?;
    }
    if let Some(law) = friction.newton {
        let rate = law.coefficient() / mass;
        derived("newton_rate", &["mass", "newton_coefficient"], rate, law.coefficient() > 0.0)?;
    }
    Ok(())
}

impl Oscillator {
    /// An oscillator of `mass` m in kg on a spring of `stiffness` C in N/m, both above zero.
    ///
    /// # Errors
    /// [`Error::Parameter`](crate::Error::Parameter) for a value out of range; [`Error::Derived`](crate::Error::Derived) where values allowed one
    /// by one make a frequency, an offset or a rate that overflows or underflows.
    pub fn new(mass: f64, stiffness: f64, friction: impl Into<Friction>) -> Result<Self> {
        let friction = friction.into();
        parameter::MASS.check(mass)?;
        parameter::STIFFNESS.check(stiffness)?;
        check_magnitudes(mass, stiffness, &friction)?;
        let reduced = Reduced::new(mass, stiffness, &friction);
        Ok(Self { mass, stiffness, friction, reduced })
    }

    /// Mass m, kg.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Stiffness C, N/m.
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// The laws of friction.
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    pub(crate) fn reduced(&self) -> &Reduced {
        &self.reduced
    }

    /// Angular frequency without friction ω0 = √(C/m), 1/s (article eq. 16).
    pub fn angular_frequency(&self) -> f64 {
        self.reduced.omega0.into()
    }

    /// Damping rate γ = D/(2m), 1/s (article eq. 41).
    pub fn damping_rate(&self) -> f64 {
        (self.reduced.zeta * self.reduced.omega0).into()
    }

    /// Damping ratio ζ = γ/ω0.
    pub fn damping_ratio(&self) -> f64 {
        self.reduced.zeta.into()
    }

    /// Quality factor Q = ω0/(2γ) of the Stokes part; `None` without Stokes friction.
    pub fn quality_factor(&self) -> Option<f64> {
        let zeta = self.damping_ratio();
        (zeta > 0.0).then(|| 0.5 / zeta)
    }

    /// Logarithmic decrement γT of the Stokes part, T the damped period; `None` where it does not
    /// swing.
    pub fn logarithmic_decrement(&self) -> Option<f64> {
        self.period().map(|period| self.damping_rate() * period)
    }

    /// Period T = 2π/√(ω0² − γ²) of the oscillator with its Stokes friction, s; `None` where it
    /// does not swing. Coulomb friction leaves the period alone.
    pub fn period(&self) -> Option<f64> {
        self.frequency().map(f64::recip)
    }

    /// Frequency √(ω0² − γ²)/2π of the oscillator with its Stokes friction, Hz (article eq. 41);
    /// `None` where it does not swing.
    pub fn frequency(&self) -> Option<f64> {
        let swings = matches!(self.regime(), Regime::Undamped | Regime::Underdamped);
        swings.then(|| {
            f64::from(self.reduced.discriminant().sqrt() * self.reduced.omega0) / (2.0 * PI)
        })
    }

    /// The label of the Stokes part.
    pub fn regime(&self) -> Regime {
        let discriminant = f64::from(self.reduced.discriminant());
        if self.damping_ratio() == 0.0 {
            Regime::Undamped
        } else if discriminant.abs() <= 8.0 * f64::EPSILON {
            Regime::Critical
        } else if discriminant > 0.0 {
            Regime::Underdamped
        } else {
            Regime::Overdamped
        }
    }

    /// Offset f = μ F_N/C of Coulomb friction, m: by so much it shifts the centre of each swing.
    pub fn offset(&self) -> f64 {
        self.reduced.offset.into()
    }

    /// Half width f_s = μ_s F_N/C of the sticking band, m: a turning point with |x| ≤ f_s holds.
    pub fn sticking_offset(&self) -> f64 {
        self.reduced.sticking_offset.into()
    }

    /// Newton rate κ = ½ρc_wA/m, 1/m.
    pub fn newton_rate(&self) -> f64 {
        self.reduced.kappa
    }

    /// Kinetic and potential energy ½mv² + ½Cx² of a state, J.
    pub fn energy(&self, state: State) -> f64 {
        self.kinetic_energy(state) + self.potential_energy(state)
    }

    /// Kinetic energy ½mv², J.
    pub fn kinetic_energy(&self, state: State) -> f64 {
        0.5 * self.mass * state.velocity * state.velocity
    }

    /// Potential energy ½Cx² of the spring, J.
    pub fn potential_energy(&self, state: State) -> f64 {
        0.5 * self.stiffness * state.position * state.position
    }
}
