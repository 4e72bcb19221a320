//! A stretch of a swing as a polynomial: the dense output of every series.

use crate::sampling::lanes::mul_add;

/// Degree of the polynomials.
pub(crate) const DEGREE: usize = 24;

/// Numbers of terms that a shorter polynomial may have, so few that code can be made for each.
pub(crate) const FEWER_TERMS: [usize; 5] = [22, 20, 18, 16, 12];

/// y(τ) = Σ `position`ₖ uᵏ and w(τ) = Σ `velocity`ₖ uᵏ with u = (τ − `center`)·`inverse_scale`,
/// valid from `start` to the start of the next piece.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Piece {
    pub start: f64,
    pub center: f64,
    pub inverse_scale: f64,
    pub position: [f64; DEGREE + 1],
    pub velocity: [f64; DEGREE + 1],
}

impl Piece {
    /// (y, w) at the time `tau` of the swing.
    pub fn state(&self, tau: f64) -> (f64, f64) {
        let u = (tau - self.center) * self.inverse_scale;
        (polynomial::<false>(&self.position, u), polynomial::<false>(&self.velocity, u))
    }

    /// w at the time `tau` of the swing.
    pub fn velocity_at(&self, tau: f64) -> f64 {
        polynomial::<false>(&self.velocity, (tau - self.center) * self.inverse_scale)
    }

    /// How many terms are enough for this piece if it ends at `end`: all, or one of [`FEWER_TERMS`].
    pub fn terms(&self, end: f64) -> usize {
        let reach = (self.start - self.center).abs().max((end - self.center).abs());
        let u = reach * self.inverse_scale;
        let size = 1e-17 * self.position[0].abs().max(self.velocity[0].abs());
        let (u4, u2) = (u.powi(4), u * u);
        let (u8, u16) = (u4 * u4, u.powi(16));
        let powers = [u16 * u4 * u2, u16 * u4, u16 * u2, u16, u8 * u4];
        // The sum of the terms left out, over the power of u at which they begin; mostly few can be.
        let (mut rest, mut enough) = (0.0, DEGREE + 1);
        for (fewer, power) in FEWER_TERMS.into_iter().zip(powers) {
            for n in (fewer..enough).rev() {
                rest = rest * u + self.velocity[n].abs().max(self.position[n].abs());
            }
            if rest * power > size {
                break;
            }
            enough = fewer;
        }
        enough
    }
}

/// The value of the polynomial with these coefficients, lowest first; as even and odd halves like
/// [`crate::sampling::lanes::polynomial`], which wait half as long as Horner's scheme.
#[inline(always)]
pub(crate) fn polynomial<const FUSED: bool>(coefficients: &[f64], u: f64) -> f64 {
    let square = u * u;
    let (pairs, single) = coefficients.as_chunks::<2>();
    let (mut even, mut odd) = (single.first().copied().unwrap_or(0.0), 0.0);
    for [c, d] in pairs.iter().rev() {
        even = mul_add::<FUSED>(even, square, *c);
        odd = mul_add::<FUSED>(odd, square, *d);
    }
    mul_add::<FUSED>(u, odd, even)
}

/// Coefficients of the derivative.
#[inline(always)]
pub(crate) fn derivative(coefficients: &[f64; DEGREE + 1]) -> [f64; DEGREE] {
    std::array::from_fn(|n| (n + 1) as f64 * coefficients[n + 1])
}
