//! Sentences about experiments.

use federpendel::parameter::Range;
use federpendel_text::Catalogue;

use super::syntax::not_toml;
use super::{allowed, quantity_problem};
use crate::experiment::{Allowed, Error, Field, Given, LARGEST_FILE, Origin};
use crate::quantity::Dimension;

/// The sections of an experiment file.
const SECTIONS: &str = "oscillator, friction, release, record";

/// One sentence that says why an experiment is refused; `file` is what the user called it.
pub fn experiment_error(catalogue: &Catalogue, error: &Error, file: Option<&str>) -> String {
    let sentence = sentence(catalogue, error);
    match (file, line(error)) {
        (Some(file), Some(Some(line))) => format!("{file}:{line}: {sentence}"),
        (Some(file), Some(None)) => format!("{file}: {sentence}"),
        _ => sentence,
    }
}

fn sentence(catalogue: &Catalogue, error: &Error) -> String {
    match error {
        Error::TooLarge => {
            catalogue.format("experiment-too-large", &[("limit", LARGEST_FILE.into())])
        }
        Error::NotUtf8 { offset } => {
            let variables = [("offset", (*offset).into()), ("sections", SECTIONS.into())];
            catalogue.format("experiment-not-utf8", &variables)
        }
        Error::EmptyFile => catalogue.format("experiment-empty", &[("sections", SECTIONS.into())]),
        Error::Syntax { problem, example, .. } => not_toml(catalogue, problem, example.as_deref()),
        Error::UnknownKey { path, nearest, allowed, .. } => {
            unknown_key(catalogue, path, nearest.as_deref(), allowed)
        }
        Error::WrongType { path, written, allowed, .. } => refusal(
            catalogue,
            path,
            &catalogue.quoted(bare(written)),
            &match allowed {
                Allowed::Quantity(field) => field_allowed(catalogue, *field),
                Allowed::Keys(keys) => {
                    catalogue.format("experiment-allowed-keys", &[("keys", keys.join(", ").into())])
                }
            },
        ),
        Error::Quantity { given, error } => catalogue.format(
            "experiment-quantity",
            &[
                ("name", name(given).into()),
                ("value", written(catalogue, given).into()),
                ("problem", quantity_problem(catalogue, error).into()),
                ("allowed", field_allowed(catalogue, given.field).into()),
            ],
        ),
        Error::Range(given) => {
            let allowed = catalogue.range(given.field.info().range);
            refusal(catalogue, &name(given), &written(catalogue, given), &allowed)
        }
        Error::Missing(field) => catalogue.format(
            "experiment-missing",
            &[
                ("name", field.path().into()),
                ("flag", field.flag().into()),
                ("allowed", field_allowed(catalogue, *field).into()),
            ],
        ),
        Error::TooManySamples { given, fit } => catalogue.format(
            "experiment-too-many-samples",
            &[
                ("name", name(given).into()),
                ("value", written(catalogue, given).into()),
                ("fit", (*fit).to_string().into()),
            ],
        ),
        Error::Core(error) => catalogue.error(error),
        _ => at_odds(catalogue, error),
    }
}

/// Sentences about values that are good one by one but do not go together.
fn at_odds(catalogue: &Catalogue, error: &Error) -> String {
    let pair = |id: &str, first: &Given, other_name: String, other_value: String| {
        catalogue.format(
            id,
            &[
                ("name", name(first).into()),
                ("value", written(catalogue, first).into()),
                ("other", other_name.into()),
                ("otherValue", other_value.into()),
            ],
        )
    };
    match error {
        Error::Both { first, second } => {
            pair("experiment-both", first, name(second), written(catalogue, second))
        }
        Error::StaticBelowKinetic { static_, kinetic } => pair(
            "experiment-static-below-kinetic",
            static_,
            name(kinetic),
            written(catalogue, kinetic),
        ),
        Error::Incomplete { given, missing } => catalogue.format(
            "experiment-incomplete",
            &[
                ("name", name(given).into()),
                ("value", written(catalogue, given).into()),
                ("missing", sibling(given, *missing).into()),
                ("density", beside(given, Field::Density).into()),
                ("drag", beside(given, Field::DragCoefficient).into()),
                ("area", beside(given, Field::Area).into()),
                ("coefficient", beside(given, Field::NewtonCoefficient).into()),
            ],
        ),
        Error::StaticWithoutKinetic(given) => catalogue.format(
            "experiment-static-without-kinetic",
            &[
                ("name", name(given).into()),
                ("value", written(catalogue, given).into()),
                ("missing", sibling(given, Field::Kinetic).into()),
            ],
        ),
        Error::NoNormalForce(given) => catalogue.format(
            "experiment-no-normal-force",
            &[("name", name(given).into()), ("value", written(catalogue, given).into())],
        ),
        // Every other error is said by `sentence`.
        other => other.to_string(),
    }
}

