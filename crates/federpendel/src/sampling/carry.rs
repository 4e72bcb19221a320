//! A run on an even grid, of which only the first state is computed and all others are carried on.

use crate::sampling::grid::Grid;
use crate::sampling::kernel::Source;
use crate::sampling::lanes::{LANES, Lanes, each, mul_add};
use crate::sampling::steps::{Steps, Transfers};
use crate::sampling::times::Times;
use crate::swing::linear::Transfer;

/// Carries the linear motion from the first sample to a span, a group in it, and a block in that. However long the
/// run, no more than these four steps stand between a state and the first, so that rounding does not pile up.
pub(crate) struct Carry<'a> {
    grid: &'a Grid,
    steps: &'a Steps,
    /// (y, w) at the first sample of the run, of the span, and of each lane of the group.
    first: (f64, f64),
    span: (f64, f64),
    group: (Lanes, Lanes),
    /// From the first sample to the present span and those about it.
    spans: Transfers,
}

impl<'a> Carry<'a> {
    /// From the state (y, w) that the first sample would have if its time were not rounded.
    #[inline(always)]
    pub fn new(grid: &'a Grid, steps: &'a Steps, first: (f64, f64)) -> Self {
        let group = ([0.0; LANES], [0.0; LANES]);
        Carry { grid, steps, first, span: first, group, spans: steps.samples }
    }

    #[inline(always)]
    fn enter_span<const FUSED: bool>(&mut self, span: usize) {
        let Some(later) = span.checked_sub(1) else { return };
        if later.is_multiple_of(LANES) {
            self.spans = self.steps.spans::<FUSED>(span);
        }
        self.span = self.spans.get(later % LANES).apply(self.first);
    }

    #[inline(always)]
    fn enter_group<const FUSED: bool>(&mut self, group: usize) {
        if group.is_multiple_of(LANES) {
            self.enter_span::<FUSED>(group / LANES);
        }
        let start = self.steps.groups.get(group % LANES).apply(self.span);
        self.group = self.steps.samples.spread::<FUSED>(start);
    }
}

impl Source for Carry<'_> {
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    #[cfg_attr(target_family = "wasm", inline(never))]
    fn block<const FUSED: bool>(
        &mut self,
        _: &Times,
        first: usize,
        block: usize,
    ) -> (Lanes, Lanes) {
        if block.is_multiple_of(LANES) {
            self.enter_group::<FUSED>(block / LANES);
        }
        let Transfer { yy, yw, ww } = self.steps.blocks.get(block % LANES);
        let (y0, w0) = &self.group;
        let y = each(|k| mul_add::<FUSED>(yy, y0[k], yw * w0[k]));
        let w = each(|k| mul_add::<FUSED>(ww, w0[k], -yw * y0[k]));
        // What the motion does in the time that rounding has added: y′ = w, w′ = −y − 2ζw.
        let lag = self.grid.lags::<FUSED>(first);
        let fall = each(|k| mul_add::<FUSED>(2.0 * self.steps.zeta(), w[k], y[k]));
        (
            each(|k| mul_add::<FUSED>(w[k], lag[k], y[k])),
            each(|k| mul_add::<FUSED>(-fall[k], lag[k], w[k])),
        )
    }
}
