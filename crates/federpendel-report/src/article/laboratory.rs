//! The experiment that the report is about, taken apart into the experiments of the article, each with one law
//! of friction.

use federpendel::scheme::Setting;
use federpendel::{
    Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, Result, State, Stokes, parameter,
};

/// The built-in coefficients, for laws that the experiment lacks.
const DAMPING: f64 = 0.2;
const KINETIC: f64 = 0.02;
const DRAG: f64 = 0.235;

/// The same laws as shares of what the spring does, as they are in the built-in experiment (0.5 kg, 20 N/m, 10 cm):
/// γ/ω0, f over the amplitude, κ times the amplitude.
const DAMPING_RATIO: f64 = 0.0316;
const OFFSET_SHARE: f64 = 0.049;
const DRAG_SHARE: f64 = 0.047;

/// A built-in coefficient serves where its share is at most this: then a mass swings, and more than once.
const LARGEST_SHARE: f64 = 0.25;

/// Of a law that has less than this part of the usual share nothing would be seen.
const FAINT: f64 = 1e-3;

/// A release is from rest, or from the middle, where the other of x0 and v0/ω0 is less than this part of the
/// amplitude.
const SLIGHT: f64 = 1e-3;

/// Where a mass is released that the experiment leaves in the middle at rest, m.
const POSITION: f64 = 0.1;

/// One oscillator with one law of friction, or none, and one release.
#[derive(Debug)]
pub struct Case {
    /// The exact motion; it knows its oscillator and its release.
    pub motion: Motion,
    /// Length of the record that shows it, s.
    pub duration: f64,
    /// Whether the coefficient of friction is built in, because the experiment lacks this law or has hardly any of
    /// it.
    pub built_in: bool,
}

/// Everything that the report is about.
#[derive(Debug)]
pub struct Laboratory {
    /// The experiment as it was given, all its laws together.
    pub own: Case,
    /// Without friction, with an initial velocity.
    pub undamped: Case,
    /// Stokes friction alone.
    pub stokes: Case,
    /// Coulomb friction alone, released from rest.
    pub coulomb: Case,
    /// Coulomb friction alone, with initial velocities against and along the displacement.
    pub thrown: [Case; 2],
    /// Newton friction alone, with an initial velocity.
    pub newton: Case,
    /// Whether the experiment has no release of its own, so that a built-in one is taken.
    pub built_in_release: bool,
    /// Whether the initial velocity of [`undamped`](Self::undamped), [`thrown`](Self::thrown) and
    /// [`newton`](Self::newton) is an added one.
    pub added_velocity: bool,
    /// Whether their displacement, and that of [`coulomb`](Self::coulomb), is an added one.
    pub added_position: bool,
    /// The drag coefficient c_w, if the experiment gives it.
    pub drag_coefficient: Option<f64>,
    /// Whether something else than its own weight presses the mass on its guide.
    pub pressed: bool,
}

impl Case {
    fn new(
        oscillator: Oscillator,
        release: State,
        built_in: bool,
        duration: Option<f64>,
    ) -> Result<Self> {
        let motion = Motion::new(oscillator, release)?;
        let duration = duration.unwrap_or_else(|| motion.default_duration());
        Ok(Case { motion, duration, built_in })
    }

    /// A motion in its usual record.
    pub(crate) fn on(motion: Motion) -> Self {
        let duration = motion.default_duration();
        Case { motion, duration, built_in: false }
    }

    /// What the numeric methods integrate, and how finely.
    pub(crate) fn setting(&self) -> Setting {
        Setting::of(&self.motion)
    }

    /// The same mass and spring with Stokes friction alone, γ = `ratio` ω0.
    pub(crate) fn damped(&self, ratio: f64) -> Result<Oscillator> {
        let (mass, stiffness) = (self.oscillator().mass(), self.oscillator().stiffness());
        let critical = critical_damping(self.oscillator());
        Oscillator::new(mass, stiffness, Stokes::new(ratio * critical)?)
    }

    /// The oscillator.
    pub fn oscillator(&self) -> &Oscillator {
        self.motion.oscillator()
    }

