//! Standard errors and correlations from the curvature at the minimum.

use crate::information::inverse;
use crate::least_squares::Minimum;
use crate::noise::Excess;
use crate::problem::{LAWS, Matrix, OMEGA};

/// The covariance of the `free` parameters of a fit to `count` values.
///
/// The variance of one value is that of the residuals, whatever the recording states; residuals
/// that hang together count as [`crate::noise`] says. A coefficient that ended at zero counts as
/// free: that it could not fall below makes the others no surer.
pub fn covariance(minimum: &Minimum, free: &[bool; 7], count: usize, excess: Excess) -> Matrix {
    let inverse = inverse(&minimum.normal.information, free);
    let variance = variance(minimum, free, count, excess);
    Matrix::from_fn(|i, j| match inverse[(i, j)] {
        unknown if unknown.is_infinite() => unknown,
        known => known * variance * (excess.of(i) * excess.of(j)).sqrt(),
    })
}

/// The variance of one value, from the residuals. The parameters take from noise that hangs
/// together as much as from so many fewer independent values.
pub fn variance(minimum: &Minimum, free: &[bool; 7], count: usize, excess: Excess) -> f64 {
    let fitted = free.iter().filter(|&&free| free).count() as f64;
    let count = count as f64;
    minimum.normal.cost / (count - fitted * excess.of_amplitude).max(0.2 * count)
}

/// The 97.5 % point of the normal distribution.
pub const NORMAL: f64 = 1.959964;

/// The 97.5 % point of Student's t with `freedom` degrees of freedom (Abramowitz & Stegun 26.7.5).
pub fn student(freedom: f64) -> f64 {
    let z = NORMAL;
    let g1 = (z.powi(3) + z) / 4.0;
    let g2 = (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0;
    z + g1 / freedom + g2 / (freedom * freedom)
}

/// The 95 % interval of parameter `i` from its standard error: neither coefficients nor the frequency
/// have a part below zero.
pub fn interval(value: f64, stderr: f64, i: usize, quantile: f64) -> (f64, f64) {
    let low = value - quantile * stderr;
    let low = if LAWS.contains(&i) || i == OMEGA { low.max(0.0) } else { low };
    (low, value + quantile * stderr)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_tables() {
        // Abramowitz & Stegun, table 26.10.
        for (freedom, t) in [(5.0, 2.571), (10.0, 2.228), (30.0, 2.042), (120.0, 1.980)] {
            assert!((student(freedom) / t - 1.0).abs() < 0.01, "{freedom}: {}", student(freedom));
        }
    }
}
