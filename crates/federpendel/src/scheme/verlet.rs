//! Velocity Verlet for forces that depend on velocity:
//! x₁ = x₀ + h v₀ + ½h² a₀, v* = v₀ + h a₀, v₁ = v₀ + ½h (a₀ + a(x₁, v*)).
//!
//! Second order where the force is smooth. Source: W. C. Swope et al., J. Chem. Phys. 76 (1982) 637; with the
//! predicted velocity R. D. Groot, P. B. Warren, J. Chem. Phys. 107 (1997) 4423, eq. 14 with λ = 1.

use super::equation::Field;
use super::stepper::{Fixed, OneStep};
use super::{DryFriction, Scheme, Setting, located, plain};
use crate::oscillator::State;

/// The entry of the list of methods.
pub const SCHEME: Scheme = Scheme {
    name: "verlet",
    order: 2,
    adaptive: false,
    dry: DryFriction::Sign,
    start: |setting| plain(setting, stepper(setting)),
};

/// The same with located reversals.
pub const LOCATED: Scheme = Scheme {
    name: "verlet-located",
    dry: DryFriction::Located,
    start: |setting| located(setting, stepper(setting)),
    ..SCHEME
};

#[derive(Debug, Clone, Copy)]
struct Verlet;

impl<F: Field> OneStep<F> for Verlet {
    #[inline]
    fn step(&self, field: &F, from: State, h: f64) -> State {
        let before = field.acceleration(from);
        let position = from.position + h * (from.velocity + 0.5 * h * before);
        let predicted = State { position, velocity: from.velocity + h * before };
        let after = field.acceleration(predicted);
        State { position, velocity: from.velocity + 0.5 * h * (before + after) }
    }
}

fn stepper(setting: &Setting) -> Fixed<Verlet> {
    Fixed { method: Verlet, time_step: setting.time_step }
}
