//! The sum of squares that a fit makes small, with its derivatives.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SVector};

use crate::extremes::median;
use crate::model::{Course, Jacobian, Parameters, Stop, evaluate};
use crate::{Quantity, jumps};

/// One number for each parameter, in the order of [`NAMES`].
pub type Vector = SVector<f64, 7>;
/// Products of derivatives.
pub type Matrix = SMatrix<f64, 7, 7>;

/// The parameters by name, in the order of [`Vector`].
pub const NAMES: [&str; 7] = Parameters::NAMES;
/// Where ω0 stands.
pub const OMEGA: usize = 0;
/// Where the coefficients of friction stand: Stokes, Coulomb, Newton.
pub const LAWS: [usize; 3] = [1, 2, 3];
/// Where a_c stands.
pub const COULOMB: usize = 2;

/// Where the position and the velocity at the beginning stand.
pub const POSITION: usize = 4;
/// See [`POSITION`].
pub const VELOCITY: usize = 5;

/// The parameters as the model takes them.
pub fn parameters(p: &Vector) -> Parameters {
    Parameters::from_array((*p).into())
}

/// How the motion ends, said so that a fit may move the phase of the start.
///
/// The number of turning points up to the rest jumps by one when the velocity at the start changes
/// its sign outside the middle; the number counted in phase does not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ending {
    /// The mass stays at the turning point where the phase is π times `turn`; phases are counted
    /// from one near `near`.
    Turn {
        /// The phase there over π.
        turn: i64,
        /// A phase that the start stays near.
        near: f64,
    },
    /// It stays where kinetic friction alone holds it, if there is any.
    Natural,
}

/// The phase of the start, with x = A cos φ and v = −A ω0 sin φ.
pub fn phase(p: &Vector) -> f64 {
    (-p[5] / p[OMEGA]).atan2(p[4])
}

impl Ending {
    /// The ending after `number` turning points, counted from the start of `p`.
    pub fn after(number: u64, p: &Vector) -> Self {
        let near = phase(p);
        Ending::Turn { turn: number as i64 + (near / PI).floor() as i64, near }
    }

    /// What the model is told.
    pub fn stop(self, p: &Vector) -> Stop {
        match self {
            Ending::Natural => Stop::Never,
            Ending::Turn { turn, near } => {
                let phase = phase(p);
                let phase = phase + ((near - phase) / (2.0 * PI)).round() * 2.0 * PI;
                Stop::After((turn - (phase / PI).floor() as i64).max(1) as u64)
            }
        }
    }
}

/// How much a residual counts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Loss {
    /// Its square: least squares.
    #[default]
    Squares,
    /// Beyond 1.345 standard deviations only linearly (Huber 1964).
    Huber,
    /// Beyond 4.685 standard deviations no more than there (Tukey's biweight).
    Tukey,
}

impl Loss {
    /// The loss of a residual of `u` standard deviations, and its weight beside the square's.
    fn of(self, u: f64) -> (f64, f64) {
        const HUBER: f64 = 1.345;
        const TUKEY: f64 = 4.685;
        match self {
            Loss::Huber if u.abs() > HUBER => (HUBER * (2.0 * u.abs() - HUBER), HUBER / u.abs()),
            Loss::Tukey => {
                let inner = 1.0 - (u / TUKEY).powi(2);
                if inner > 0.0 {
                    (TUKEY * TUKEY / 3.0 * (1.0 - inner.powi(3)), inner * inner)
                } else {
                    (TUKEY * TUKEY / 3.0, 0.0)
                }
            }
            _ => (u * u, 1.0),
        }
    }
}

/// Recorded values to fit.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Times, s.
    pub times: Vec<f64>,
    /// Values.
    pub values: Vec<f64>,
    /// What they are.
    pub quantity: Quantity,
    /// How residuals count, and the standard deviation that this is measured in.
    pub loss: (Loss, f64),
    /// Half the time over which jumps of an acceleration are spread, s; see [`crate::jumps`].
    pub spread: Option<f64>,
    /// The highest angular frequency to be looked for, 1/s: half a period takes as long as from one value to the next.
    pub fastest: f64,
    model: Vec<f64>,
    jacobian: Jacobian,
    /// Evaluations of the model so far.
    pub evaluations: usize,
}

/// The sum of squares at some parameters, and its derivatives.
#[derive(Debug, Clone, Copy)]
pub struct Normal {
    /// Σ of the losses of the residuals.
    pub cost: f64,
    /// Jᵀ W (values − model): half the gradient downhill.
    pub gradient: Vector,
    /// Jᵀ W J.
    pub information: Matrix,
}

impl Normal {
    /// Adds `times` the part of one value.
    fn count(&mut self, residual: f64, row: &Vector, (loss, scale): (Loss, f64), times: f64) {
        let (counted, weight) = loss.of(residual / scale);
        self.cost += times * counted * scale * scale;
        self.gradient += row * (times * weight * residual);
        self.information += row * row.transpose() * (times * weight);
    }
}

impl Problem {
    /// The problem of all these values.
    pub fn new(times: Vec<f64>, values: Vec<f64>, quantity: Quantity) -> Self {
        let loss = (Loss::Squares, 1.0);
        let model = vec![0.0; times.len()];
        let jacobian = Jacobian::new();
        let mut steps: Vec<f64> = times.array_windows().map(|[one, next]| next - one).collect();
        let fastest = median(&mut steps).map_or(f64::INFINITY, |step| PI / step);
        let spread = None;
        Self { times, values, quantity, loss, spread, fastest, model, jacobian, evaluations: 0 }
    }

