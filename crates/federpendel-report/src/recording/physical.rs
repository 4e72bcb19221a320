//! Physical numbers of a fit, as rows and in sentences.

use federpendel::parameter::PARAMETERS;
use federpendel_fit::physical::Absent;
use federpendel_fit::unit::NAMELESS;
use federpendel_fit::{Agreement, Estimate, Normal};
use federpendel_text::Catalogue;

use super::Fitted;

/// Beyond so many standard deviations the given mass and stiffness contradict the recording.
const CONTRADICTS: f64 = 3.0;

/// Names and values of the physical numbers that are known; empty where nothing was measured beside the recording.
pub fn physical_rows(fit: &Fitted, catalogue: &Catalogue) -> Vec<(String, String)> {
    let Some(physical) = &fit.physical else { return vec![] };
    // Without a spring's mass the moving mass is that of the body.
    let shown = |name: &str| name != "moving_mass" || physical.given.spring_mass.is_some();
    let known = physical.numbers().into_iter().filter(|(name, _)| shown(name));
    let known = known.filter_map(|(name, answer)| Some((name, answer.ok()?)));
    let mut rows: Vec<(String, String)> = known
        .map(|(name, number)| (row_name(catalogue, name), value(catalogue, &number)))
        .collect();
    rows.extend(physical.agreement.map(|agreement| {
        (catalogue.text("physical-row-agreement"), difference(catalogue, agreement))
    }));
    rows
}

/// What is assumed, what does not agree, and why some numbers are not given.
pub fn physical_sentences(fit: &Fitted, catalogue: &Catalogue) -> Vec<String> {
    let Some(physical) = &fit.physical else { return vec![] };
    let mut sentences = Vec::new();
    let agreement = physical.agreement;
    sentences.extend(agreement.filter(|one| one.deviation.abs() > CONTRADICTS).map(|one| {
        // A spring that counts as massless makes C/M too large.
        let forgotten = one.deviation > 0.0 && physical.given.spring_mass.is_none();
        let id = if forgotten { "physical-contradicts-spring" } else { "physical-contradicts" };
        catalogue.format(id, &[("difference", difference(catalogue, one).into())])
    }));
    if matches!(physical.given.normal, Some(Normal::Weight(_))) && physical.kinetic.is_ok() {
        sentences.push(catalogue.text("physical-weight"));
    }
    for (reason, id) in [
        (Absent::Angle, "physical-absent-angle"),
        (Absent::Mass, "physical-absent-mass"),
        (Absent::NormalForce, "physical-absent-normal-force"),
        (Absent::SpringMass, "physical-absent-spring-mass"),
    ] {
        if physical.lacks(reason) {
            sentences.push(catalogue.text(id));
        }
    }
    let unit = fit.report.length_unit();
    if unit == NAMELESS && !physical.lacks(Absent::Angle) {
        sentences.push(catalogue.text("physical-absent-unit"));
    } else if physical.lacks(Absent::Length) {
        sentences.push(catalogue.format("physical-absent-length", &[("unit", unit.into())]));
    }
    sentences
}

/// The symbol of a physical number.
pub(super) fn symbol(name: &str) -> &'static str {
    PARAMETERS.iter().find(|info| info.name == name).map_or("F_c", |info| info.symbol)
}

/// “mass m”.
fn row_name(catalogue: &Catalogue, name: &str) -> String {
    match (name, PARAMETERS.iter().find(|info| info.name == name)) {
        (_, Some(info)) => format!("{} {}", catalogue.parameter(info).name, info.symbol),
        ("moving_mass", None) => catalogue.text("physical-row-moving-mass"),
        _ => catalogue.text("physical-row-coulomb-force"),
    }
}

/// A value with its error, or the interval that is all that is known.
pub(super) fn value(catalogue: &Catalogue, number: &Estimate) -> String {
    if let Some(value) = number.value {
        return catalogue.measured(value, number.stderr.unwrap_or(f64::NAN), number.unit);
    }
    catalogue.interval(number.interval95, f64::NAN, f64::NAN, number.unit)
}

/// “2.3 % more (35 standard deviations)”.
fn difference(catalogue: &Catalogue, agreement: Agreement) -> String {
    let Agreement { ratio, deviation } = agreement;
    let variables = [
        ("percent", catalogue.number(100.0 * (ratio - 1.0).abs(), 2).into()),
        ("deviation", catalogue.number(deviation.abs(), 2).into()),
    ];
    let id = if ratio < 1.0 { "physical-less" } else { "physical-more" };
    catalogue.format(id, &variables)
}
