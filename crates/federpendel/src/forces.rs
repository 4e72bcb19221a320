//! The forces on the mass, one for each cause.

use crate::motion::{Mode, Motion, Sample};

/// The forces on the mass at one time, N, positive towards positive positions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forces {
    /// Of the spring, −C x (article eq. 2).
    pub spring: f64,
    /// Of Stokes friction, −D v (eq. 29).
    pub stokes: f64,
    /// Of Coulomb friction: −sign(v) μ F_N while the mass moves (eq. 55); at rest it holds the spring.
    pub coulomb: f64,
    /// Of Newton friction, −½ρc_wA v|v| (eq. 81).
    pub newton: f64,
}

impl Forces {
    /// All of them together, N.
    pub fn sum(&self) -> f64 {
        self.spring + self.stokes + self.coulomb + self.newton
    }
}

impl Motion {
    /// The forces on the mass in a sample of this motion; at a turning point those just after it.
    pub fn forces(&self, sample: &Sample) -> Forces {
        let oscillator = self.oscillator();
        let friction = oscillator.friction();
        let v = sample.velocity;
        let spring = -oscillator.stiffness() * sample.position;
        let sliding = friction
            .coulomb
            .map_or(0.0, |law| law.kinetic() * law.normal_force().force(oscillator.mass()));
        let coulomb = match sample.mode {
            Mode::Stuck => -spring,
            Mode::Forward => -sliding,
            Mode::Backward => sliding,
        };
        // Adding zero makes a negative zero positive.
        Forces {
            spring: spring + 0.0,
            stokes: -friction.stokes.map_or(0.0, |law| law.damping()) * v + 0.0,
            coulomb: coulomb + 0.0,
            newton: -friction.newton.map_or(0.0, |law| law.coefficient()) * v * v.abs() + 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::friction::{Coulomb, Friction, Newton, NormalForce, Stokes};
    use crate::motion::{Mode, Motion};
    use crate::oscillator::{Oscillator, State};

    /// The acceleration comes from the reduced equation of a swing, the forces from the inputs.
    #[test]
    fn mass_times_acceleration_is_the_sum() {
        let friction = Friction {
            stokes: Some(Stokes::new(0.3).unwrap()),
            coulomb: Some(Coulomb::new(0.02, 0.03, NormalForce::Weight(9.81)).unwrap()),
            newton: Some(Newton::new(0.4).unwrap()),
        };
        let oscillator = Oscillator::new(0.5, 20.0, friction).unwrap();
        let motion = Motion::new(oscillator, State::new(0.2, -0.3).unwrap()).unwrap();
        let mut modes = Vec::new();
        for i in 0..=400 {
            let sample = motion.at(0.02 * f64::from(i)).unwrap();
            let sum = motion.forces(&sample).sum();
            assert!((0.5 * sample.acceleration - sum).abs() < 1e-13, "{sample:?} {sum}");
            modes.push(sample.mode);
        }
        assert!([Mode::Forward, Mode::Backward, Mode::Stuck].iter().all(|m| modes.contains(m)));
    }
}
