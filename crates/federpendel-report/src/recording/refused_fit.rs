//! Why nothing can be fitted to a recording.

use federpendel::parameter::Range;
use federpendel_fit::FitError;
use federpendel_text::{Catalogue, Value};

/// One sentence that says why nothing can be fitted to a recording; `file` is what the user called it.
pub fn fit_error(catalogue: &Catalogue, error: &FitError, file: &str) -> String {
    let time = |time: f64| Value::from(catalogue.exact_quantity(time, "s"));
    let sentence = match *error {
        FitError::Length { times, values } => catalogue
            .format("fit-refused-length", &[("times", times.into()), ("values", values.into())]),
        FitError::TooFew { found, needed, from, to } => catalogue.format(
            "fit-refused-too-few",
            &[
                ("found", found.into()),
                ("needed", needed.into()),
                ("from", time(from)),
                ("to", time(to)),
            ],
        ),
        FitError::Value { index, what: "time", value, .. } => catalogue
            .format("fit-refused-time", &[("number", (index + 1).into()), ("value", time(value))]),
        FitError::Value { index, value, .. } => catalogue.format(
            "fit-refused-value",
            &[
                ("number", (index + 1).into()),
                ("value", catalogue.exact_quantity(value, "1").into()),
                ("allowed", catalogue.range(Range::Finite).into()),
            ],
        ),
        // An option does not stand in the file.
        FitError::Option { name, value, .. } => return option(catalogue, name, value),
        FitError::Still { from, to } => {
            catalogue.format("fit-refused-still", &[("from", time(from)), ("to", time(to))])
        }
        FitError::NoOscillation { from, to } => catalogue
            .format("fit-refused-no-oscillation", &[("from", time(from)), ("to", time(to))]),
        FitError::NoFit { from, to } => {
            catalogue.format("fit-refused-no-fit", &[("from", time(from)), ("to", time(to))])
        }
    };
    format!("{file}: {sentence}")
}

/// An option that makes no sense: `sigma`, or the beginning or end of the part to be fitted.
fn option(catalogue: &Catalogue, name: &'static str, value: f64) -> String {
    let (range, unit) = if name == "sigma" { (Range::Positive, "1") } else { (Range::Finite, "s") };
    catalogue.format(
        "fit-refused-option",
        &[
            ("name", name.into()),
            ("value", catalogue.exact_quantity(value, unit).into()),
            ("allowed", catalogue.range(range).into()),
        ],
    )
}
