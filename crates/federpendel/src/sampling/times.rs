//! The times of a record: any, or an even grid.

use crate::error::Result;
use crate::motion::even_time;
use crate::parameter;
use crate::sampling::grid::Grid;
use crate::sampling::lanes::{LANES, Lanes, each, mul_add, product_error};
use crate::sampling::steps::Steps;

/// Far more than rounding can move a sample, in samples over the index of the sample.
const CLEAR: f64 = 1e-12;

/// The times of a record, s.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Times<'a> {
    /// As given, in any order.
    Any(&'a [f64]),
    /// An even grid.
    Even(&'a Grid),
}

impl Times<'_> {
    /// Time `i`, checked.
    pub fn check(&self, i: usize) -> Result<f64> {
        parameter::TIME.check(self.time(i))
    }

    pub fn time(&self, i: usize) -> f64 {
        match *self {
            Times::Any(times) => times[i],
            Times::Even(grid) => even_time(grid.duration, grid.last, i as f64),
        }
    }

    /// The grid on which a linear motion is carried on, where it is.
    pub fn carried(&self) -> Option<(&Grid, &Steps)> {
        match self {
            Times::Any(_) => None,
            Times::Even(grid) => Some((grid, grid.steps()?)),
        }
    }

    /// End of the run of times from index `first` on that lie in `from` ≤ t < `until`.
    pub fn run_end(&self, first: usize, from: f64, until: f64) -> usize {
        let within = |time: &f64| from <= *time && *time < until;
        match *self {
            Times::Any(times) => {
                let blocks = times[first..].chunks_exact(LANES);
                let whole = blocks.take_while(|block| block.iter().all(within)).count() * LANES;
                let rest = times[first + whole..].iter().take_while(|time| within(time)).count();
                first + whole + rest
            }
            Times::Even(grid) => {
                let place = until * grid.rate;
                let estimate = place.ceil();
                let mut end = (estimate.clamp(0.0, grid.last + 1.0) as usize).max(first + 1);
                // Clear of a sample by more than any rounding: no need to look at the samples about it.
                let doubt = CLEAR * (1.0 + place);
                if (doubt..1.0 - doubt).contains(&(estimate - place)) {
                    return end;
                }
                while end as f64 <= grid.last && self.time(end) < until {
                    end += 1;
                }
                while end > first + 1 && self.time(end - 1) >= until {
                    end -= 1;
                }
                end
            }
        }
    }

    /// [`LANES`] times from index `i` on, of which those beyond the end of the record are any numbers.
    #[inline(always)]
    pub fn lanes<const FUSED: bool>(&self, i: usize) -> Lanes {
        match *self {
            Times::Any(times) => match times[i..].first_chunk() {
                Some(chunk) => *chunk,
                None => each(|k| times.get(i + k).copied().unwrap_or(0.0)),
            },
            Times::Even(grid) => grid.lanes::<FUSED>(i),
        }
    }
}

/// τ = ω0 t − `origin`, from double-double numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Clock {
    pub omega: (f64, f64),
    pub origin: (f64, f64),
}

impl Clock {
    #[inline(always)]
    pub fn read<const FUSED: bool>(&self, times: &Lanes) -> Lanes {
        each(|i| {
            let product = self.omega.0 * times[i];
            let error = product_error::<FUSED>(self.omega.0, times[i], product);
            let low = mul_add::<FUSED>(self.omega.1, times[i], error) - self.origin.1;
            (product - self.origin.0) + low
        })
    }
}
