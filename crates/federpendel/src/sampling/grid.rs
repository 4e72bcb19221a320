//! An even grid of times, on which a linear swing can be carried on instead of computed anew.

use crate::oscillator::Reduced;
use crate::sampling::lanes::{LANES, Lanes, each, mul_add, product_error, quotient_error};
use crate::swing::linear::{Propagator, Transfer};

/// States carried on from one that is computed, [`LANES`] samples each.
const STRIDES: usize = 15;
/// Up to this ω0 t the rounding of a time is corrected to first order.
const LONGEST: f64 = 1e7;

/// The times `duration`·i/`last`, i = 0 … `last`.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub duration: f64,
    pub last: f64,
    /// Samples per second, `last`/`duration`.
    pub rate: f64,
    /// 1/`last`.
    inverse: f64,
    zeta: f64,
    /// ω0/`last`.
    lag_scale: f64,
    /// The linear motion over 1, 2, … times [`LANES`] samples; none where the record is too long.
    transfers: Option<[Transfer; STRIDES]>,
}

/// A state of the linear motion at [`LANES`] samples.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Carried {
    pub y: Lanes,
    pub w: Lanes,
    /// ω0 times what rounding added to the time of the sample.
    pub lag: Lanes,
}

impl Grid {
    pub fn new(reduced: &Reduced, duration: f64, samples: usize) -> Self {
        let last = (samples - 1) as f64;
        let zeta = reduced.zeta.hi();
        let propagator = Propagator::new(zeta, reduced.discriminant().hi());
        let stride = reduced.omega0 * duration / last * LANES as f64;
        let short = reduced.omega0.hi() * duration < LONGEST;
        let transfers = short.then(|| {
            std::array::from_fn(|k| propagator.transfer((stride * (k + 1) as f64).into()))
        });
        Grid {
            duration,
            last,
            rate: last / duration,
            inverse: 1.0 / last,
            zeta,
            lag_scale: reduced.omega0.hi() / last,
            transfers,
        }
    }

    /// The transfer from block 0 to block `block` of a run, where there is one.
    #[inline(always)]
    pub fn transfer(&self, block: usize) -> Option<&Transfer> {
        self.transfers.as_ref()?.get((block % (STRIDES + 1)).checked_sub(1)?)
    }

    /// [`LANES`] times from index `i` on and their lags.
    #[inline(always)]
    pub fn lanes<const FUSED: bool>(&self, i: usize) -> (Lanes, Lanes) {
        let from = i as f64;
        let index = each(|k| from + k as f64);
        let product = each(|k| self.duration * index[k]);
        let mut times = each(|k| {
            // The rounded quotient without a division, by Markstein's correction.
            let quotient = if FUSED { product[k] * self.inverse } else { product[k] / self.last };
            let rest = mul_add::<FUSED>(-quotient, self.last, product[k]);
            if FUSED { mul_add::<FUSED>(rest, self.inverse, quotient) } else { quotient }
        });
        if from + LANES as f64 > self.last {
            let ends = (self.last - from) as usize;
            if let Some(time) = times.get_mut(ends) {
                *time = self.duration;
            }
        }
        let lag = each(|k| {
            // What two roundings left out: that of the product, and the remainder of the quotient.
            let product_error = product_error::<FUSED>(self.duration, index[k], product[k]);
            let remainder = quotient_error::<FUSED>(times[k], self.last, product[k]);
            (remainder + product_error) * -self.lag_scale
        });
        (times, lag)
    }

    /// The linear motion carried on from `from` to samples with these lags.
    #[inline(always)]
    pub fn carry<const FUSED: bool>(
        &self,
        from: &Carried,
        transfer: &Transfer,
        lag: &Lanes,
    ) -> (Lanes, Lanes) {
        let Transfer { yy, yw, ww } = *transfer;
        let y = each(|k| mul_add::<FUSED>(yy, from.y[k], yw * from.w[k]));
        let w = each(|k| mul_add::<FUSED>(ww, from.w[k], -yw * from.y[k]));
        let late = each(|k| lag[k] - from.lag[k]);
        let fall = each(|k| mul_add::<FUSED>(2.0 * self.zeta, w[k], y[k]));
        (
            each(|k| mul_add::<FUSED>(w[k], late[k], y[k])),
            each(|k| mul_add::<FUSED>(-fall[k], late[k], w[k])),
        )
    }
}