    /// How many values there are.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The mean time between values, s.
    pub fn step(&self) -> f64 {
        (self.times[self.len() - 1] - self.times[0]) / (self.len() - 1) as f64
    }

    /// The first `count` values, of which every `stride`-th is taken.
    pub fn part(&self, count: usize, stride: usize) -> Self {
        let take = |all: &[f64]| all[..count].iter().step_by(stride).copied().collect::<Vec<_>>();
        let mut part = Self::new(take(&self.times), take(&self.values), self.quantity);
        part.loss = self.loss;
        part.fastest = self.fastest;
        // Jumps are spread over so many values, of which there are fewer now.
        part.spread = self.spread.map(|half| half * stride as f64);
        part
    }

    /// Sum and derivatives at `p`; none where the model cannot be computed.
    pub fn normal(&mut self, p: &Vector, ending: Ending) -> Option<Normal> {
        let changes = match self.spread {
            Some(half) if p[COULOMB] > 0.0 => jumps::spread(self, p, ending, half)?,
            _ => {
                self.course(p, ending, true)?;
                vec![]
            }
        };
        let mut normal = self.sums();
        for change in &changes {
            normal.count(self.values[change.index] - change.was.0, &change.was.1, self.loss, -1.0);
            normal.count(self.values[change.index] - change.is.0, &change.is.1, self.loss, 1.0);
        }
        let finite = normal.information.iter().all(|x| x.is_finite());
        (normal.cost.is_finite() && finite).then_some(normal)
    }

    /// Sum and derivatives from the model's values, which it overwrites, and its derivatives.
    fn sums(&mut self) -> Normal {
        let (loss, scale) = self.loss;
        let mut cost = 0.0;
        let mut weights = Vec::new();
        for (value, model) in self.values.iter().zip(&mut self.model) {
            // The buffer of the model now takes residuals, times their weights.
            *model = value - *model;
            if loss == Loss::Squares {
                cost += *model * *model;
            } else {
                let (counted, weight) = loss.of(*model / scale);
                cost += counted * scale * scale;
                weights.push(weight);
                *model *= weight;
            }
        }
        let column = |i: usize| self.jacobian.column(i);
        let gradient = Vector::from_fn(|i, _| dot(column(i), &self.model));
        let mut information = Matrix::zeros();
        let mut weighted = Vec::new();
        for j in 0..7 {
            let plain = weights.is_empty();
            if !plain {
                weighted = column(j).iter().zip(&weights).map(|(x, w)| x * w).collect();
            }
            for i in 0..=j {
                let product = dot(column(i), if plain { column(j) } else { &weighted });
                (information[(i, j)], information[(j, i)]) = (product, product);
            }
        }
        Normal { cost, gradient, information }
    }

    /// The course of the motion at `p`; none where the model cannot be computed. Leaves the model's
    /// values, and its derivatives if asked for them.
    pub fn course(&mut self, p: &Vector, ending: Ending, derivatives: bool) -> Option<Course> {
        self.evaluations += 1;
        let (stop, quantity) = (ending.stop(p), self.quantity);
        let jacobian = derivatives.then_some(&mut self.jacobian);
        evaluate(&parameters(p), stop, &self.times, quantity, &mut self.model, jacobian).ok()
    }

    /// What the model says for `quantity` at `p`; none where it cannot be computed.
    pub fn model(&mut self, p: &Vector, ending: Ending, quantity: Quantity) -> Option<Vec<f64>> {
        let before = std::mem::replace(&mut self.quantity, quantity);
        let course = self.course(p, ending, false);
        self.quantity = before;
        course.map(|_| self.model.clone())
    }

    /// Residuals at `p`, values − model; none where the model cannot be computed.
    pub fn residuals(&mut self, p: &Vector, ending: Ending) -> Option<Vec<f64>> {
        self.course(p, ending, false)?;
        Some(self.values.iter().zip(&self.model).map(|(value, model)| value - model).collect())
    }

    /// The model's value and derivatives at `index`, as last computed.
    pub fn row(&self, index: usize) -> (f64, Vector) {
        (self.model[index], Vector::from_fn(|i, _| self.jacobian.column(i)[index]))
    }

    /// Derivatives at `p`; none where the model cannot be computed.
    pub fn derivatives(&mut self, p: &Vector, ending: Ending) -> Option<&Jacobian> {
        self.course(p, ending, true)?;
        Some(&self.jacobian)
    }
}

/// Σ a b, in eight sums side by side, which the processor adds at once.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(x, y)| x * y).sum();
    let mut sums = [0.0; 8];
    for (x, y) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += x[k] * y[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_end_of_a_motion_stays_as_its_start_passes_a_turning_point() {
        // Just before the turning point at the start it is one more to the end than just after.
        for sign in [1.0, -1.0] {
            let at = |v: f64| Vector::from([1.0, 0.0, 0.1, 0.0, sign, sign * v, 0.0]);
            let ending = Ending::after(5, &at(-1e-3));
            assert_eq!(ending.stop(&at(-1e-3)), Stop::After(5));
            assert_eq!(ending.stop(&at(1e-3)), Stop::After(6));
            assert_eq!(ending.stop(&at(0.0)), Stop::After(5));
        }
    }

    #[test]
    fn eight_sums_are_one() {
        let a: Vec<f64> = (0..37).map(f64::from).collect();
        assert_eq!(dot(&a, &a), (0..37).map(|i| f64::from(i * i)).sum::<f64>());
    }
}
