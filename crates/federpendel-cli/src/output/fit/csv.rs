//! Fits as a table: a row for each.

use std::io::{self, Write};

use federpendel_fit::physical::Answer;
use federpendel_fit::{Model, Parameters};
use federpendel_report::recording::{Fitted, sentences};
use federpendel_text::Catalogue;

use super::super::csv::{Dialect, cell, records};
use super::names::{law_names, quantity_name};

/// The parameters that have columns, in their order.
fn parameters() -> impl Iterator<Item = &'static str> {
    Parameters::NAMES.into_iter().chain(["static_acceleration"])
}

/// What stands in the columns of each parameter, after its name.
const OF_PARAMETER: [&str; 4] = ["", "_stderr", "_low95", "_high95"];

/// The physical numbers, in the order of [`Physical::numbers`].
const PHYSICAL: [&str; 8] = [
    "mass",
    "moving_mass",
    "stiffness",
    "damping",
    "coulomb_force",
    "newton_coefficient",
    "kinetic",
    "static",
];

/// The columns before those of the parameters, and after them.
const BEFORE: [&str; 9] =
    ["name", "quantity", "unit", "length_unit", "laws", "adequate", "n", "from", "to"];
const AFTER: [&str; 5] = ["rest_time", "rest_position", "rms", "aicc", "verdict"];

/// A row for each fit; cells of what is not known, or not in the mix, are empty.
pub(super) fn write(
    fits: &[Fitted],
    dialect: Dialect,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let of_parameters =
        parameters().flat_map(|name| OF_PARAMETER.map(|end| format!("{name}{end}")));
    let of_numbers =
        PHYSICAL.into_iter().flat_map(|name| OF_PARAMETER.map(|end| format!("{name}{end}")));
    let header: Vec<String> = BEFORE
        .iter()
        .map(ToString::to_string)
        .chain(of_parameters)
        .chain(of_numbers)
        .chain(AFTER.iter().map(ToString::to_string))
        .collect();
    let rows = fits.iter().filter_map(|fit| {
        let model = fit.report.best()?;
        let number = |value: Option<f64>| value.map_or(String::new(), |value| cell(value, dialect));
        let mut row = before(fit, number);
        row.extend(parameters().flat_map(|name| of_parameter(model, name)).map(number));
        row.extend(physical(fit).into_iter().map(number));
        row.extend(after(model).map(number));
        row.push(sentences(fit, catalogue).join(" "));
        Some(row)
    });
    records(&header, rows, dialect, out)
}

fn before(fit: &Fitted, number: impl Fn(Option<f64>) -> String) -> Vec<String> {
    let report = &fit.report;
    vec![
        fit.name.clone(),
        quantity_name(report.quantity).to_owned(),
        report.unit.clone(),
        report.length_unit(),
        law_names(report.verdict.mix).join("+"),
        report.adequacy.adequate.to_string(),
        report.samples.to_string(),
        number(Some(report.window.from)),
        number(Some(report.window.to)),
    ]
}

fn of_parameter(model: &Model, name: &str) -> [Option<f64>; OF_PARAMETER.len()] {
    let Some(found) = model.parameter(name) else { return [None; 4] };
    [found.value, found.stderr, found.interval95.0, found.interval95.1]
}

/// The physical numbers that are known, SI.
fn physical(fit: &Fitted) -> Vec<Option<f64>> {
    let Some(physical) = &fit.physical else {
        return vec![None; PHYSICAL.len() * OF_PARAMETER.len()];
    };
    let cells = |answer: Answer| {
        answer.map_or([None; 4], |one| [one.value, one.stderr, one.interval95.0, one.interval95.1])
    };
    physical.numbers().into_iter().flat_map(|(_, answer)| cells(answer)).collect()
}

/// All columns of `AFTER` but the last, which is text.
fn after(model: &Model) -> [Option<f64>; AFTER.len() - 1] {
    let rest = model.rest.as_ref();
    [
        rest.map(|rest| rest.time),
        rest.map(|rest| rest.position),
        Some(model.rms),
        Some(model.criteria.aicc),
    ]
}
