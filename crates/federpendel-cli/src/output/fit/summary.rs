//! A first screen of a fit: one picture, one verdict, the values rounded to their uncertainty.

use std::f64::consts::PI;
use std::io::{self, Write};

use federpendel_fit::Parameter;
use federpendel_report::recording::{Fitted, edge, parameter_name, sentences};
use federpendel_text::Catalogue;

use super::super::plot::write_terminal;
use super::super::summary::{Table, room, wrap};
use super::super::targets::Targets;
use super::Picture;

/// Rows besides the picture.
const ROWS_BESIDES: usize = 16;

/// Fewest rows of the picture.
const FEWEST_ROWS: usize = 14;

pub(super) fn write(
    fit: &Fitted,
    picture: Picture,
    targets: &Targets,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let (columns, rows) = room(ROWS_BESIDES);
    write_terminal(&picture.on_terminal(fit, catalogue), (columns, rows.max(FEWEST_ROWS)), out)?;
    for line in sentences(fit, catalogue).iter().flat_map(|sentence| wrap(sentence, columns)) {
        writeln!(out, "{line}")?;
    }
    writeln!(out)?;
    table(fit, catalogue).write(columns, out)?;
    writeln!(out)?;
    if targets.details {
        details(fit, columns, catalogue, out)?;
    }
    Ok(())
}

fn table<'a>(fit: &Fitted, catalogue: &'a Catalogue) -> Table<'a> {
    let mut table = Table::new(catalogue);
    let report = &fit.report;
    table.row("fit-row-column", fit.read.value.label.clone());
    let window = [
        ("from", catalogue.quantity(report.window.from, "s", 5).into()),
        ("to", catalogue.quantity(report.window.to, "s", 5).into()),
        ("samples", report.samples.into()),
    ];
    table.row("fit-row-window", catalogue.format("fit-window-value", &window));
    let Some(model) = report.best() else { return table };
    if let Some((value, error)) = known(model.parameter("angular_frequency")) {
        let frequency = catalogue.measured(value / (2.0 * PI), error / (2.0 * PI), "Hz");
        table.row("fit-row-frequency", frequency);
    }
    if let (Some((omega, _)), Some((gamma, error))) =
        (known(model.parameter("angular_frequency")), known(model.parameter("damping_rate")))
    {
        table.row("fit-row-damping-ratio", catalogue.measured(gamma / omega, error / omega, "1"));
    }
    for parameter in &model.parameters {
        table.row(parameter_name(parameter), value(fit, parameter, catalogue));
    }
    table.row("fit-row-residual", catalogue.quantity(model.rms, &report.unit, 3));
    table
}

/// A value and its standard error, where both are known.
fn known(parameter: Option<&Parameter>) -> Option<(f64, f64)> {
    let parameter = parameter?;
    Some((parameter.value?, parameter.stderr?))
}

/// A value with its error, or the interval that is all that is known.
fn value(fit: &Fitted, parameter: &Parameter, catalogue: &Catalogue) -> String {
    let unit = fit.report.unit_of(parameter.name);
    let (low, high) = interval(parameter, &unit, catalogue);
    match parameter.value {
        Some(value) => catalogue.measured(value, parameter.stderr.unwrap_or(f64::NAN), &unit),
        None => format!("{low} … {high}"),
    }
}

fn interval(parameter: &Parameter, unit: &str, catalogue: &Catalogue) -> (String, String) {
    let end = |value: Option<f64>, open: &str| {
        value.map_or_else(|| open.to_owned(), |value| catalogue.quantity(value, unit, 4))
    };
    (end(parameter.interval95.0, "−∞"), end(parameter.interval95.1, "∞"))
}

/// Intervals, the ranking of mixes, and why the fitted part is what it is.
fn details(
    fit: &Fitted,
    columns: usize,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let report = &fit.report;
    let mut table = Table::new(catalogue);
    table.row("fit-row-begins", edge(catalogue, report.window.begins));
    table.row("fit-row-ends", edge(catalogue, report.window.ends));
    if let Some(model) = report.best() {
        for parameter in &model.parameters {
            let (low, high) = interval(parameter, &fit.report.unit_of(parameter.name), catalogue);
            let variables = [
                ("value", value(fit, parameter, catalogue).into()),
                ("low", low.into()),
                ("high", high.into()),
            ];
            table.row(parameter_name(parameter), catalogue.format("fit-interval", &variables));
        }
        table.row("fit-row-chi", catalogue.number(model.chi_square, 5));
        table.row("fit-row-reduced", catalogue.number(model.reduced, 5));
    }
    table.row("fit-row-evaluations", report.evaluations.to_string());
    table.write(columns, out)?;
    writeln!(out, "\n{}", catalogue.text("fit-heading-models"))?;
    let mut ranking = Table::new(catalogue);
    for model in &report.models {
        let variables = [
            ("aicc", catalogue.number(model.criteria.aicc, 6).into()),
            ("bic", catalogue.number(model.criteria.bic, 6).into()),
            ("rms", catalogue.quantity(model.rms, &report.unit, 4).into()),
        ];
        ranking.named(catalogue.mix(model.mix), catalogue.format("fit-model-row", &variables));
    }
    ranking.write(columns, out)?;
    writeln!(out)
}
