//! What the model depends on.

use federpendel::{Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, State, Stokes};

/// The parameters of a free decay, in reduced units; lengths are in the unit of the recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// ω0, 1/s.
    pub angular_frequency: f64,
    /// γ, 1/s, at least zero.
    pub damping_rate: f64,
    /// a_c = μ_k F_N/m, at least zero.
    pub coulomb_acceleration: f64,
    /// κ, over a length, at least zero.
    pub newton_rate: f64,
    /// Position at the first time of the recording, from the middle.
    pub position0: f64,
    /// Velocity there.
    pub velocity0: f64,
    /// What the sensor shows where the mass would rest without friction: added to the recorded quantity.
    pub equilibrium: f64,
}

impl Parameters {
    /// Their names, in the order of the fields.
    pub const NAMES: [&str; 7] = [
        "angular_frequency",
        "damping_rate",
        "coulomb_acceleration",
        "newton_rate",
        "position0",
        "velocity0",
        "equilibrium",
    ];

    /// How many there are.
    pub const COUNT: usize = 7;

    /// The motion from the first time of the recording on, of a mass of 1 kg held by static friction up to
    /// `static_acceleration`.
    ///
    /// # Errors
    /// As [`Motion::new`], if a parameter is out of range.
    pub fn motion(&self, static_acceleration: f64) -> federpendel::Result<Motion> {
        let dry = self.coulomb_acceleration;
        // γ = D/(2m), a_c = μ_k F_N/m with F_N = 1 N, κ = ½ρc_wA/m.
        let friction = Friction {
            stokes: Some(Stokes::new(2.0 * self.damping_rate)?),
            coulomb: Some(Coulomb::new(
                dry,
                static_acceleration.max(dry),
                NormalForce::Given(1.0),
            )?),
            newton: Some(Newton::new(self.newton_rate)?),
        };
        let oscillator = Oscillator::new(1.0, self.angular_frequency.powi(2), friction)?;
        Motion::new(oscillator, State::new(self.position0, self.velocity0)?)
    }

    /// They in the order of the fields, which is that of the columns of a [`Jacobian`](super::Jacobian).
    pub fn to_array(&self) -> [f64; Self::COUNT] {
        [
            self.angular_frequency,
            self.damping_rate,
            self.coulomb_acceleration,
            self.newton_rate,
            self.position0,
            self.velocity0,
            self.equilibrium,
        ]
    }

    /// The parameters with these values, in the order of the fields.
    pub fn from_array(values: [f64; Self::COUNT]) -> Self {
        let [
            angular_frequency,
            damping_rate,
            coulomb_acceleration,
            newton_rate,
            position0,
            velocity0,
            equilibrium,
        ] = values;
        Parameters {
            angular_frequency,
            damping_rate,
            coulomb_acceleration,
            newton_rate,
            position0,
            velocity0,
            equilibrium,
        }
    }
}

/// How the motion ends. Whatever is chosen, the mass stays at a turning point that the spring cannot move it
/// from against kinetic friction, ω0²|x| ≤ a_c. A release without velocity is the turning point number 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stop {
    /// The mass stays at the first turning point with ω0²|x| at most this acceleration.
    Natural {
        /// μ_s F_N/m.
        static_acceleration: f64,
    },
    /// The mass stays at its turning point of this number, the first being 1, whatever the forces.
    After(u64),
    /// It never stays.
    Never,
}