    /// The release.
    pub fn release(&self) -> State {
        self.motion.release()
    }
}

impl Laboratory {
    /// The experiment with `oscillator` and `release`; `normal_force` presses the mass, whether or not Coulomb
    /// friction acts; `duration` is the length of the record (s) and `drag_coefficient` is c_w, if the experiment says.
    ///
    /// # Errors
    /// What the core refuses.
    pub fn new(
        oscillator: Oscillator,
        normal_force: NormalForce,
        release: State,
        duration: Option<f64>,
        drag_coefficient: Option<f64>,
    ) -> Result<Self> {
        let bench = Bench::new(oscillator, normal_force, release)?;
        let from_rest = State { position: bench.position, velocity: 0.0 };
        let velocity = bench.velocity.abs();
        let general = State { velocity: bench.velocity, ..from_rest };
        let thrown = |velocity| {
            let (law, built_in) = bench.coulomb()?;
            Case::new(bench.with(law)?, State { velocity, ..from_rest }, built_in, None)
        };
        let (stokes, without_stokes) = bench.stokes()?;
        let (coulomb, without_coulomb) = bench.coulomb()?;
        let (newton, without_newton) = bench.newton()?;
        let sign = from_rest.position.signum();
        Ok(Laboratory {
            own: Case::new(oscillator, bench.release, false, duration)?,
            undamped: Case::new(bench.with(Friction::NONE)?, general, false, None)?,
            stokes: Case::new(bench.with(stokes)?, bench.release, without_stokes, None)?,
            coulomb: Case::new(bench.with(coulomb)?, from_rest, without_coulomb, None)?,
            thrown: [thrown(-sign * velocity)?, thrown(sign * velocity)?],
            newton: Case::new(bench.with(newton)?, general, without_newton, None)?,
            built_in_release: bench.built_in_release,
            added_position: bench.position != bench.release.position,
            added_velocity: bench.velocity != bench.release.velocity,
            drag_coefficient,
            pressed: matches!(normal_force, NormalForce::Given(_)),
        })
    }
}

/// Mass and spring, and which laws can be put to them.
struct Bench {
    oscillator: Oscillator,
    normal_force: NormalForce,
    /// max(|x0|, |v0|/ω0), m.
    amplitude: f64,
    /// As it is given, or else the built-in one.
    release: State,
    /// x0, or where it is slight the amplitude, m.
    position: f64,
    /// v0, or where it is slight one of about half the speed that the spring gives, against the displacement, m/s.
    velocity: f64,
    built_in_release: bool,
}

impl Bench {
    fn new(oscillator: Oscillator, normal_force: NormalForce, release: State) -> Result<Self> {
        let omega0 = oscillator.angular_frequency();
        let built_in_release = release.position == 0.0 && release.velocity == 0.0;
        let release = if built_in_release { State::new(POSITION, 0.0)? } else { release };
        let amplitude = release.position.abs().max(release.velocity.abs() / omega0);
        let slight = |length: f64| length.abs() < SLIGHT * amplitude;
        let position = if slight(release.position) { amplitude } else { release.position };
        let added = -position.signum() * one_digit(0.5 * omega0 * amplitude);
        let velocity = if slight(release.velocity / omega0) { added } else { release.velocity };
        let normal_force = match normal_force {
            NormalForce::Weight(gravity) if gravity > 0.0 => normal_force,
            NormalForce::Given(force) if force > 0.0 => normal_force,
            _ => NormalForce::Weight(parameter::GRAVITY.default.unwrap_or(1.0)),
        };
        Ok(Bench {
            oscillator,
            normal_force,
            amplitude,
            release,
            position,
            velocity,
            built_in_release,
        })
    }

    /// The mass and the spring with this friction.
    fn with(&self, friction: impl Into<Friction>) -> Result<Oscillator> {
        Oscillator::new(self.oscillator.mass(), self.oscillator.stiffness(), friction)
    }