fn unknown_key(
    catalogue: &Catalogue,
    path: &str,
    nearest: Option<&str>,
    allowed: &[&str],
) -> String {
    let allowed = allowed.join(", ");
    match nearest {
        Some(nearest) => catalogue.format(
            "experiment-unknown-key-near",
            &[("name", path.into()), ("nearest", nearest.into()), ("allowed", allowed.into())],
        ),
        None => catalogue.format(
            "experiment-unknown-key",
            &[("name", path.into()), ("allowed", allowed.into())],
        ),
    }
}

fn refusal(catalogue: &Catalogue, name: &str, value: &str, allowed: &str) -> String {
    catalogue.format(
        "experiment-refusal",
        &[("name", name.into()), ("value", value.into()), ("allowed", allowed.into())],
    )
}

fn field_allowed(catalogue: &Catalogue, field: Field) -> String {
    match (field.dimension(), field.info().range) {
        (Dimension::Number, range @ Range::CountFromTwo) => catalogue.range(range),
        (dimension, range) => allowed(catalogue, &[dimension], range),
    }
}

/// A field as the user wrote it: its path in the file, or its flag.
fn name(given: &Given) -> String {
    match given.origin {
        Origin::File { .. } => given.field.path().to_owned(),
        Origin::Flag => format!("--{}", given.field.flag()),
    }
}

/// Another field, named in the way in which `given` was given.
fn sibling(given: &Given, field: Field) -> String {
    match given.origin {
        Origin::File { .. } => field.path().to_owned(),
        Origin::Flag => format!("--{}", field.flag()),
    }
}

/// The same without the section that both stand in.
fn beside(given: &Given, field: Field) -> String {
    let name = sibling(given, field);
    name.rsplit('.').next().unwrap_or(&name).to_owned()
}

/// A value as it was typed, in the quotes of the language and not in those of TOML.
fn written(catalogue: &Catalogue, given: &Given) -> String {
    match given.origin {
        Origin::File { .. } => catalogue.quoted(bare(&given.written)),
        Origin::Flag => catalogue.quoted(&given.written),
    }
}

fn bare(written: &str) -> &str {
    let within = |quote| written.strip_prefix(quote)?.strip_suffix(quote);
    within('"').or_else(|| within('\'')).unwrap_or(written)
}

/// `None` for what is not about a file; `Some(None)` for a file as a whole.
fn line(error: &Error) -> Option<Option<usize>> {
    let of = |given: &Given| match given.origin {
        Origin::File { line } => Some(Some(line)),
        Origin::Flag => None,
    };
    match error {
        Error::TooLarge | Error::NotUtf8 { .. } | Error::EmptyFile | Error::Missing(_) => {
            Some(None)
        }
        Error::Syntax { line, .. }
        | Error::UnknownKey { line, .. }
        | Error::WrongType { line, .. } => Some(Some(*line)),
        Error::Quantity { given, .. }
        | Error::Range(given)
        | Error::Incomplete { given, .. }
        | Error::StaticWithoutKinetic(given)
        | Error::NoNormalForce(given)
        | Error::TooManySamples { given, .. }
        | Error::StaticBelowKinetic { static_: given, .. }
        | Error::Both { second: given, .. } => of(given),
        Error::Core(_) => None,
    }
}
