//! Sentences about quantities.

use federpendel::parameter::{ParameterInfo, Range};
use federpendel_text::{Catalogue, excerpt};

use crate::{Dimension, Error, LONGEST};

/// What is wrong with a text that should be a quantity.
pub fn quantity_problem(catalogue: &Catalogue, error: &Error) -> String {
    match error {
        Error::Empty => catalogue.text("quantity-empty"),
        Error::TooLong { length } => catalogue.format(
            "quantity-too-long",
            &[("length", (*length).into()), ("limit", LONGEST.into())],
        ),
        Error::NoNumber => catalogue.text("quantity-no-number"),
        Error::Ambiguous { decimal, grouped } => ambiguous(catalogue, decimal, grouped),
        Error::Grouped { plain } => {
            catalogue.format("quantity-grouped", &[("plain", localised(catalogue, plain))])
        }
        Error::NotFinite => catalogue.text("quantity-not-finite"),
        Error::Overflow => catalogue.text("quantity-overflow"),
        Error::Underflow => catalogue.text("quantity-underflow"),
        Error::UnknownUnit { unit, nearest: None } => {
            catalogue.format("quantity-unknown-unit", &[("unit", excerpt(unit).into())])
        }
        Error::UnknownUnit { unit, nearest: Some(nearest) } => catalogue.format(
            "quantity-unknown-unit-near",
            &[("unit", excerpt(unit).into()), ("nearest", nearest.as_str().into())],
        ),
        Error::UnitGrammar { unit } => {
            catalogue.format("quantity-unit-grammar", &[("unit", excerpt(unit).into())])
        }
        Error::WrongDimension { unit, found: Some(found) } => catalogue.format(
            "quantity-wrong-dimension",
            &[("unit", excerpt(unit).into()), ("found", measure(catalogue, *found).into())],
        ),
        Error::WrongDimension { unit, found: None } => {
            catalogue.format("quantity-nameless-dimension", &[("unit", excerpt(unit).into())])
        }
        Error::NegativeUncertainty => catalogue.text("quantity-uncertainty-negative"),
        Error::UncertaintyWithoutUnit => catalogue.text("quantity-uncertainty-unit"),
        Error::UncertaintyGrammar { .. } => catalogue.text("quantity-uncertainty-grammar"),
    }
}

/// Both readings, each in spellings that have no other.
fn ambiguous(catalogue: &Catalogue, decimal: &str, grouped: &str) -> String {
    let (whole, fraction) = decimal.split_once('.').unwrap_or((decimal, "0"));
    // Three digits behind a comma are what is ambiguous; behind a point they are not.
    let longer = if fraction.len() == 3 { format!("{fraction}0") } else { fraction.to_owned() };
    catalogue.format(
        "quantity-ambiguous",
        &[
            ("decimal", localised(catalogue, decimal)),
            ("grouped", grouped.into()),
            ("point", format!("{whole}.{fraction}").into()),
            ("comma", format!("{whole},{longer}").into()),
        ],
    )
}

/// The value of the flag of a parameter as `written`, SI.
///
/// # Errors
/// The sentence that refuses it.
pub fn flag_value(
    catalogue: &Catalogue,
    info: &ParameterInfo,
    dimension: Dimension,
    written: &str,
) -> Result<f64, String> {
    flag_value_of(catalogue, info, &[dimension], written).map(|(_, value)| value)
}

/// The value of a flag that may have one of several dimensions, SI, with the first that fits.
///
/// # Errors
/// The sentence that refuses it and names the units of all of them.
pub fn flag_value_of(
    catalogue: &Catalogue,
    info: &ParameterInfo,
    dimensions: &[Dimension],
    written: &str,
) -> Result<(Dimension, f64), String> {
    value_of(catalogue, &flag(info.name), info.range, dimensions, written)
}

/// The flag of a parameter: `--spring-mass` for `spring_mass`.
pub fn flag(parameter: &str) -> String {
    format!("--{}", parameter.replace('_', "-"))
}

/// What was `written` for the quantity `name`, which may have one of several dimensions, SI, with the first that fits.
///
/// # Errors
/// The sentence that refuses it and names the units of all of them.
pub fn value_of(
    catalogue: &Catalogue,
    name: &str,
    range: Range,
    dimensions: &[Dimension],
    written: &str,
) -> Result<(Dimension, f64), String> {
    let read =
        |&dimension: &Dimension| crate::parse(written, dimension).map(|value| (dimension, value));
    let mut values = dimensions.iter().map(read);
    let first = values.next().unwrap_or(Err(Error::Empty));
    let value = first.or_else(|error| values.find_map(Result::ok).ok_or(error));
    let problem = match &value {
        Ok(found) if range.contains(found.1) => return Ok(*found),
        Ok(_) => None,
        Err(error) => Some(quantity_problem(catalogue, error)),
    };
    Err(refusal(catalogue, name, range, dimensions, written, problem))
}

/// The sentence that refuses what was `written` for the quantity `name`; without a problem its value is out of range.
pub fn refusal(
    catalogue: &Catalogue,
    name: &str,
    range: Range,
    dimensions: &[Dimension],
    written: &str,
    problem: Option<String>,
) -> String {
    let allowed = allowed(catalogue, dimensions, range);
    let mut variables = vec![
        ("name", name.into()),
        ("value", catalogue.quoted(&excerpt(written)).into()),
        ("allowed", allowed.into()),
    ];
    match problem {
        None => catalogue.format("experiment-refusal", &variables),
        Some(problem) => {
            variables.push(("problem", problem.into()));
            catalogue.format("experiment-quantity", &variables)
        }
    }
}

/// What is allowed for a quantity: “a mass (kg, g, mg, t, lb), a finite number greater than 0”.
pub fn allowed(catalogue: &Catalogue, dimensions: &[Dimension], range: Range) -> String {
    let range = catalogue.range(range);
    let named = dimensions.iter().filter(|dimension| **dimension != Dimension::Number);
    let measures = named.map(|dimension| {
        format!("{} ({})", measure(catalogue, *dimension), dimension.units().join(", "))
    });
    let either = |one: String, other: String| {
        catalogue.format("quantity-or", &[("one", one.into()), ("other", other.into())])
    };
    measures.reduce(either).map_or(range.clone(), |measures| format!("{measures}, {range}"))
}

/// “a mass”.
fn measure(catalogue: &Catalogue, dimension: Dimension) -> String {
    catalogue.text(&format!("dimension-{}", dimension.key()))
}

fn localised(catalogue: &Catalogue, number: &str) -> federpendel_text::Value<'static> {
    number.replace('.', &catalogue.language().decimal_sign().to_string()).into()
}
