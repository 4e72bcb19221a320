//! An even grid of times, on which a linear swing can be carried on instead of computed anew.

use crate::double::Double;
use crate::oscillator::Reduced;
use crate::sampling::lanes::{LANES, Lanes, each, mul_add, product_error, quotient_error};
use crate::sampling::steps::Steps;

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
    /// ω0 times the time from one sample to the next.
    tau_step: Double,
    /// ω0/`last`.
    lag_scale: f64,
    /// What carries a linear motion on; none where the record is too long or the motion does not swing.
    steps: Option<Steps>,
}

impl Grid {
    pub fn new(reduced: &Reduced, duration: f64, samples: usize) -> Self {
        let last = (samples - 1) as f64;
        let tau_step = reduced.omega0 * duration / last;
        let short = reduced.omega0.hi() * duration < LONGEST;
        let swings = reduced.discriminant().hi() > 0.0;
        let steps = (short && swings).then(|| Steps::new(reduced, tau_step));
        Grid {
            duration,
            last,
            rate: last / duration,
            inverse: 1.0 / last,
            tau_step,
            lag_scale: reduced.omega0.hi() / last,
            steps,
        }
    }

    pub fn steps(&self) -> Option<&Steps> {
        self.steps.as_ref()
    }

    /// ω0 t of sample `i`, before its time is rounded.
    pub fn tau(&self, i: usize) -> Double {
        self.tau_step * i as f64
    }

    /// [`LANES`] times from index `i` on.
    #[inline(always)]
    pub fn lanes<const FUSED: bool>(&self, i: usize) -> Lanes {
        self.rounded::<FUSED>(i).0
    }

    /// ω0 times what rounding has added to each of [`LANES`] times from index `i` on.
    #[inline(always)]
    pub fn lags<const FUSED: bool>(&self, i: usize) -> Lanes {
        let (times, index, product) = self.rounded::<FUSED>(i);
        each(|k| {
            // What two roundings left out: that of the product, and the remainder of the quotient.
            let product_error = product_error::<FUSED>(self.duration, index[k], product[k]);
            let remainder = quotient_error::<FUSED>(times[k], self.last, product[k]);
            (remainder + product_error) * -self.lag_scale
        })
    }

    /// [`LANES`] times from index `i` on, their indices, and the products with the duration, before they are divided.
    #[inline(always)]
    fn rounded<const FUSED: bool>(&self, i: usize) -> (Lanes, Lanes, Lanes) {
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
        (times, index, product)
    }
}