    /// The experiment's own Stokes friction, or else the built-in one; and whether it is that.
    fn stokes(&self) -> Result<(Stokes, bool)> {
        let critical = critical_damping(&self.oscillator);
        let acts = |law: &Stokes| law.damping() >= FAINT * DAMPING_RATIO * critical;
        if let Some(law) = self.oscillator.friction().stokes.filter(acts) {
            return Ok((law, false));
        }
        Ok((Stokes::new(built_in(DAMPING, critical, DAMPING_RATIO))?, true))
    }

    /// As [`Bench::stokes`] for Coulomb friction.
    fn coulomb(&self) -> Result<(Coulomb, bool)> {
        let least = FAINT * OFFSET_SHARE * self.amplitude;
        let acts = |_: &Coulomb| self.oscillator.offset() >= least;
        if let Some(law) = self.oscillator.friction().coulomb.filter(acts) {
            return Ok((law, false));
        }
        let force = self.normal_force.force(self.oscillator.mass());
        let largest = self.oscillator.stiffness() * self.amplitude / force;
        let kinetic = built_in(KINETIC, largest, OFFSET_SHARE);
        Ok((Coulomb::new(kinetic, kinetic, self.normal_force)?, true))
    }

    /// As [`Bench::stokes`] for Newton friction.
    fn newton(&self) -> Result<(Newton, bool)> {
        let unit = self.oscillator.mass() / self.amplitude;
        let acts = |law: &Newton| law.coefficient() >= FAINT * DRAG_SHARE * unit;
        if let Some(law) = self.oscillator.friction().newton.filter(acts) {
            return Ok((law, false));
        }
        Ok((Newton::new(built_in(DRAG, unit, DRAG_SHARE))?, true))
    }
}

/// The built-in coefficient; or, where it is more than [`LARGEST_SHARE`] or less than a hundredth of the usual share of
/// `whole`, so that there would be nothing to see, the one that has the usual share.
fn built_in(coefficient: f64, whole: f64, share: f64) -> f64 {
    let fits = (0.01 * share..=LARGEST_SHARE).contains(&(coefficient / whole));
    if fits { coefficient } else { one_digit(share * whole) }
}

/// The damping D at which γ = ω0, kg/s.
fn critical_damping(oscillator: &Oscillator) -> f64 {
    Stokes::critical_damping(oscillator.mass(), oscillator.stiffness())
}

/// A number rounded to its leading digit.
pub fn one_digit(value: f64) -> f64 {
    format!("{value:.0e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laboratory(mass: f64, stiffness: f64, friction: Friction, x0: f64, v0: f64) -> Laboratory {
        let oscillator = Oscillator::new(mass, stiffness, friction).unwrap();
        let release = State::new(x0, v0).unwrap();
        Laboratory::new(oscillator, NormalForce::Weight(9.81), release, None, None).unwrap()
    }

    #[test]
    fn the_built_in_experiment_has_the_reference_coefficients() {
        let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81)).unwrap();
        let lab = laboratory(0.5, 20.0, dry.into(), 0.1, 0.0);
        assert_eq!(lab.stokes.oscillator().friction().stokes.unwrap().damping(), 0.2);
        assert_eq!(lab.newton.oscillator().friction().newton.unwrap().coefficient(), 0.235);
        assert_eq!(lab.coulomb.oscillator().friction().coulomb, Some(dry));
        assert_eq!(lab.thrown.each_ref().map(|case| case.release().velocity), [-0.3, 0.3]);
        assert!(lab.stokes.built_in && lab.newton.built_in && !lab.coulomb.built_in);
    }

    #[test]
    fn every_law_lets_any_mass_swing() {
        for (mass, stiffness, x0, v0) in [
            (1e-9, 1.0, 1e-6, 0.0),
            (2e4, 3e6, 0.0, -0.02),
            (0.2, 3.0, -0.05, 0.0),
            (1.0, 1.0, 0.0, 0.0),
        ] {
            let lab = laboratory(mass, stiffness, Friction::NONE, x0, v0);
            for case in [&lab.stokes, &lab.coulomb, &lab.newton] {
                assert!(case.built_in);
                assert!(
                    case.motion.turning_points().take(2).count() == 2,
                    "{mass} {:?}",
                    case.oscillator()
                );
                assert!(case.motion.amplitude() > 0.0);
            }
        }
    }
}
