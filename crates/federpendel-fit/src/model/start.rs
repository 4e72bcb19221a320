//! Where swings start, and what the parameters do to that.

use super::series::{DIRECTIONS, Law, State};
use super::{Parameters, Stop};

/// A number and its derivatives with respect to the parameters, in their order.
pub(super) type Jet = [f64; Parameters::COUNT + 1];

/// Places in a [`Jet`].
pub(super) const VALUE: usize = 0;
pub(super) const OMEGA: usize = 1;
const GAMMA: usize = 2;
const COULOMB: usize = 3;
const KAPPA: usize = 4;
const POSITION: usize = 5;
const VELOCITY: usize = 6;
const EQUILIBRIUM: usize = 7;

/// The jet with these entries, all others being zero.
fn jet<const N: usize>(entries: [(usize, f64); N]) -> Jet {
    let mut jet = Jet::default();
    for (place, entry) in entries {
        jet[place] = entry;
    }
    jet
}

/// `a`·`x` + `b`·`y` for numbers a and b.
fn combined(a: f64, x: &Jet, b: f64, y: &Jet) -> Jet {
    std::array::from_fn(|k| a * x[k] + b * y[k])
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
    /// ζ = γ/ω0.
    zeta: Jet,
    /// f = a_c/ω0².
    pub offset: Jet,
    pub equilibrium: Jet,
    /// Half width of the band of places where the mass stays.
    band: f64,
    /// Number of the turning point where it stays at the latest.
    last: u64,
}

impl Reduced {
    pub fn new(parameters: &Parameters, stop: Stop) -> Self {
        let omega = parameters.angular_frequency;
        let zeta = parameters.damping_rate / omega;
        let unit = omega * omega;
        let offset = parameters.coulomb_acceleration / unit;
        let (held, last) = match stop {
            Stop::Natural { static_acceleration } => (static_acceleration, u64::MAX),
            Stop::After(last) => (0.0, last),
            Stop::Never => (0.0, u64::MAX),
        };
        Reduced {
            omega,
            law: Law { damping: 2.0 * zeta, kappa: parameters.newton_rate },
            zeta: jet([(VALUE, zeta), (OMEGA, -zeta / omega), (GAMMA, 1.0 / omega)]),
            offset: jet([(VALUE, offset), (OMEGA, -2.0 * offset / omega), (COULOMB, 1.0 / unit)]),
            equilibrium: jet([(VALUE, parameters.equilibrium), (EQUILIBRIUM, 1.0)]),
            band: offset.max(held / unit),
            last,
        }
    }
}

impl Start {
    pub fn release(parameters: &Parameters) -> Self {
        let omega = parameters.angular_frequency;
        let w = parameters.velocity0 / omega;
        Start {
            number: 0,
            time: Jet::default(),
            x: jet([(VALUE, parameters.position0), (POSITION, 1.0)]),
            w: jet([(VALUE, w), (OMEGA, -w / omega), (VELOCITY, 1.0 / omega)]),
        }
    }

    /// Whether the mass stays here. Unlike the core crate this knows no ties: which side of the edge of the band rounding
    /// takes is within the noise of a recording.
    pub fn rests(&self, reduced: &Reduced) -> bool {
        let turns = self.w[VALUE] == 0.0;
        turns && (self.number >= reduced.last || self.x[VALUE].abs() <= reduced.band)
    }

    /// The frame of the swing from here.
    pub fn frame(&self, reduced: &Reduced) -> Frame {
        let (x, w) = (self.x[VALUE], self.w[VALUE]);
        let side = -(if w == 0.0 { -x } else { w }).signum();
        let y = combined(side, &self.x, -1.0, &reduced.offset);
        let w = self.w.map(|w| side * w);
        let mut inputs = [y, w, reduced.zeta, jet([(KAPPA, 1.0)])];
        for input in &mut inputs {
            input[VALUE] = 0.0;
        }
        Frame { side, y: y[VALUE], w: w[VALUE], inputs }
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
        time[VALUE] += tau / omega;
        time[OMEGA] -= tau / (omega * omega);
        // The reversal comes later by −dw/w′, and w′ is −y there; y does not change in that time.
        for (time, dw) in time.iter_mut().zip(frame.chain(&end.dw)) {
            *time += dw / (end.y * omega);
        }
        let mut y = frame.chain(&end.dy);
        y[VALUE] = end.y;
        Start {
            number: self.number + 1,
            time,
            x: combined(frame.side, &y, frame.side, &reduced.offset),
            w: Jet::default(),
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
    /// Derivatives, without the values, of what the swing depends on: y and w at its start, ζ, κ.
    inputs: [Jet; DIRECTIONS],
}

impl Frame {
    /// Derivatives with respect to the parameters of what has these with respect to the inputs of the swing; its value
    /// is left to be filled in.
    #[inline(always)]
    pub fn chain<const D: usize>(&self, directions: &[f64; D]) -> Jet {
        let mut jet = Jet::default();
        for (direction, input) in directions.iter().zip(&self.inputs) {
            for (sum, input) in jet.iter_mut().zip(input) {
                *sum += direction * input;
            }
        }
        jet
    }
}
