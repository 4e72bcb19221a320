//! Symplectic (semi-implicit) Euler: v₁ = v₀ + h a(x₀, v₀), x₁ = x₀ + h v₁.
//!
//! First order; without friction its energy swings about the true one instead of growing. The workhorse of
//! game engines. Source: E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical Integration*, 2nd ed.
//! (2006), eq. I.1.9.

use super::equation::Field;
use super::stepper::{Fixed, OneStep};
use super::{DryFriction, Integration, Scheme, Setting, plain};
use crate::error::Result;
use crate::oscillator::State;

/// The entry of the list of methods.
pub const SCHEME: Scheme =
    Scheme { name: "symplectic-euler", order: 1, adaptive: false, dry: DryFriction::Sign, start };

#[derive(Debug, Clone, Copy)]
struct SymplecticEuler;

impl<F: Field> OneStep<F> for SymplecticEuler {
    #[inline]
    fn step(&self, field: &F, from: State, h: f64) -> State {
        let velocity = from.velocity + h * field.acceleration(from);
        State { position: from.position + h * velocity, velocity }
    }
}

fn start(setting: &Setting) -> Result<Box<dyn Integration>> {
    plain(setting, Fixed { method: SymplecticEuler, time_step: setting.time_step })
}
