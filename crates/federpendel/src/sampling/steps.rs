//! The linear motion from one sample of an even grid to others.

use crate::double::Double;
use crate::oscillator::Reduced;
use crate::sampling::lanes::{LANES, Lanes, each, mul_add, sin_cos_of_multiples};
use crate::swing::linear::Transfer;

/// Samples of a group: [`LANES`] blocks of [`LANES`] samples.
const GROUP: usize = LANES * LANES;
/// Samples of a span: [`LANES`] groups.
const SPAN: usize = LANES * GROUP;

/// What leads from a sample to the others of its span: over 0, 1, … samples, blocks and groups.
#[derive(Debug, Clone)]
pub(crate) struct Steps {
    step: Step,
    pub samples: Transfers,
    pub blocks: Transfers,
    pub groups: Transfers,
}

impl Steps {
    /// On a grid with the time `tau` = ω0 t between samples, where the motion swings.
    pub fn new(reduced: &Reduced, tau: Double) -> Self {
        let step = Step::new(reduced, tau);
        let over = |unit: usize| step.transfers::<false>(&each(|k| (unit * k) as f64));
        Steps { step, samples: over(1), blocks: over(LANES), groups: over(GROUP) }
    }

    pub fn zeta(&self) -> f64 {
        self.step.zeta
    }

    /// Over `span` spans, one more, …
    #[inline(always)]
    pub fn spans<const FUSED: bool>(&self, span: usize) -> Transfers {
        self.step.transfers::<FUSED>(&each(|k| (SPAN * (span + k)) as f64))
    }
}

/// The time from one sample to the next.
#[derive(Debug, Clone, Copy)]
struct Step {
    zeta: f64,
    root: f64,
    /// √(1 − ζ²) ω0 t, in two parts.
    phase: (f64, f64),
    /// −ζ ω0 t.
    exponent: f64,
}

impl Step {
    fn new(reduced: &Reduced, tau: Double) -> Self {
        let (zeta, root) = (reduced.zeta.hi(), reduced.discriminant().sqrt());
        let phase = tau * root;
        let exponent = -zeta * tau.hi();
        Step { zeta, root: root.hi(), phase: (phase.hi(), phase.lo()), exponent }
    }

    /// The linear motion over so many samples.
    #[inline(always)]
    fn transfers<const FUSED: bool>(&self, samples: &Lanes) -> Transfers {
        let (sin, cos) = sin_cos_of_multiples::<FUSED>(self.phase, samples);
        let mut transfers = Transfers { yy: [0.0; LANES], yw: [0.0; LANES], ww: [0.0; LANES] };
        for k in 0..LANES {
            let decay = (self.exponent * samples[k]).exp();
            let transfer = Transfer::new(self.zeta, cos[k], sin[k] / self.root, decay);
            (transfers.yy[k], transfers.yw[k], transfers.ww[k]) =
                (transfer.yy, transfer.yw, transfer.ww);
        }
        transfers
    }
}

/// [`LANES`] times a [`Transfer`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Transfers {
    yy: Lanes,
    yw: Lanes,
    ww: Lanes,
}

impl Transfers {
    #[inline(always)]
    pub fn get(&self, k: usize) -> Transfer {
        Transfer { yy: self.yy[k], yw: self.yw[k], ww: self.ww[k] }
    }

    /// From one state (y, w) to the state after each.
    #[inline(always)]
    pub fn spread<const FUSED: bool>(&self, (y, w): (f64, f64)) -> (Lanes, Lanes) {
        (
            each(|k| mul_add::<FUSED>(self.yy[k], y, self.yw[k] * w)),
            each(|k| mul_add::<FUSED>(self.ww[k], w, -self.yw[k] * y)),
        )
    }
}
