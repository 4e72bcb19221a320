//! The recorded quantity and its derivatives on one piece of a swing, as polynomials.

use super::series::{DEGREE, Series};
use super::start::{Frame, OMEGA, Reduced, Start, VALUE};
use crate::recording::Quantity;

/// Polynomials in the time from the centre of a series, ω0 t: those of the first `K` entries of a
/// [`Jet`](super::start::Jet), the value and perhaps its derivatives.
pub(super) struct Piece<const K: usize> {
    rows: [[f64; K]; DEGREE],
    used: usize,
}

/// Part of the quantity that the terms left out may make up.
const NEGLIGIBLE: f64 = 1e-13;

/// How often the position is differentiated.
fn derivative_order(quantity: Quantity) -> usize {
    match quantity {
        Quantity::Position => 0,
        Quantity::Velocity => 1,
        Quantity::Acceleration => 2,
    }
}

/// Entry n of row q is the coefficient of degree n of the q-th derivative over that of degree n + q.
const DIFFERENTIATED: [[f64; DEGREE + 1]; 4] = {
    let mut table = [[1.0; DEGREE + 1]; 4];
    let mut q = 1;
    while q < 4 {
        let mut n = 0;
        while n <= DEGREE {
            table[q][n] = table[q - 1][n] * (n + q) as f64;
            n += 1;
        }
        q += 1;
    }
    table
};

impl<const K: usize> Piece<K> {
    /// The polynomials on `series`, which has its centre at `center` in the swing from `start`.
    #[inline(always)]
    pub fn new<const D: usize>(
        quantity: Quantity,
        reduced: &Reduced,
        (start, frame): (&Start, &Frame),
        center: f64,
        series: &Series<D>,
    ) -> Self {
        let order = derivative_order(quantity);
        let omega = reduced.omega;
        let scale = frame.side * omega.powi(order as i32);
        let used = DEGREE - order;
        let mut rows = [[0.0; K]; DEGREE];
        let mut earlier = 0.0;
        for (n, row) in rows.iter_mut().enumerate().take(used) {
            let factor = scale * DIFFERENTIATED[order][n];
            let value = factor * series.y[n + order];
            // The rate of change with τ, by which a change of ω0 or of the start of the swing acts too.
            let rate = scale * DIFFERENTIATED[order + 1][n] * series.y[n + order + 1];
            let mut jet = frame.chain(&series.dy[n + order].map(|dy| factor * dy));
            for (entry, time) in jet.iter_mut().zip(&start.time) {
                *entry -= rate * omega * time;
            }
            // τ = ω0 (t − start), and velocities are multiplied by ω0.
            jet[OMEGA] += (center * rate + earlier + order as f64 * value) / omega;
            jet[VALUE] = value;
            row.copy_from_slice(&jet[..K]);
            earlier = rate;
        }
        let shift = if order == 0 { frame.side } else { 0.0 };
        for (k, entry) in rows[0].iter_mut().enumerate() {
            *entry += shift * reduced.offset[k] + reduced.equilibrium[k];
        }
        Piece { rows, used }
    }

    /// As many coefficients of each as matter up to the distance `reach` from the centre.
    #[inline(always)]
    pub fn rows(&self, reach: f64) -> &[[f64; K]] {
        let (mut sizes, mut power) = ([0.0_f64; K], 1.0);
        for row in &self.rows[..self.used] {
            for (size, entry) in sizes.iter_mut().zip(row) {
                let entry = entry.abs() * power;
                // Unlike `max`, this takes no care of NaN.
                *size = if entry > *size { entry } else { *size };
            }
            power *= reach;
        }
        let allowed = sizes.map(|size| NEGLIGIBLE * size);
        let (mut used, mut rest) = (self.used, [0.0; K]);
        while used > 1 {
            power /= reach;
            for (rest, entry) in rest.iter_mut().zip(&self.rows[used - 1]) {
                *rest += entry.abs() * power;
            }
            if rest.iter().zip(&allowed).any(|(rest, allowed)| rest > allowed) {
                break;
            }
            used -= 1;
        }
        &self.rows[..used]
    }
}
