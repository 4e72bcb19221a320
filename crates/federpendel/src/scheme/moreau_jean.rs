//! Moreau–Jean time stepping: dry friction as an inclusion that the end of each step satisfies, so that
//! the mass sticks by construction.
//!
//! With w = (v₀ + v₁)/2 and the midpoint rule for spring, Stokes and Newton friction,
//!
//! v₁ − v₀ ∈ −h (C/m (x₀ + ½h w) + D/m w + κ w|w| + μF_N/m Sign(v₁)),  x₁ = x₀ + h w,
//!
//! where Sign(0) is all of [−1, 1]. The right-hand side falls with v₁, so there is one solution: v₁ = 0 if
//! friction is strong enough for it, else a root of a quadratic. Second order without dry friction, first
//! order with it. Source: M. Jean, Comput. Methods Appl. Mech. Eng. 177 (1999) 235; V. Acary, B. Brogliato,
//! *Numerical Methods for Nonsmooth Dynamical Systems* (2008), section 10.1.

use super::equation::{EDGE, Equation};
use super::stepper::{Fixed, OneStep};
use super::{DryFriction, Integration, Scheme, Setting, along};
use crate::error::Result;
use crate::oscillator::State;

/// The entry of the list of methods.
pub const SCHEME: Scheme =
    Scheme { name: "moreau-jean", order: 2, adaptive: false, dry: DryFriction::Inclusion, start };

#[derive(Debug, Clone, Copy)]
struct MoreauJean;

impl OneStep<Equation> for MoreauJean {
    #[inline]
    fn step(&self, equation: &Equation, from: State, h: f64) -> State {
        let Equation { spring, stokes, coulomb, holding, newton } = *equation;
        let State { position, velocity } = from;
        // What friction must take off so that v₁ = 0, that is w = v₀/2.
        let half = 0.5 * velocity;
        let free = velocity
            - h * (spring * (position + 0.5 * h * half) + (stokes + newton * half.abs()) * half);
        // What is at rest is held by static friction.
        let strength = h * if velocity == 0.0 { holding * EDGE } else { coulomb };
        if free.abs() <= strength {
            return State { position: position + h * half, velocity: 0.0 };
        }
        // (2 + hD/m + ½h²C/m) w + hκ w|w| = 2v₀ − h C/m x₀ ∓ h μF_N/m.
        let linear = 2.0 + h * stokes + 0.5 * h * h * spring;
        let right = 2.0 * velocity - h * spring * position - free.signum() * h * coulomb;
        let root = (linear * linear + 4.0 * h * newton * right.abs()).sqrt();
        let mean = 2.0 * right / (linear + root);
        State { position: position + h * mean, velocity: 2.0 * mean - velocity }
    }
}

fn start(setting: &Setting) -> Result<Box<dyn Integration>> {
    let stepper = Fixed { method: MoreauJean, time_step: setting.time_step };
    along(setting, Equation::new(&setting.oscillator), stepper)
}
