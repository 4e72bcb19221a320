//! What was measured beside a recording, from the flags of `fit` to numbers.

use federpendel::parameter::{GRAVITY, MASS, NORMAL_FORCE, ParameterInfo, Range, STIFFNESS};
use federpendel_fit::{Given, Measured, Normal};
use federpendel_text::{Catalogue, excerpt};

use crate::args::Beside;
use crate::failure::{Failure, note};
use crate::quantity::{Dimension, parse_uncertain};
use crate::words::{flag_refusal, quantity_problem};

/// Mass of the spring; no experiment has one.
const SPRING_MASS: ParameterInfo = ParameterInfo {
    name: "spring_mass",
    symbol: "m_s",
    unit: "kg",
    range: Range::NonNegative,
    default: None,
};

/// Beyond this share of a value its uncertainty is too much for propagation along tangents.
const MOST_UNCERTAIN: f64 = 0.5;

/// What μ is made with: dry friction needs something to press the body on its guide.
const PRESSES: ParameterInfo = ParameterInfo { range: Range::Positive, ..NORMAL_FORCE };
const WEIGHS: ParameterInfo = ParameterInfo { range: Range::Positive, ..GRAVITY };

/// The numbers that are given.
///
/// # Errors
/// [`Failure::Input`] for the first flag that is refused, and for flags that contradict each other.
pub(crate) fn given(beside: &Beside, catalogue: &Catalogue) -> Result<Given, Failure> {
    let read = |info: &ParameterInfo, dimension: Dimension, written: &Option<String>| {
        let value = |written: &String| measured(info, dimension, written, catalogue);
        written.as_ref().map(value).transpose().map_err(Failure::Input)
    };
    let normal_force = read(&PRESSES, Dimension::Force, &beside.normal_force)?;
    let gravity = read(&WEIGHS, Dimension::Acceleration, &beside.gravity)?;
    let refused = |id: &str, written: &Option<String>| {
        let written = excerpt(written.as_deref().unwrap_or_default());
        let value = catalogue.quoted(&written);
        Err(Failure::Input(catalogue.format(id, &[("value", value.into())])))
    };
    let normal = match (normal_force, gravity) {
        (Some(_), _) if beside.horizontal => {
            return refused("physical-horizontal-twice", &beside.normal_force);
        }
        (_, Some(_)) if !beside.horizontal => {
            return refused("physical-gravity-alone", &beside.gravity);
        }
        (Some(force), _) => Some(Normal::Force(force)),
        (None, gravity) => {
            let usual = GRAVITY.default.map(|value| Measured { value, uncertainty: 0.0 });
            gravity.or(usual).filter(|_| beside.horizontal).map(Normal::Weight)
        }
    };
    Ok(Given {
        mass: read(&MASS, Dimension::Mass, &beside.mass)?,
        stiffness: read(&STIFFNESS, Dimension::Stiffness, &beside.stiffness)?,
        spring_mass: read(&SPRING_MASS, Dimension::Mass, &beside.spring_mass)?,
        normal,
    })
}

/// The value of a flag with its uncertainty, or the sentence that refuses it.
fn measured(
    info: &ParameterInfo,
    dimension: Dimension,
    written: &str,
    catalogue: &Catalogue,
) -> Result<Measured, String> {
    let problem = match parse_uncertain(written, dimension) {
        Ok(measured) if !info.range.contains(measured.value) => None,
        Ok(measured) if measured.uncertainty > MOST_UNCERTAIN * measured.value => {
            Some(catalogue.text("quantity-uncertainty-large"))
        }
        Ok(measured) => {
            note_bare(info, written, measured, catalogue);
            return Ok(measured);
        }
        Err(error) => Some(quantity_problem(catalogue, &error)),
    };
    Err(flag_refusal(catalogue, info, &[dimension], written, problem))
}

/// Says in what unit a bare number is taken, for “250” is more often grams than kilograms.
fn note_bare(info: &ParameterInfo, written: &str, measured: Measured, catalogue: &Catalogue) {
    // 9.81 can only be in m/s².
    if info.name != GRAVITY.name && parse_uncertain(written, Dimension::Number).is_ok() {
        let name = format!("--{}", info.name.replace('_', "-"));
        let value = catalogue.exact_quantity(measured.value, info.unit);
        let variables = [("name", name.into()), ("value", value.into())];
        note(&catalogue.format("physical-bare-number", &variables));
    }
}
