//! How long the step may be before the scheme runs away.

use super::Scheme;
use crate::oscillator::{Oscillator, State};

impl Scheme {
    /// The time step, s, below which what the scheme makes of this motion stays bounded. The article
    /// gives no limit.
    ///
    /// For a linear oscillator (51) is z² − (2 − a − b)z + 1 − b = 0 with a = ω0²Δt², b = 2γΔt, whose
    /// roots lie within the unit circle if and only if a + 2b < 4 (Jury's criterion), that is
    /// Δt < 2/(γ + √(γ² + ω0²)). Newton friction enters with the slope κ|v| of its
    /// force at the greatest speed that the energy allows, which is on the safe side. Coulomb friction has
    /// no slope.
    pub fn longest_stable_step(oscillator: &Oscillator, release: State) -> f64 {
        let speed = (2.0 * oscillator.energy(release) / oscillator.mass()).sqrt();
        let gamma = oscillator.damping_rate() + oscillator.newton_rate() * speed;
        2.0 / (gamma + gamma.hypot(oscillator.angular_frequency()))
    }
}
