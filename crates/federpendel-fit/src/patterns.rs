//! What a wrong model leaves in the residuals: patterns that go with the motion, as columns of a small linear model.

use nalgebra::{DMatrix, DVector};

use crate::Quantity;
use crate::adequacy::Fault;
use crate::least_squares::Minimum;
use crate::problem::{LAWS, OMEGA, Problem, Vector};

/// The sum of squares.
pub fn square(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum()
}

/// What patterns are made of.
pub struct Patterns {
    /// The motion, from its zero, and its derivative.
    pub swing: Vec<f64>,
    pub slope: Vec<f64>,
    /// Position and velocity over ω0: the square of the amplitude.
    pub amplitude2: Vec<f64>,
    /// Times from −1 to 1.
    pub unit_times: Vec<f64>,
    pub times: Vec<f64>,
    pub span: f64,
    pub residuals: Vec<f64>,
    pub cost: f64,
    pub base: Vec<Vec<f64>>,
}

/// Residuals with some patterns taken away.
pub struct Explained {
    pub weights: Vec<f64>,
    pub left: Vec<f64>,
}

impl Patterns {
    pub fn new(problem: &mut Problem, minimum: &Minimum, free: &[bool; 7]) -> Option<Self> {
        let (p, ending) = (&minimum.at, minimum.ending);
        let residuals = problem.residuals(p, ending)?;
        let mut bare: Vector = *p;
        bare[6] = 0.0;
        let x = problem.model(&bare, ending, Quantity::Position)?;
        let v = problem.model(&bare, ending, Quantity::Velocity)?;
        let a = problem.model(&bare, ending, Quantity::Acceleration)?;
        let (omega, rate) = (p[OMEGA], p[LAWS[0]]);
        let jerk = |(v, a): (&f64, &f64)| -omega * omega * v - 2.0 * rate * a;
        let amplitude2 =
            x.iter().zip(&v).map(|(x, v)| x * x + (v / omega).powi(2)).collect::<Vec<_>>();
        let (swing, slope) = match problem.quantity {
            Quantity::Position => (x, v),
            Quantity::Velocity => (v, a),
            Quantity::Acceleration => {
                let slope = v.iter().zip(&a).map(jerk).collect();
                (a, slope)
            }
        };
        let times = problem.times.clone();
        let span = times[times.len() - 1] - times[0];
        let unit_times = times.iter().map(|t| 2.0 * (t - times[0]) / span - 1.0).collect();
        let jacobian = problem.derivatives(p, ending)?;
        let base =
            (0..7).filter(|&i| free[i]).map(|i| jacobian.column(i).to_vec()).collect::<Vec<_>>();
        let cost = square(&residuals);
        Some(Self { swing, slope, amplitude2, unit_times, times, span, residuals, cost, base })
    }

    /// The sum of squares of as many values of a swing that stays as wide as the widest.
    pub fn widest(&self) -> f64 {
        let widest = self.swing.iter().fold(0.0f64, |widest, x| widest.max(x.abs()));
        0.5 * widest * widest * self.swing.len() as f64
    }

    /// `direction` times Legendre polynomials of time, from the first degree to `highest`.
    pub fn along(&self, direction: &[f64], highest: usize) -> Vec<Vec<f64>> {
        let column = |degree| {
            let pairs = self.unit_times.iter().zip(direction);
            pairs.map(|(&u, d)| legendre(degree, u) * d).collect()
        };
        (1..=highest).map(column).collect()
    }

    /// A phase that runs ahead in proportion to the square of the amplitude.
    pub fn softening(&self) -> Vec<Vec<f64>> {
        let widest = self.amplitude2.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let mut ahead = 0.0;
        let mut before = self.times[0];
        let parts = self.times.iter().zip(&self.amplitude2).zip(&self.slope);
        let column = parts.map(|((&time, a2), slope)| {
            ahead += (time - before) * a2 / widest;
            before = time;
            slope * ahead
        });
        vec![column.collect()]
    }

    /// The second and third powers of the motion.
    pub fn shape(&self) -> Vec<Vec<f64>> {
        let widest = self.swing.iter().fold(f64::MIN_POSITIVE, |w, x| w.max(x.abs()));
        [2, 3].map(|n| self.swing.iter().map(|x| x * (x / widest).powi(n - 1)).collect()).to_vec()
    }

    /// Least squares of the residuals on the derivatives of the fit and on `columns`.
    pub fn explain(&self, columns: &[&Vec<f64>]) -> Option<Explained> {
        let all: Vec<&Vec<f64>> = self.base.iter().chain(columns.iter().copied()).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let scale: Vec<f64> = all.iter().map(|c| dot(c, c).sqrt().max(f64::MIN_POSITIVE)).collect();
        let k = all.len();
        let mut matrix = DMatrix::zeros(k, k);
        for i in 0..k {
            for j in 0..=i {
                let product = dot(all[i], all[j]) / (scale[i] * scale[j]);
                (matrix[(i, j)], matrix[(j, i)]) = (product, product);
            }
            // What the derivatives say already is left to them.
            matrix[(i, i)] += 1e-9;
        }
        let right = DVector::from_fn(k, |i, _| dot(all[i], &self.residuals) / scale[i]);
        let solved = matrix.cholesky()?.solve(&right);
        let mut left = self.residuals.clone();
        for (column, weight) in all.iter().zip(solved.iter().zip(&scale).map(|(w, s)| w / s)) {
            left.iter_mut().zip(column.iter()).for_each(|(r, c)| *r -= weight * c);
        }
        let weights = (self.base.len()..k).map(|i| solved[i] / scale[i]).collect();
        Some(Explained { weights, left })
    }

    /// The fault by its name and the effect in its own measure.
    pub fn named(&self, fault: Fault, found: &Explained) -> (Fault, f64) {
        if fault == Fault::Softening {
            // The weight is the relative change of frequency at the widest swing.
            let change = found.weights[0];
            return (if change < 0.0 { fault } else { Fault::Hardening }, change.abs());
        }
        let largest =
            |values: &mut dyn Iterator<Item = f64>| values.fold(0.0f64, |l, x| l.max(x.abs()));
        let pattern =
            largest(&mut self.residuals.iter().zip(&found.left).map(|(r, left)| r - left));
        (fault, pattern / largest(&mut self.swing.iter().copied()))
    }
}

/// Legendre's polynomial of `degree` by Bonnet's recursion.
fn legendre(degree: usize, u: f64) -> f64 {
    let (mut before, mut now) = (1.0, u);
    for n in 1..degree {
        let n = n as f64;
        (before, now) = (now, ((2.0 * n + 1.0) * u * now - n * before) / (n + 1.0));
    }
    if degree == 0 { before } else { now }
}
