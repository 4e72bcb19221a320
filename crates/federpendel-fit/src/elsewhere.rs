//! What it adds to the doubt about a fit that the mass may have come to rest a swing earlier or later.
//!
//! The number of swings until rest is a whole number. Where two of them fit about as well, a parameter has a
//! minimum of the sum of squares for each; its 95 % interval is all that lies within the same limit above the shown
//! one, around whichever minimum: the profile over the number too.

use crate::covariance::{covariance, interval, variance};
use crate::fit::Fits;
use crate::least_squares::Minimum;
use crate::mixes::{Fitted, free};
use crate::problem::Matrix;

/// A minimum with another rest that the recording does not rule out.
pub struct Other {
    /// The minimum.
    pub minimum: Minimum,
    spread: Matrix,
    /// So many of its standard deviations away from it the limit is reached.
    quantile: f64,
}

/// How far a parameter reaches.
pub struct Reached {
    /// Its standard error.
    pub stderr: f64,
    /// Its 95 % interval, open where an end is none.
    pub interval95: (Option<f64>, Option<f64>),
}

impl Fits<'_> {
    /// The minima with another rest whose χ² is above that shown by less than `quantile`², in the measure of the
    /// likelihood ratios.
    pub fn rests(&self, fitted: &Fitted, quantile: f64) -> Vec<Other> {
        let (free, count) = (free(fitted.mix), self.problem.len());
        let shown = &fitted.minimum;
        let unit = variance(shown, &free, count, self.excess) * self.excess.of_amplitude;
        let other = |minimum: &Minimum| {
            let above = ((minimum.normal.cost - shown.normal.cost) / unit).max(0.0);
            let left = quantile * quantile - above;
            (left > 0.0).then(|| Other {
                minimum: *minimum,
                spread: covariance(minimum, &free, count, self.excess),
                quantile: left.sqrt(),
            })
        };
        fitted.beside.iter().filter_map(other).collect()
    }
}

impl Reached {
    /// With where parameter `i` may be if the mass rests elsewhere. The standard error of `value` then is at least what
    /// the farther end of the interval says, which lies `quantile` of them away.
    pub fn with(self, others: &[Other], i: usize, value: f64, quantile: f64) -> Self {
        let (mut low, mut high) = self.interval95;
        let mut stderr = self.stderr;
        for Other { minimum, spread, quantile: near } in others {
            let there = interval(minimum.at[i], spread[(i, i)].sqrt(), i, *near);
            low = low.map(|low| low.min(there.0)).filter(|low| low.is_finite());
            high = high.map(|high| high.max(there.1)).filter(|high| high.is_finite());
            stderr = stderr.max((value - there.0).max(there.1 - value) / quantile);
        }
        Self { stderr, interval95: (low, high) }
    }
}
