//! What a recording should show for given parameters, with exact derivatives.
//!
//! A swing is a Taylor series in a few pieces, and so are its derivatives with respect to how it starts and to the
//! coefficients of friction (`series`). The chain rule carries the derivatives of each start through the
//! reversal to the next (`start`); on a piece they make one polynomial for each parameter (`piece`), which
//! all samples there share (`record`).

mod course;
mod error;
mod jacobian;
mod parameters;
mod piece;
mod record;
mod series;
mod start;
mod walk;

pub use course::{Course, Rest, TurningPoint};
pub use error::ModelError;
pub use jacobian::Jacobian;
pub use parameters::{Parameters, Stop};

use crate::recording::Quantity;
use record::Record;

/// The values that a recording of `quantity` should hold at `times` (s, not falling), and their derivatives.
///
/// The state `position0`, `velocity0` holds at the first of the times. `jacobian` is brought to the right size; its
/// derivatives hold the pattern of swings fixed: how many of them come before each sample, and where the mass
/// stops. The times of the reversals move with the parameters. For a coefficient of zero they are
/// the derivatives to the right, for a release without velocity those of the swing towards the centre.
///
/// Measured on random motions, errors of positions stay below 1e-11 of the amplitude, those of accelerations below 1e-9 of
/// the largest. Derivatives are good to 1e-8; of accelerations with strong damping, to (1 + γ/ω0)² times that.
///
/// # Errors
/// [`ModelError`] for parameters or times out of range, for `values` of another length than `times`, and if the motion
/// would take too many steps.
pub fn evaluate(
    parameters: &Parameters,
    stop: Stop,
    times: &[f64],
    quantity: Quantity,
    values: &mut [f64],
    jacobian: Option<&mut Jacobian>,
) -> Result<Course, ModelError> {
    error::check(parameters, stop, times, values.len())?;
    match jacobian {
        None => walk::walk::<0, 1>(parameters, stop, quantity, Record::new(times, [values])),
        Some(jacobian) => {
            jacobian.resize(times.len());
            let [c0, c1, c2, c3, c4, c5, c6] = jacobian.columns_mut();
            let record = Record::new(times, [values, c0, c1, c2, c3, c4, c5, c6]);
            walk::walk::<4, 8>(parameters, stop, quantity, record)
        }
    }
}
