//! A stretch of a swing as a polynomial: the dense output of every series.

/// Degree of the polynomials.
pub(crate) const DEGREE: usize = 24;

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
        (horner(&self.position, u), horner(&self.velocity, u))
    }
}

/// The value of the polynomial with these coefficients, lowest first.
#[inline]
pub(crate) fn horner(coefficients: &[f64], u: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * u + c)
}
