//! The classical Runge–Kutta method of fourth order, with dry friction in three readings.
//!
//! Source: W. Kutta, Z. Math. Phys. 46 (1901) 435; E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary
//! Differential Equations I*, 2nd ed. (1993), table II.1.2.

use super::equation::{Equation, Field, Smoothed};
use super::stepper::{Fixed, OneStep, shifted, slope};
use super::{DryFriction, Integration, Scheme, Setting, along, located, plain};
use crate::error::Result;
use crate::oscillator::State;

/// The entry of the list of methods.
pub const SCHEME: Scheme = Scheme {
    name: "rk4",
    order: 4,
    adaptive: false,
    dry: DryFriction::Sign,
    start: |setting| plain(setting, stepper(setting)),
};

/// The same with located reversals.
pub const LOCATED: Scheme = Scheme {
    name: "rk4-located",
    dry: DryFriction::Located,
    start: |setting| located(setting, stepper(setting)),
    ..SCHEME
};

/// The same with dry friction made smooth.
pub const SMOOTHED: Scheme =
    Scheme { name: "rk4-tanh", dry: DryFriction::Smoothed, start: smoothed, ..SCHEME };

#[derive(Debug, Clone, Copy)]
struct Rk4;

impl<F: Field> OneStep<F> for Rk4 {
    #[inline]
    fn step(&self, field: &F, from: State, h: f64) -> State {
        let first = slope(field, from);
        let second = slope(field, shifted(from, 0.5 * h, &[first], &[1.0]));
        let third = slope(field, shifted(from, 0.5 * h, &[second], &[1.0]));
        let fourth = slope(field, shifted(from, h, &[third], &[1.0]));
        shifted(from, h / 6.0, &[first, second, third, fourth], &[1.0, 2.0, 2.0, 1.0])
    }
}

fn stepper(setting: &Setting) -> Fixed<Rk4> {
    Fixed { method: Rk4, time_step: setting.time_step }
}

fn smoothed(setting: &Setting) -> Result<Box<dyn Integration>> {
    let field = Smoothed { equation: Equation::new(&setting.oscillator), width: setting.width };
    along(setting, field, stepper(setting))
}
