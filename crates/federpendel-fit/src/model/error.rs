//! What the model refuses.

use super::{Parameters, Stop};

/// Why a motion could not be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// A parameter is out of range.
    #[error("{name} = {value} is not {allowed}")]
    Parameter {
        /// Its name, as in [`Parameters`] or [`Stop`].
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A time is not finite, or before the one before it.
    #[error("time number {index} is not finite or before the one before it")]
    Times {
        /// Its index, from 0.
        index: usize,
    },
    /// The buffer for values has another length than the times.
    #[error("{times} times, but room for {values} values")]
    Length {
        /// Number of times.
        times: usize,
        /// Length of the buffer.
        values: usize,
    },
    /// The recording holds more of the motion than can be followed.
    #[error("the motion takes more than {limit} steps; it was followed up to {reached:e} s")]
    TooLong {
        /// Most steps of series that are made.
        limit: usize,
        /// Time since the first sample, s.
        reached: f64,
    },
    /// The parameters are so large or so small, one beside the other, that what follows from them is not finite.
    #[error("the motion cannot be computed: numbers on the way are not finite")]
    Overflow,
}

const FINITE: &str = "finite";
const ABOVE_ZERO: &str = "finite and above zero";
const AT_LEAST_ZERO: &str = "finite and at least zero";

/// Whether a motion can be computed from these.
pub(super) fn check(
    parameters: &Parameters,
    stop: Stop,
    times: &[f64],
    values: usize,
) -> Result<(), ModelError> {
    let Parameters { angular_frequency, damping_rate, .. } = *parameters;
    let check = |name, value: f64, good: bool, allowed| {
        let fine = value.is_finite() && good;
        if fine { Ok(()) } else { Err(ModelError::Parameter { name, value, allowed }) }
    };
    let not_negative = |name, value| check(name, value, value >= 0.0, AT_LEAST_ZERO);
    check("angular_frequency", angular_frequency, angular_frequency > 0.0, ABOVE_ZERO)?;
    not_negative("damping_rate", damping_rate)?;
    not_negative("coulomb_acceleration", parameters.coulomb_acceleration)?;
    not_negative("newton_rate", parameters.newton_rate)?;
    check("position0", parameters.position0, true, FINITE)?;
    check("velocity0", parameters.velocity0, true, FINITE)?;
    check("equilibrium", parameters.equilibrium, true, FINITE)?;
    if let Stop::Natural { static_acceleration } = stop {
        not_negative("static_acceleration", static_acceleration)?;
    }
    if times.len() != values {
        return Err(ModelError::Length { times: times.len(), values });
    }
    check_times(times)
}

fn check_times(times: &[f64]) -> Result<(), ModelError> {
    let ends_finite = times.first().is_none_or(|time| time.is_finite())
        && times.last().is_none_or(|time| time.is_finite());
    if ends_finite && times.is_sorted() {
        return Ok(());
    }
    let bad = |i: usize| !times[i].is_finite() || i > 0 && times[i] < times[i - 1];
    let index = (0..times.len()).find(|&i| bad(i)).unwrap_or(0);
    Err(ModelError::Times { index })
}
