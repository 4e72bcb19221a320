//! Fits with a loss that outliers do not sway.

use crate::extremes::spread;
use crate::least_squares::{Effort, Minimum, minimise};
use crate::mixes::{Fitted, free};
use crate::options::Loss;
use crate::problem::Problem;

/// The fits again with a loss that outliers do not sway; the scale is that of the residuals'
/// median.
pub fn robust(problem: &mut Problem, fitted: &[Fitted], loss: Loss) -> Vec<Fitted> {
    let mut fitted = fitted.to_vec();
    // The scale is that of the largest mix, the same for all, so that they can be compared.
    for _ in 0..3 {
        let Some(largest) = fitted.first() else { return fitted };
        let Some(residuals) = problem.residuals(&largest.minimum.at, largest.minimum.ending) else {
            return fitted;
        };
        let scale = spread(residuals.into_iter());
        if scale <= 0.0 {
            return fitted;
        }
        problem.loss = (loss, scale);
        for fit in &mut fitted {
            let free = free(fit.mix);
            for minimum in fit.beside.iter_mut().chain([&mut fit.minimum]) {
                let Minimum { at, ending, .. } = *minimum;
                if let Some(found) = minimise(problem, &at, &free, ending, Effort::FINE) {
                    *minimum = found;
                }
            }
        }
    }
    fitted
}
