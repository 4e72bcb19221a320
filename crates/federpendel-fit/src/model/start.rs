//! Where swings start, and what the parameters do to that.

use super::series::{DIRECTIONS, Law, State};
use super::{Parameters, Stop};

/// Derivatives with respect to the parameters that act on the motion, in their order; the equilibrium does not.
pub(super) type Gradient = [f64; Parameters::COUNT - 1];

/// Places of the parameters in a [`Gradient`].
const OMEGA: usize = 0;
const GAMMA: usize = 1;
const COULOMB: usize = 2;
const KAPPA: usize = 3;
const POSITION: usize = 4;
const VELOCITY: usize = 5;

/// A number and its derivatives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jet {
    pub value: f64,
    pub gradient: Gradient,
}

impl Jet {
    fn parameter(value: f64, index: usize) -> Self {
        let mut gradient = [0.0; 6];
        gradient[index] = 1.0;
        Jet { value, gradient }
    }

    /// `a`·self + `b`·other for numbers a and b.
    fn combined(&self, a: f64, other: &Jet, b: f64) -> Jet {
        Jet {
            value: a * self.value + b * other.value,
            gradient: std::array::from_fn(|k| a * self.gradient[k] + b * other.gradient[k]),
        }
    }
}

/// The release or a turning point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    /// Number of turning points up to here.
    pub number: u64,
    /// Time since the first sample, s.
    pub time: Jet,
    /// Position from the middle.
    pub x: Jet,
    /// Velocity over ω0.
    w: Jet,
}

/// The coefficients that all swings share.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reduced {
    pub omega: f64,
    pub law: Law,
    /// Derivatives of ζ = γ/ω0.
    zeta: Gradient,
    /// f = a_c/ω0².
    pub offset: Jet,
    /// Half width of the band of places where the mass stays.
    band: f64,
    /// Number of the turning point where it stays at the latest.
    last: u64,
}

impl Reduced {
    pub fn new(parameters: &Parameters, stop: Stop) -> Self {
        let omega = parameters.angular_frequency;
        let zeta = parameters.damping_rate / omega;
        let offset = parameters.coulomb_acceleration / (omega * omega);
        let (mut zeta_gradient, mut offset_gradient) = ([0.0; 6], [0.0; 6]);
        (zeta_gradient[OMEGA], zeta_gradient[GAMMA]) = (-zeta / omega, 1.0 / omega);
        offset_gradient[OMEGA] = -2.0 * offset / omega;
        offset_gradient[COULOMB] = 1.0 / (omega * omega);
        let (held, last) = match stop {
            Stop::Natural { static_acceleration } => (static_acceleration, u64::MAX),
            Stop::After(last) => (0.0, last),
            Stop::Never => (0.0, u64::MAX),
        };
        Reduced {
            omega,
            law: Law { damping: 2.0 * zeta, kappa: parameters.newton_rate },
            zeta: zeta_gradient,
            offset: Jet { value: offset, gradient: offset_gradient },
            band: offset.max(held / (omega * omega)),
            last,
        }
    }
}

impl Start {
    pub fn release(parameters: &Parameters) -> Self {
        let omega = parameters.angular_frequency;
        let mut w = Jet::parameter(parameters.velocity0 / omega, VELOCITY);
        (w.gradient[OMEGA], w.gradient[VELOCITY]) = (-w.value / omega, 1.0 / omega);
        Start {
            number: 0,
            time: Jet { value: 0.0, gradient: [0.0; 6] },
            x: Jet::parameter(parameters.position0, POSITION),
            w,
        }
    }

    /// Whether the mass stays here.
    pub fn rests(&self, reduced: &Reduced) -> bool {
        let turns = self.w.value == 0.0;
        turns && (self.number >= reduced.last || self.x.value.abs() <= reduced.band)
    }

    /// The frame of the swing from here.
    pub fn frame(&self, reduced: &Reduced) -> Frame {
        let way = if self.w.value == 0.0 { -self.x.value } else { self.w.value };
        let side = -way.signum();
        let y = self.x.combined(side, &reduced.offset, -1.0);
        let mut law = [0.0; 6];
        law[KAPPA] = 1.0;
        Frame {
            side,
            y: y.value,
            w: side * self.w.value,
            inputs: [y.gradient, self.w.gradient.map(|w| side * w), reduced.zeta, law],
        }
    }

    /// The turning point that ends the swing from here, `tau` after its start.
    pub fn turn<const D: usize>(
        &self,
        reduced: &Reduced,
        frame: &Frame,
        tau: f64,
        end: &State<D>,
    ) -> Start {
        let omega = reduced.omega;
        let mut time = self.time;
        time.value += tau / omega;
        time.gradient[OMEGA] -= tau / (omega * omega);
        // The reversal comes later by −dw/w′, and w′ is −y there; y does not change in that time.
        let later = frame.chain(&end.dw);
        for (time, dw) in time.gradient.iter_mut().zip(later) {
            *time += dw / (end.y * omega);
        }
        let y = Jet { value: end.y, gradient: frame.chain(&end.dy) };
        Start {
            number: self.number + 1,
            time,
            x: y.combined(frame.side, &reduced.offset, frame.side),
            w: Jet { value: 0.0, gradient: [0.0; 6] },
        }
    }
}

/// The frame that a swing is computed in: x = `side`·(y + f), the mass moving in the negative direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub side: f64,
    /// Where the swing starts.
    pub y: f64,
    pub w: f64,
    /// Derivatives of what the swing depends on: y and w at its start, ζ, κ.
    inputs: [Gradient; DIRECTIONS],
}

impl Frame {
    /// Derivatives with respect to the parameters of what has these with respect to the inputs of the swing.
    #[inline(always)]
    pub fn chain<const D: usize>(&self, directions: &[f64; D]) -> Gradient {
        let mut gradient = [0.0; 6];
        for (direction, input) in directions.iter().zip(&self.inputs) {
            for (sum, input) in gradient.iter_mut().zip(input) {
                *sum += direction * input;
            }
        }
        gradient
    }
}
