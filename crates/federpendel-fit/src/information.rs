//! What a recording of a known motion can tell: Fisher's information, and the standard errors that follow from it.

use std::ops::Range;

use federpendel::Mix;

use crate::Quantity;
use crate::mixes::free;
use crate::model::{Jacobian, ModelError, Parameters, Stop, evaluate};
use crate::problem::{Matrix, Vector};

/// Fisher's information on the [`Parameters`] in values with independent normal noise of standard deviation 1:
/// I_ij = Σ ∂x/∂θ_i ∂x/∂θ_j over the values (Kay 1993, eq. 3.33). Times 1/σ² for noise of standard deviation σ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Information(Matrix);

impl Information {
    /// That of no values at all.
    pub(crate) fn none() -> Self {
        Information(Matrix::zeros())
    }

    /// The information in `quantity` at `times` (s, not falling) of the motion with these parameters.
    ///
    /// # Errors
    /// What [`evaluate`] refuses.
    pub fn of(
        parameters: &Parameters,
        stop: Stop,
        times: &[f64],
        quantity: Quantity,
    ) -> Result<Self, ModelError> {
        let mut jacobian = Jacobian::new();
        let mut values = vec![0.0; times.len()];
        evaluate(parameters, stop, times, quantity, &mut values, Some(&mut jacobian))?;
        let mut information = Self::none();
        information.add(&jacobian, 0..times.len(), 1.0);
        Ok(information)
    }

    /// Adds these values, each of which counts `times` times.
    pub(crate) fn add(&mut self, jacobian: &Jacobian, values: Range<usize>, times: f64) {
        let column = |i: usize| &jacobian.column(i)[values.clone()];
        for i in 0..Parameters::COUNT {
            for j in 0..=i {
                let sum: f64 = column(i).iter().zip(column(j)).map(|(a, b)| a * b).sum();
                self.0[(i, j)] += times * sum;
                self.0[(j, i)] = self.0[(i, j)];
            }
        }
    }

    /// The smallest covariance that any unbiased estimate of the parameters can have (Cramér and Rao), with noise of
    /// standard deviation `sigma`, where the laws of `fitted` are free and the others known not to act; rows and
    /// columns in the order of the parameters. Infinite on the diagonal where nothing is known, zero for what is not
    /// fitted.
    pub fn covariance(
        &self,
        fitted: Mix,
        sigma: f64,
    ) -> [[f64; Parameters::COUNT]; Parameters::COUNT] {
        let inverse = inverse(&self.0, &free(fitted));
        std::array::from_fn(|i| std::array::from_fn(|j| inverse[(i, j)] * sigma * sigma))
    }

    /// The standard error of parameter `index`, in the order of [`Parameters`], as for [`Self::covariance`].
    pub fn stderr(&self, fitted: Mix, index: usize, sigma: f64) -> f64 {
        self.covariance(fitted, sigma)[index][index].sqrt()
    }
}

/// The inverse of the part of an information matrix that belongs to `free` parameters, scaled to a diagonal of ones on
/// the way. Infinite on the diagonal of all of them if the part is singular, zero for what is not free.
pub(crate) fn inverse(information: &Matrix, free: &[bool; 7]) -> Matrix {
    let scale = Vector::from_fn(|i, _| information[(i, i)].sqrt());
    let used = |i: usize| free[i] && scale[i] > 0.0;
    let scaled = Matrix::from_fn(|i, j| match i == j {
        true => 1.0 + 1e-13,
        false if used(i) && used(j) => information[(i, j)] / (scale[i] * scale[j]),
        false => 0.0,
    });
    let inverse = scaled.cholesky().map(|factor| factor.inverse());
    Matrix::from_fn(|i, j| match &inverse {
        Some(inverse) if used(i) && used(j) => inverse[(i, j)] / (scale[i] * scale[j]),
        // Nothing is known where the curvature vanishes.
        _ if i == j && free[i] => f64::INFINITY,
        _ => 0.0,
    })
}
