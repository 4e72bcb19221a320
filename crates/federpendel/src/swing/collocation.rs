//! Chebyshev collocation on one step: nodes, differentiation, integration, dense linear solve.
//!
//! The nodes u_j = −cos(πj/S), j = 0…S, hold both ends of the step; a polynomial of degree S is
//! given by its values there. Matrices as in Trefethen, *Spectral Methods in MATLAB* (2000), ch. 6,
//! and *Approximation Theory and Approximation Practice* (2013), ch. 3 and 19.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// Nodes at which the equation is asked, and degree of the velocity's polynomial.
pub(crate) const STAGES: usize = 18;
/// Number of nodes.
pub(crate) const NODES: usize = STAGES + 1;
/// Terms of the position, whose degree is one higher than the velocity's.
pub(crate) const POSITION_TERMS: usize = STAGES + 2;

/// Values at the nodes.
pub(crate) type Nodal = [f64; NODES];
/// A matrix and right-hand side over the nodes but the first, whose value is the initial one.
pub(crate) type Matrix = [[f64; STAGES]; STAGES];
/// See [`Matrix`].
pub(crate) type Vector = [f64; STAGES];

/// What depends on the nodes alone.
pub(crate) struct Tables {
    /// The nodes, from −1 to 1.
    pub node: Nodal,
    /// Derivative at the nodes from values at the nodes; every row sums to zero.
    pub derivative: [Nodal; NODES],
    /// Integral from −1 to each node from values at the nodes.
    pub integral: [Nodal; NODES],
    /// Chebyshev coefficients from values at the nodes.
    coefficient: [Nodal; NODES],
    /// Monomial coefficients of the Chebyshev polynomials; whole numbers.
    monomial: [[f64; POSITION_TERMS]; POSITION_TERMS],
}

/// The tables, made once.
pub(crate) static TABLES: LazyLock<Tables> = LazyLock::new(Tables::new);

impl Tables {
    fn new() -> Self {
        // cos(πn/S) for whole n, exactly odd and even about the quarter turns.
        let cosine = |n: usize| {
            let n = n % (2 * STAGES);
            let n = n.min(2 * STAGES - n);
            if 2 * n <= STAGES { quarter_cosine(n) } else { -quarter_cosine(STAGES - n) }
        };
        let end = |j: usize| if j == 0 || j == STAGES { 2.0 } else { 1.0 };
        let sign = |n: usize| if n.is_multiple_of(2) { 1.0 } else { -1.0 };

        let mut derivative = [[0.0; NODES]; NODES];
        let mut coefficient = [[0.0; NODES]; NODES];
        for i in 0..NODES {
            for j in 0..NODES {
                coefficient[i][j] =
                    sign(i) * cosine(i * j) * 2.0 / (STAGES as f64 * end(i) * end(j));
                if i != j {
                    // u_i − u_j as a product of sines, which does not cancel.
                    let angle = |n: f64| (n * PI / (2 * STAGES) as f64).sin();
                    let distance = 2.0 * angle((i + j) as f64) * angle(i as f64 - j as f64);
                    derivative[i][j] = end(i) / end(j) * sign(i + j) / distance;
                }
            }
            derivative[i][i] = -derivative[i].iter().sum::<f64>();
        }

        let mut integral = [[0.0; NODES]; NODES];
        for j in 0..NODES {
            let antiderivative = antiderivative(&std::array::from_fn(|k| coefficient[k][j]));
            for (i, row) in integral.iter_mut().enumerate() {
                row[j] =
                    (0..POSITION_TERMS).map(|k| antiderivative[k] * sign(k) * cosine(k * i)).sum();
            }
        }

        let mut monomial = [[0.0; POSITION_TERMS]; POSITION_TERMS];
        monomial[0][0] = 1.0;
        monomial[1][1] = 1.0;
        for n in 2..POSITION_TERMS {
            for k in 0..POSITION_TERMS {
                let raised = if k > 0 { 2.0 * monomial[n - 1][k - 1] } else { 0.0 };
                monomial[n][k] = raised - monomial[n - 2][k];
            }
        }
        let node = std::array::from_fn(|j| -cosine(j));
        Tables { node, derivative, integral, coefficient, monomial }
    }

