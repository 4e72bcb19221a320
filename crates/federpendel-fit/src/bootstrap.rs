//! Intervals from refits to recordings that might have been: the fit, and its residuals drawn anew.

use crate::least_squares::{Effort, Minimum, minimise};
use crate::problem::{Problem, Vector};

/// How often, and from which seed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bootstrap {
    /// Number of refits.
    pub repeats: usize,
    /// The same seed draws the same.
    pub seed: u64,
}

/// The parameters of each refit. Residuals are drawn in blocks of `block` neighbours, so that
/// correlations shorter than that stay (Künsch 1989).
pub fn refits(
    problem: &Problem,
    minimum: &Minimum,
    free: &[bool; 7],
    block: usize,
    bootstrap: Bootstrap,
) -> Vec<Vector> {
    let mut drawn = problem.clone();
    let Some(residuals) = drawn.residuals(&minimum.at, minimum.ending) else { return vec![] };
    let model: Vec<f64> = problem.values.iter().zip(&residuals).map(|(v, r)| v - r).collect();
    let fitted = free.iter().filter(|&&free| free).count();
    let n = model.len();
    // Residuals are smaller than the noise by what the parameters took of it.
    let widen = (n as f64 / n.saturating_sub(fitted).max(1) as f64).sqrt();
    let mut random = Random(bootstrap.seed);
    let block = block.clamp(1, n);
    let mut found = Vec::new();
    for _ in 0..bootstrap.repeats {
        for start in (0..n).step_by(block) {
            let from = random.below(n);
            for k in 0..block.min(n - start) {
                drawn.values[start + k] = model[start + k] + widen * residuals[(from + k) % n];
            }
        }
        let effort = Effort { steps: 20, gain: 1e-3 };
        let again = minimise(&mut drawn, &minimum.at, free, minimum.ending, effort);
        found.extend(again.map(|minimum| minimum.at));
    }
    found
}

/// The middle 95 % of parameter `i` in `refits`.
pub fn interval(refits: &[Vector], i: usize) -> Option<(f64, f64)> {
    let mut values: Vec<f64> = refits.iter().map(|at| at[i]).collect();
    values.sort_by(f64::total_cmp);
    let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
    (values.len() >= 40).then(|| (at(0.025), at(0.975)))
}

/// SplitMix64 (Steele, Lea & Flood 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % limit as u64) as usize
    }
}
