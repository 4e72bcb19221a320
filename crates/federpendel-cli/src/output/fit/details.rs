//! What `--details` adds to the first screen of a fit, in the words that users of fitting programs know.

use std::io::{self, Write};

use federpendel_fit::{Model, Parameter};
use federpendel_report::recording::{
    Fitted, correlation, damping_rows, edge, parameter_name, parameter_value, stop_reason,
};
use federpendel_text::Catalogue;

use super::super::summary::Table;

/// Correlations below this are not worth a line.
const CORRELATED: f64 = 0.1;

/// The parameters of the verdict's mix, each with its error and its 95 % interval.
pub(super) fn intervals(fit: &Fitted, catalogue: &Catalogue) -> Vec<(String, String)> {
    let parameters = fit.report.best().map_or(&[][..], |model| &model.parameters);
    let row = |parameter: &Parameter| {
        (catalogue.text(parameter_name(parameter)), with_interval(fit, parameter, catalogue))
    };
    parameters.iter().map(row).collect()
}

fn with_interval(fit: &Fitted, parameter: &Parameter, catalogue: &Catalogue) -> String {
    let shown = parameter_value(fit, parameter, catalogue);
    let Some(middle) = parameter.value else { return shown };
    let unit = fit.report.unit_of(parameter.name);
    let error = parameter.stderr.unwrap_or(f64::NAN);
    let interval = catalogue.interval(parameter.interval95, middle, error, &unit);
    let variables = [("value", shown.into()), ("interval", interval.into())];
    catalogue.format("fit-interval", &variables)
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
            table.named(name.join(", "), correlation(catalogue, r));
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
    // Without the noise of a value χ² is in its unit, and says nothing of how good a fit is.
    if report.sigma.is_some() {
        table.row("fit-row-chi", catalogue.number(model.chi_square, 5));
        table.row("fit-row-reduced", catalogue.number(model.reduced, 5));
    }
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
