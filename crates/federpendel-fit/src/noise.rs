//! How much residuals that hang together count.
//!
//! The parameters of a swinging motion show at its own frequency only. There residuals with a
//! correlation have the power S(ω0) instead of that of white noise with the same variance: n values
//! tell as much as n/F independent ones, F = S(ω0)/σ². The spectrum is that of an autoregressive
//! process fitted to the residuals (Yule–Walker by Levinson's recursion, order by BIC; Percival &
//! Walden 1993, ch. 9), which is white if nothing speaks for more.

use std::f64::consts::PI;

/// By how much noise exceeds white noise of the residuals' variance.
///
/// The noise that shifts the phase and the noise that changes the amplitude are told apart: a
/// period that drifts by little makes the phase unsure, not the friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Excess {
    /// At ω0, for the frequency and the state at the start; at least 1.
    pub of_phase: f64,
    /// At ω0 with what a drift of the period explains taken away, for the coefficients of friction; at
    /// least 1.
    pub of_amplitude: f64,
    /// At zero, for the zero of the sensor; at least 1.
    pub of_zero: f64,
}

impl Excess {
    /// The excess for parameter `i`, in the order of [`crate::Parameters`].
    pub fn of(&self, i: usize) -> f64 {
        match i {
            1..=3 => self.of_amplitude,
            6 => self.of_zero,
            _ => self.of_phase,
        }
    }

    /// From residuals, and from the same with `patterns` patterns of a drift of the period taken
    /// away.
    pub fn new(residuals: &[f64], steady: &[f64], patterns: usize, step: f64, omega: f64) -> Self {
        let mean = |r: &[f64]| r.iter().map(|r| r * r).sum::<f64>() / r.len() as f64;
        let (all, left) = (mean(residuals), mean(steady));
        let of_phase = excess(residuals, step, omega, omega);
        let of_steady = excess(steady, step, omega, omega);
        // Patterns take something from any noise; a drift is what takes far more.
        let taken = (all - left) * residuals.len() as f64 / patterns as f64;
        let drifts = taken > DRIFT * left * of_steady;
        Self {
            of_phase,
            // Of no more use than independent values, however well the drift explains them.
            of_amplitude: if drifts { (of_steady * left / all).max(1.0) } else { of_phase },
            of_zero: excess(residuals, step, omega, 0.0),
        }
    }
}

/// A period drifts if its patterns take so many times what they take from noise.
const DRIFT: f64 = 6.0;

/// The highest order tried.
const ORDER: usize = 12;
/// Values per period that residuals are averaged down to: correlation over a longer time than a few
/// orders of a fine sampling shows then.
const PER_PERIOD: f64 = 24.0;

/// The power of `residuals` at `frequency` over that of white noise with their variance, at least
/// 1; for a motion of frequency `omega` recorded at even steps of `step` seconds.
pub fn excess(residuals: &[f64], step: f64, omega: f64, frequency: f64) -> f64 {
    let block = ((2.0 * PI / omega / step / PER_PERIOD).floor() as usize)
        .clamp(1, (residuals.len() / 60).max(1));
    let means: Vec<f64> = residuals
        .chunks_exact(block)
        .map(|chunk| chunk.iter().sum::<f64>() / block as f64)
        .collect();
    let variance = residuals.iter().map(|r| r * r).sum::<f64>() / residuals.len() as f64;
    let process = autoregression(&means, ORDER.min(means.len() / 10));
    let power = process.power(frequency * step * block as f64) * block as f64;
    let found = if variance > 0.0 { (power / variance).max(1.0) } else { 1.0 };
    // The fit took from the noise what looks like the motion, and a correlation is found too low by its
    // bias (Marriott & Pope 1954): for x = φ x' + e both together lower F by about 4/n of F².
    found * (1.0 + 4.0 * found / residuals.len() as f64)
}

/// x_t = Σ a_k x_{t−k} + noise of this variance.
struct Autoregression {
    coefficients: Vec<f64>,
    variance: f64,
}

impl Autoregression {
    /// Spectral power at `phase` radians per value; white noise has its variance everywhere.
    fn power(&self, phase: f64) -> f64 {
        let (mut re, mut im) = (1.0, 0.0);
        for (k, a) in self.coefficients.iter().enumerate() {
            let (sin, cos) = ((k + 1) as f64 * phase).sin_cos();
            re -= a * cos;
            im += a * sin;
        }
        self.variance / (re * re + im * im)
    }
}

/// Levinson's recursion up to `highest`; the order with the lowest BIC.
fn autoregression(values: &[f64], highest: usize) -> Autoregression {
    let n = values.len() as f64;
    let covariance =
        |lag: usize| values.iter().zip(&values[lag..]).map(|(a, b)| a * b).sum::<f64>() / n;
    let mut variance = covariance(0);
    let mut a: Vec<f64> = Vec::new();
    let mut best = (n * variance.ln(), Autoregression { coefficients: vec![], variance });
    for order in 1..=highest {
        if variance <= 0.0 {
            break;
        }
        let known: f64 = a.iter().enumerate().map(|(k, a)| a * covariance(order - 1 - k)).sum();
        let reflection = (covariance(order) - known) / variance;
        let mut next: Vec<f64> =
            (0..a.len()).map(|k| a[k] - reflection * a[a.len() - 1 - k]).collect();
        next.push(reflection);
        a = next;
        variance *= 1.0 - reflection * reflection;
        let bic = n * variance.ln() + order as f64 * n.ln();
        if bic < best.0 {
            best = (bic, Autoregression { coefficients: a.clone(), variance });
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Even numbers between −√3 and √3: variance 1 (SplitMix64).
    fn white(count: usize, seed: u64) -> Vec<f64> {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) as f64 / 2f64.powi(64) - 0.5) * 12f64.sqrt()
        };
        (0..count).map(|_| next()).collect()
    }

    #[test]
    fn white_noise_has_no_excess() {
        let mean =
            (1..40).map(|seed| excess(&white(2000, seed), 0.01, 6.0, 6.0)).sum::<f64>() / 39.0;
        assert!(mean < 1.1, "{mean}");
    }

    #[test]
    fn the_excess_of_a_known_process_is_found() {
        // x = φ x' + e: S(ω)/σ² = (1 − φ²)/(1 − 2φ cos ω + φ²), at zero (1 + φ)/(1 − φ).
        for (phi, omega) in [(0.8f64, 0.0f64), (0.8, 0.1), (0.95, 0.05)] {
            let mut before = 0.0;
            let process: Vec<f64> = white(40_000, 5)
                .into_iter()
                .map(|e| {
                    before = phi * before + e;
                    before
                })
                .collect();
            let exact = (1.0 - phi * phi) / (1.0 - 2.0 * phi * omega.cos() + phi * phi);
            let found = excess(&process, 1.0, 0.05, omega);
            assert!((found / exact - 1.0).abs() < 0.2, "{phi} {omega}: {found} {exact}");
        }
    }
}
