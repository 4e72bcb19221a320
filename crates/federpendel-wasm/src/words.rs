//! Texts, numbers and what is typed.

use std::sync::OnceLock;

use federpendel::Mix;
use federpendel::parameter::{PARAMETERS, ParameterInfo};
use federpendel_quantity::words::refusal;
use federpendel_quantity::{Dimension, parse, words};
use federpendel_text::{Catalogue, Language, Value};

use crate::Refusal;

/// The catalogue of a language by its tag; English where the tag is not known. Each is read once.
pub fn catalogue(tag: &str) -> &'static Catalogue {
    static CATALOGUES: [OnceLock<Catalogue>; 2] = [OnceLock::new(), OnceLock::new()];
    let language = Language::from_tag(tag).unwrap_or_default();
    CATALOGUES[language as usize].get_or_init(|| Catalogue::of_page(language))
}

/// The sentence `id` with its variables, a JSON object of texts and numbers.
///
/// # Errors
/// A refusal if there is no such sentence or `variables` is no such object: a fault of the page, not of its user.
pub fn text(catalogue: &Catalogue, id: &str, variables: &str) -> Result<String, Refusal> {
    if !catalogue.contains(id) {
        return Err(Refusal::new("id", id.to_owned()));
    }
    let variables: serde_json::Map<String, serde_json::Value> =
        serde_json::from_str(variables).map_err(|error| Refusal::new(id, error.to_string()))?;
    let values: Vec<_> =
        variables.iter().map(|(name, value)| (name.as_str(), spoken(value))).collect();
    Ok(catalogue.format(id, &values))
}

fn spoken(value: &serde_json::Value) -> Value<'_> {
    match value {
        serde_json::Value::String(text) => text.as_str().into(),
        serde_json::Value::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(whole), _) => whole.into(),
            (None, number) => number.unwrap_or(f64::NAN).into(),
        },
        other => other.to_string().into(),
    }
}

/// What is typed into the field of the parameter `name`, SI: a number with point or comma and, if one likes, a unit.
///
/// # Errors
/// A refusal that names the field, what was typed, and what is allowed.
pub fn read(catalogue: &Catalogue, written: &str, name: &str) -> Result<f64, Refusal> {
    let known = PARAMETERS.iter().find(|info| info.name == name);
    let info: &ParameterInfo = known.ok_or_else(|| Refusal::new(name, name.to_owned()))?;
    let dimension = Dimension::of_unit(info.unit).unwrap_or(Dimension::Number);
    let problem = match parse(&with_point(catalogue, written), dimension) {
        Ok(value) if info.range.contains(value) => return Ok(value),
        Ok(_) => None,
        Err(error) => Some(words::quantity_problem(catalogue, &error)),
    };
    let label = catalogue.parameter(info).name;
    Err(Refusal::new(name, refusal(catalogue, &label, info.range, &[dimension], written, problem)))
}

/// On a page that writes numbers with a comma, a comma is none that separates thousands: "4,905" is what the page itself
/// shows, and must be read so.
fn with_point(catalogue: &Catalogue, written: &str) -> String {
    let only = written.matches(['.', ',']).count() == 1;
    match catalogue.language() {
        Language::German if only => written.replace(',', "."),
        _ => written.to_owned(),
    }
}

/// A law of friction and what it is called.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Law {
    /// `stokes`, `coulomb` or `newton`.
    pub law: &'static str,
    /// “Stokes friction”.
    pub label: String,
}

/// The three laws.
pub fn laws(catalogue: &Catalogue) -> Vec<Law> {
    let names = [("stokes", 0), ("coulomb", 1), ("newton", 2)];
    let law = |(law, number): (&'static str, usize)| {
        let mix = Mix { stokes: number == 0, coulomb: number == 1, newton: number == 2 };
        Law { law, label: catalogue.mix(mix) }
    };
    names.into_iter().map(law).collect()
}
