//! Whether a recording and what is asked of it make sense.

use crate::error::FitError;
use crate::options::Options;
use crate::recording::Recording;

/// Fewest values that are fitted: more than there are parameters, with some to judge them by.
pub const FEWEST: usize = 12;

/// # Errors
/// [`FitError`] for the first thing that is out of range.
pub fn check(recording: &Recording, options: &Options) -> Result<(), FitError> {
    let (times, values) = (&recording.times, &recording.values);
    if times.len() != values.len() {
        return Err(FitError::Length { times: times.len(), values: values.len() });
    }
    let bad = |index, what, value, allowed| Err(FitError::Value { index, what, value, allowed });
    for (index, (&time, &value)) in times.iter().zip(values).enumerate() {
        if !time.is_finite() || (index > 0 && time <= times[index - 1]) {
            return bad(index, "time", time, "finite and after the one before it");
        }
        if !value.is_finite() {
            return bad(index, "value", value, "finite");
        }
    }
    if let Some(sigma) = options.sigma
        && !(sigma.is_finite() && sigma > 0.0)
    {
        return Err(FitError::Option {
            name: "sigma",
            value: sigma,
            allowed: "finite and above zero",
        });
    }
    for (name, value) in [("from", options.from), ("to", options.to)] {
        if let Some(value) = value
            && !value.is_finite()
        {
            return Err(FitError::Option { name, value, allowed: "finite" });
        }
    }
    let inside = |t: &&f64| {
        options.from.is_none_or(|from| **t >= from) && options.to.is_none_or(|to| **t <= to)
    };
    let found = times.iter().filter(inside).count();
    if found < FEWEST {
        let from = options.from.or(times.first().copied()).unwrap_or(f64::NAN);
        let to = options.to.or(times.last().copied()).unwrap_or(f64::NAN);
        return Err(FitError::TooFew { found, needed: FEWEST, from, to });
    }
    Ok(())
}
