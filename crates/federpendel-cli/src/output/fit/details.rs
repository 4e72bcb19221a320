//! What `--details` adds to the first screen of a fit, in the words that users of fitting programs know.

use std::io::{self, Write};

use federpendel_fit::{Model, Parameter};
use federpendel_report::recording::{Fitted, damping_rows, edge, stop_reason};
use federpendel_text::Catalogue;

use super::super::summary::Table;
use super::summary::{parameter_name, value};

/// Correlations below this are not worth a line.
const CORRELATED: f64 = 0.1;

/// A value with its error and its 95 % interval.
pub(super) fn with_interval(fit: &Fitted, parameter: &Parameter, catalogue: &Catalogue) -> String {
    let shown = value(fit, parameter, catalogue);
    if parameter.value.is_none() {
        return shown;
    }
    let (low, high) = interval(parameter, &fit.report.unit_of(parameter.name), catalogue);
    let variables = [("value", shown.into()), ("low", low.into()), ("high", high.into())];
    catalogue.format("fit-interval", &variables)
}

/// The ends of the 95 % interval.
pub(super) fn interval(
    parameter: &Parameter,
    unit: &str,
    catalogue: &Catalogue,
) -> (String, String) {
    let end = |value: Option<f64>, open: &str| {
        value.map_or_else(|| open.to_owned(), |value| catalogue.quantity(value, unit, 4))
    };
    (end(parameter.interval95.0, "−∞"), end(parameter.interval95.1, "∞"))
}

/// Why the fitted part is what it is, the statistics, the correlations, the ranking of mixes.
pub(super) fn write(
    fit: &Fitted,
    columns: usize,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let Some(model) = fit.report.best() else { return Ok(()) };
    statistics(fit, model, catalogue).write(columns, out)?;
    let pairs = correlated(model);
    if !pairs.is_empty() {
        let floor = [("floor", catalogue.number(CORRELATED, 2).into())];
        writeln!(out, "\n{}", catalogue.format("fit-heading-correlations", &floor))?;
        let mut table = Table::new(catalogue);
        for (one, other, r) in pairs {
            let name = [one, other].map(|one| catalogue.text(parameter_name(one)));
            table.named(name.join(", "), catalogue.number(r, 3));
        }
        table.write(columns, out)?;
    }
    writeln!(out, "\n{}", catalogue.text("fit-heading-models"))?;
    ranking(fit, catalogue).write(columns, out)?;
    writeln!(out)
}

fn statistics<'a>(fit: &Fitted, model: &Model, catalogue: &'a Catalogue) -> Table<'a> {
    let report = &fit.report;
    let mut table = Table::new(catalogue);
    table.row("fit-row-begins", edge(catalogue, report.window.begins));
    table.row("fit-row-ends", edge(catalogue, report.window.ends));
    let laws = ["fit-law-stokes.inside", "fit-law-coulomb.inside", "fit-law-newton.inside"];
    for (law, p) in laws.into_iter().zip(report.verdict.p_values) {
        let Some(p) = p else { continue };
        let law = [("law", catalogue.text(law).into())];
        table.named(catalogue.format("fit-row-p-value", &law), catalogue.number(p, 2));
    }
    damping_rows(fit, catalogue).into_iter().for_each(|(name, value)| table.named(name, value));
    table.row("fit-row-effective", catalogue.number(report.effective_samples, 4));
    table.row("fit-row-chi", catalogue.number(model.chi_square, 5));
    table.row("fit-row-reduced", catalogue.number(model.reduced, 5));
    table.row("fit-row-aic", catalogue.number(model.criteria.aic, 6));
    table.row("fit-row-aicc", catalogue.number(model.criteria.aicc, 6));
    table.row("fit-row-bic", catalogue.number(model.criteria.bic, 6));
    table.row("fit-row-evaluations", report.evaluations.to_string());
    table.row("fit-row-stop", stop_reason(catalogue, model.stop_reason));
    table
}

/// The pairs of parameters that are known together, the closest first.
fn correlated(model: &Model) -> Vec<(&Parameter, &Parameter, f64)> {
    let all = model.parameters.iter().zip(&model.correlations).enumerate();
    let mut pairs: Vec<_> = all
        .flat_map(|(i, (one, row))| {
            let others = model.parameters.iter().zip(row).take(i);
            others.map(move |(other, &r)| (other, one, r))
        })
        .filter(|(_, _, r)| r.abs() >= CORRELATED)
        .collect();
    pairs.sort_by(|(_, _, one), (_, _, other)| other.abs().total_cmp(&one.abs()));
    pairs
}

fn ranking<'a>(fit: &Fitted, catalogue: &'a Catalogue) -> Table<'a> {
    let mut table = Table::new(catalogue);
    for model in &fit.report.models {
        let variables = [
            ("aicc", catalogue.number(model.criteria.aicc, 6).into()),
            ("bic", catalogue.number(model.criteria.bic, 6).into()),
            ("rms", catalogue.quantity(model.rms, &fit.report.unit, 4).into()),
        ];
        table.named(catalogue.mix(model.mix), catalogue.format("fit-model-row", &variables));
    }
    table
}
