//! What the tests of the model share: random motions, and their samples from the core crate.

use federpendel_fit::{Parameters, Quantity, Stop};
use proptest::prelude::*;

pub const QUANTITIES: [Quantity; 3] =
    [Quantity::Position, Quantity::Velocity, Quantity::Acceleration];

/// A motion, and how much of it is recorded.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    pub parameters: Parameters,
    /// μ_s F_N/m.
    pub held: f64,
    /// ω0 times the length of the recording.
    pub length: f64,
}

impl Case {
    pub fn stop(&self) -> Stop {
        Stop::Natural { static_acceleration: self.held }
    }

    /// The larger of |x0| and |v0|/ω0.
    pub fn amplitude(&self) -> f64 {
        let p = &self.parameters;
        p.position0.abs().max(p.velocity0.abs() / p.angular_frequency)
    }

    /// What a recorded quantity is as large as.
    pub fn size(&self, quantity: Quantity) -> f64 {
        let p = &self.parameters;
        let (omega, gamma) = (p.angular_frequency, p.damping_rate);
        // The largest acceleration is that at the release or at the largest extension.
        let drag = p.newton_rate * p.velocity0.powi(2) + 2.0 * gamma * p.velocity0.abs();
        match quantity {
            Quantity::Position => self.amplitude(),
            Quantity::Velocity => self.amplitude() * omega,
            Quantity::Acceleration => {
                self.amplitude() * omega.powi(2) + drag + p.coulomb_acceleration
            }
        }
    }

    /// Times from `first` on, not even.
    pub fn times(&self, first: f64, count: usize) -> Vec<f64> {
        let step = self.length / self.parameters.angular_frequency / (count - 1) as f64;
        let at = |i: usize| i as f64 + if i == 0 { 0.0 } else { 0.3 * (i as f64).sin() };
        (0..count).map(|i| first + step * at(i)).collect()
    }
}

/// What the core crate says that is recorded at the times since the first.
pub fn recorded(p: &Parameters, held: f64, times: &[f64], quantity: Quantity) -> Vec<f64> {
    let since: Vec<f64> = times.iter().map(|t| t - times[0]).collect();
    let value = |sample: federpendel::Sample| match quantity {
        Quantity::Position => sample.position,
        Quantity::Velocity => sample.velocity,
        Quantity::Acceleration => sample.acceleration,
    };
    let samples = p.motion(held).unwrap().samples(&since).unwrap();
    samples.into_iter().map(|sample| value(sample) + p.equilibrium).collect()
}

/// Ten to a power between two.
pub fn scale(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|exponent| 10f64.powf(exponent))
}

/// Zero half of the time.
pub fn often_none(strength: impl Strategy<Value = f64>) -> impl Strategy<Value = f64> {
    (any::<bool>(), strength).prop_map(|(acts, strength)| if acts { strength } else { 0.0 })
}

/// All mixes: damping ratio up to 6, offset up to the amplitude, κ times the amplitude up to 10.
pub fn cases() -> impl Strategy<Value = Case> {
    let shape = (scale(-1.0, 3.0), scale(-3.0, 1.0), 3.0..120.0);
    let near_critical = scale(-16.0, -2.0).prop_map(|gap| 1.0 + gap);
    let damping = prop_oneof![4 => scale(-4.0, 0.8), 1 => near_critical];
    let strengths = (
        often_none(damping),
        often_none(scale(-3.0, 0.0)),
        often_none(scale(-5.0, 1.0)),
        prop_oneof![Just(1.0), 1.0..2.0],
    );
    let release = prop_oneof![
        Just((1.0, 0.0)),
        Just((-1.0, 0.0)),
        Just((0.0, 1.0)),
        (-1.0..1.0, -1.0..1.0f64),
    ];
    (shape, strengths, release, -1.0..1.0).prop_map(
        |((omega, size, length), (zeta, f, drag, held), (x, v), shift)| {
            let a_c = f * size * omega * omega;
            let parameters = Parameters {
                angular_frequency: omega,
                damping_rate: zeta * omega,
                coulomb_acceleration: a_c,
                newton_rate: drag / size,
                position0: x * size,
                velocity0: v * size * omega,
                equilibrium: shift * size,
            };
            Case { parameters, held: a_c * held, length }
        },
    )
}
