//! The experiments: the reference cases, the linear mixes, weak friction, and a stiff one.

use federpendel::{Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, Result, State};
use federpendel::{Stokes, problems};

/// Length of a record, s.
pub const DURATION: f64 = 20.0;
/// Samples of a record.
pub const SAMPLES: usize = 10_000;

/// An oscillator and its release as plain numbers (SI), from which every measured run starts.
#[derive(Debug, Clone, Copy)]
pub struct Experiment {
    /// What it is called.
    pub name: &'static str,
    /// Mass, kg.
    pub mass: f64,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Stokes damping D, kg/s.
    pub damping: f64,
    /// Kinetic coefficient μ, the static one too; the normal force is the weight.
    pub kinetic: f64,
    /// Newton coefficient ½ρc_wA, kg/m.
    pub newton: f64,
    /// Release at this position, m, at rest.
    pub position: f64,
}

/// Gravity, m/s².
const GRAVITY: f64 = 9.81;

impl Experiment {
    /// The mass, spring and release of the reference cases, with this friction.
    pub const fn with(name: &'static str, damping: f64, kinetic: f64, newton: f64) -> Self {
        Self { name, mass: 0.5, stiffness: 20.0, damping, kinetic, newton, position: 0.1 }
    }

    /// Its motion: all that has to be done before the first state.
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn motion(&self) -> Result<Motion> {
        let friction = Friction {
            stokes: Some(Stokes::new(self.damping)?),
            coulomb: Some(Coulomb::new(self.kinetic, self.kinetic, NormalForce::Weight(GRAVITY))?),
            newton: Some(Newton::new(self.newton)?),
        };
        let oscillator = Oscillator::new(self.mass, self.stiffness, friction)?;
        Motion::new(oscillator, State::new(self.position, 0.0)?)
    }

    /// Period without friction, s.
    pub fn period(&self) -> f64 {
        2.0 * std::f64::consts::PI * (self.mass / self.stiffness).sqrt()
    }

    /// C/m, D/m, μg and ½ρc_wA/m.
    pub fn coefficients(&self) -> [f64; 4] {
        [
            self.stiffness / self.mass,
            self.damping / self.mass,
            self.kinetic * GRAVITY,
            self.newton / self.mass,
        ]
    }

    /// Acceleration at (x, v) as it stands in a textbook, sign(0) = 0 and no sticking: what a user
    /// hands to an integrator.
    pub fn acceleration(&self) -> impl Fn(f64, f64) -> f64 + Copy + use<> {
        let [spring, stokes, coulomb, newton] = self.coefficients();
        move |x, v| {
            let sign = f64::from(i8::from(v > 0.0) - i8::from(v < 0.0));
            -spring * x - stokes * v - sign * (coulomb + newton * v * v)
        }
    }
}

/// The four reference cases of the library.
pub fn references() -> [Experiment; 4] {
    problems::references().map(|problem| {
        let (oscillator, friction) = (problem.oscillator, *problem.oscillator.friction());
        Experiment {
            name: problem.name,
            mass: oscillator.mass(),
            stiffness: oscillator.stiffness(),
            damping: friction.stokes.map_or(0.0, |law| law.damping()),
            kinetic: friction.coulomb.map_or(0.0, |law| law.kinetic()),
            newton: friction.newton.map_or(0.0, |law| law.coefficient()),
            position: problem.release.position,
        }
    })
}

/// The four mixes without Newton friction, with the coefficients of the reference cases.
pub const LINEAR: [Experiment; 4] = [
    Experiment::with("none", 0.0, 0.0, 0.0),
    Experiment::with("stokes", 0.2, 0.0, 0.0),
    Experiment::with("coulomb", 0.0, 0.02, 0.0),
    Experiment::with("stokes + coulomb", 0.2, 0.02, 0.0),
];

/// The same mixes with friction so weak that the mass still swings after 10⁶ periods.
pub const WEAK_LINEAR: [Experiment; 4] = [
    Experiment::with("none", 0.0, 0.0, 0.0),
    Experiment::with("stokes", 1e-6, 0.0, 0.0),
    Experiment::with("coulomb", 0.0, 4e-9, 0.0),
    Experiment::with("stokes + coulomb", 1e-6, 4e-9, 0.0),
];

/// Weak friction with Newton's law, which swings on for 10⁶ periods.
pub const WEAK_NEWTON: [Experiment; 2] =
    [Experiment::with("newton", 0.0, 0.0, 1e-5), Experiment::with("all three", 1e-6, 4e-9, 1e-5)];

/// Stokes friction 10⁴ times the critical one, and Newton friction: stiff.
pub const STIFF: Experiment = Experiment::with("stokes + newton, ζ = 1e4", 63_245.553, 0.0, 0.235);

/// Rising times of a record that lie on no grid: `duration`·u^1.3.
pub fn uneven_times() -> Vec<f64> {
    let last = (SAMPLES - 1) as f64;
    (0..SAMPLES).map(|i| DURATION * (i as f64 / last).powf(1.3)).collect()
}

/// The same times in no order at all.
pub fn shuffled_times() -> Vec<f64> {
    let times = uneven_times();
    // 4001 and 10,000 have no common divisor, so every index comes once.
    (0..SAMPLES).map(|i| times[i * 4001 % SAMPLES]).collect()
}

/// The exact record on the even grid, from parameters to filled buffers.
///
/// # Errors
/// As [`Motion::sample_even`].
pub fn fill_even(experiment: &Experiment, x: &mut [f64], v: &mut [f64]) -> Result<()> {
    experiment.motion()?.sample_even(DURATION, x, v)
}

/// The exact record at any times, from parameters to filled buffers.
///
/// # Errors
/// As [`Motion::sample`].
pub fn fill_at(experiment: &Experiment, times: &[f64], x: &mut [f64], v: &mut [f64]) -> Result<()> {
    experiment.motion()?.sample(times, x, v)
}