    /// Chebyshev coefficients of the polynomial with these values at the nodes.
    pub fn coefficients(&self, values: &Nodal) -> Nodal {
        std::array::from_fn(|k| dot(&self.coefficient[k], values))
    }

    /// Monomial coefficients from Chebyshev coefficients.
    pub fn monomials<const N: usize>(&self, chebyshev: &[f64]) -> [f64; N] {
        let mut sum = [0.0; N];
        for (coefficient, polynomial) in chebyshev.iter().zip(&self.monomial).rev() {
            for (sum, m) in sum.iter_mut().zip(polynomial) {
                *sum += coefficient * m;
            }
        }
        sum
    }
}

/// cos(πn/S) for 0 ≤ 2n ≤ S.
fn quarter_cosine(n: usize) -> f64 {
    (((STAGES - 2 * n) as f64) * PI / (2 * STAGES) as f64).sin()
}

/// Σ a_k b_k.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Chebyshev coefficients of the antiderivative that vanishes at −1:
/// ∫T_k = T_(k+1)/(2k+2) − T_(k−1)/(2k−2).
pub(crate) fn antiderivative(a: &Nodal) -> [f64; POSITION_TERMS] {
    let term = |k: usize| if k < NODES { a[k] } else { 0.0 };
    let mut b = [0.0; POSITION_TERMS];
    for (k, b) in b.iter_mut().enumerate().skip(1) {
        let below = if k == 1 { 2.0 * a[0] } else { term(k - 1) };
        *b = (below - term(k + 1)) / (2 * k) as f64;
    }
    b[0] = (1..POSITION_TERMS).map(|k| if k % 2 == 1 { b[k] } else { -b[k] }).rev().sum();
    b
}

/// Solves `matrix`·x = `right` by elimination with row pivoting; x replaces `right`. With a
/// singular matrix x is not finite, which the caller sees.
pub(crate) fn eliminate(matrix: &mut Matrix, right: &mut Vector) {
    for k in 0..STAGES {
        let pivot = (k..STAGES)
            .fold(k, |best, i| if matrix[i][k].abs() > matrix[best][k].abs() { i } else { best });
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let (head, rest) = matrix.split_at_mut(k + 1);
        let row = &head[k];
        for (i, lower) in rest.iter_mut().enumerate() {
            let factor = lower[k] / row[k];
            for (l, r) in lower.iter_mut().zip(row) {
                *l -= factor * r;
            }
            right[k + 1 + i] -= factor * right[k];
        }
    }
    for k in (0..STAGES).rev() {
        right[k] = (right[k] - dot(&matrix[k][k + 1..], &right[k + 1..])) / matrix[k][k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponential_is_differentiated_and_integrated() {
        let value = TABLES.node.map(f64::exp);
        let start = (-1.0_f64).exp();
        let antiderivative = antiderivative(&TABLES.coefficients(&value));
        let monomial: [f64; POSITION_TERMS] = TABLES.monomials(&antiderivative);
        for (i, u) in TABLES.node.into_iter().enumerate() {
            assert!((dot(&TABLES.derivative[i], &value) - value[i]).abs() < 1e-12);
            assert!((dot(&TABLES.integral[i], &value) - (value[i] - start)).abs() < 1e-15);
            let sum = monomial.iter().rev().fold(0.0, |sum, c| sum * u + c);
            assert!((sum - (value[i] - start)).abs() < 2e-15);
        }
    }

    #[test]
    fn elimination_solves_and_shows_a_singular_matrix() {
        // Zeros on the diagonal ask for pivoting.
        let matrix: Matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { 0.0 } else { 1.0 / (1 + i + 2 * j) as f64 })
        });
        let solution: Vector = std::array::from_fn(|i| 1.0 + i as f64);
        let mut right = std::array::from_fn(|i| dot(&matrix[i], &solution));
        eliminate(&mut matrix.clone(), &mut right);
        for (x, expected) in right.iter().zip(solution) {
            assert!((x - expected).abs() < 1e-10, "{x}");
        }
        eliminate(&mut [[1.0; STAGES]; STAGES], &mut right);
        assert!(right.iter().any(|x| !x.is_finite()));
    }
}
