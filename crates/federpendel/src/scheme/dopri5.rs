//! The Runge–Kutta pair of Dormand and Prince, orders 5 and 4, with a step size that follows a tolerance and
//! dense output of order 4.
//!
//! Source: J. R. Dormand, P. J. Prince, J. Comput. Appl. Math. 6 (1980) 19; step size control and dense output
//! as in E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd ed. (1993),
//! sections II.4 and II.6.

use super::equation::Field;
use super::stepper::{Path, Stepper, shifted, slope};
use super::{DryFriction, Scheme, Setting, located, plain};
use crate::error::{Error, Result};
use crate::oscillator::State;

/// The entry of the list of methods.
pub const SCHEME: Scheme = Scheme {
    name: "dopri5",
    order: 5,
    adaptive: true,
    dry: DryFriction::Sign,
    start: |setting| plain(setting, Dopri5::new(setting)),
};

/// The same with located reversals.
pub const LOCATED: Scheme = Scheme {
    name: "dopri5-located",
    dry: DryFriction::Located,
    start: |setting| located(setting, Dopri5::new(setting)),
    ..SCHEME
};

/// Coefficients of stages 2 to 7; those of the last are the weights of the fifth order.
const A2: [f64; 1] = [1.0 / 5.0];
const A3: [f64; 2] = [3.0 / 40.0, 9.0 / 40.0];
const A4: [f64; 3] = [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0];
const A5: [f64; 4] = [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0];
const A6: [f64; 5] =
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0];
const A7: [f64; 6] =
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
/// Fifth order minus fourth.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];
/// The fourth-order term of the dense output.
const DENSE: [f64; 7] = [
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

/// A step changes at most by these factors.
const SMALLEST: f64 = 0.2;
const LARGEST: f64 = 5.0;
/// It aims a little below the tolerance.
const SAFETY: f64 = 0.9;

#[derive(Debug, Clone, Copy)]
struct Dopri5 {
    /// Error allowed in a step: of positions, m, and of velocities, m/s.
    allowed: State,
    /// The step to try next, s.
    next: f64,
}

impl Dopri5 {
    fn new(setting: &Setting) -> Self {
        let omega = setting.oscillator.angular_frequency();
        let position = setting.tolerance * setting.amplitude();
        Dopri5 {
            allowed: State { position, velocity: position * omega },
            next: 0.1 * setting.tolerance.powf(0.2) / omega,
        }
    }

    /// The error of a step over the one allowed.
    fn excess(&self, error: State) -> f64 {
        (error.position / self.allowed.position).hypot(error.velocity / self.allowed.velocity)
            * std::f64::consts::FRAC_1_SQRT_2
    }
}

impl<F: Field> Stepper<F> for Dopri5 {
    type Path = Dense;

    fn time_step(&self) -> Option<f64> {
        None
    }

    fn advance(&mut self, field: &F, time: f64, from: State, longest: f64) -> Result<Dense> {
        loop {
            let step = self.next.min(longest);
            if step <= 4.0 * f64::EPSILON * time || !step.is_normal() {
                return Err(Error::StepUnderflow { time, step });
            }
            let (path, error) = attempt(field, from, step);
            let excess = self.excess(error);
            // An error that is no number is too large.
            let factor = if excess.is_finite() { SAFETY * excess.powf(-0.2) } else { SMALLEST };
            self.next = step * factor.clamp(SMALLEST, LARGEST);
            if excess <= 1.0 {
                return Ok(path);
            }
        }
    }
}

/// A step of `duration` with its dense output, and the estimate of its error.
fn attempt(field: &impl Field, from: State, duration: f64) -> (Dense, State) {
    let stage = |state| slope(field, state);
    let k1 = stage(from);
    let k2 = stage(shifted(from, duration, &[k1], &A2));
    let k3 = stage(shifted(from, duration, &[k1, k2], &A3));
    let k4 = stage(shifted(from, duration, &[k1, k2, k3], &A4));
    let k5 = stage(shifted(from, duration, &[k1, k2, k3, k4], &A5));
    let k6 = stage(shifted(from, duration, &[k1, k2, k3, k4, k5], &A6));
    let to = shifted(from, duration, &[k1, k2, k3, k4, k5, k6], &A7);
    let slopes = [k1, k2, k3, k4, k5, k6, stage(to)];
    let zero = State { position: 0.0, velocity: 0.0 };
    let error = shifted(zero, duration, &slopes, &ERROR);
    let bend = shifted(zero, duration, &slopes, &DENSE);
    (Dense { from, to, first: k1, last: slopes[6], bend, duration }, error)
}

/// Dense output: the cubic through states and slopes of both ends, and a term of fourth order.
#[derive(Debug, Clone, Copy)]
pub struct Dense {
    from: State,
    to: State,
    first: State,
    last: State,
    bend: State,
    duration: f64,
}

impl Path for Dense {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn at(&self, after: f64) -> State {
        let theta = after / self.duration;
        let part = |get: fn(&State) -> f64| {
            let difference = get(&self.to) - get(&self.from);
            let early = self.duration * get(&self.first) - difference;
            let late = difference - self.duration * get(&self.last) - early;
            let rest = late + (1.0 - theta) * get(&self.bend);
            let bent = early + theta * rest;
            get(&self.from) + theta * (difference + (1.0 - theta) * bent)
        };
        State { position: part(|state| state.position), velocity: part(|state| state.velocity) }
    }
}
