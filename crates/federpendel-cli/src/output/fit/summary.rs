//! A first screen of a fit: one picture, one verdict, the values rounded to their uncertainty.

use std::io::{self, Write};

use console::style;
use federpendel_fit::{Parameter, damping};
use federpendel_report::recording::{Fitted, physical_rows, physical_sentences, sentences};
use federpendel_text::Catalogue;

use super::super::plot::write_terminal;
use super::super::summary::{Table, room, wrap};
use super::super::targets::Targets;
use super::details;

/// Rows besides the picture.
const ROWS_BESIDES: usize = 16;

/// Fewest rows of the picture.
const FEWEST_ROWS: usize = 14;

/// Writes all about one fit.
pub(super) fn write(
    fit: &Fitted,
    targets: &Targets,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let physical = physical_rows(fit, catalogue);
    let (columns, rows) = room(ROWS_BESIDES + physical.len());
    let [plot, _] = fit.plots(catalogue);
    write_terminal(&plot, (columns, rows.max(FEWEST_ROWS)), out)?;
    verdict(fit, columns, catalogue, out)?;
    writeln!(out)?;
    let mut table = about(fit, catalogue);
    // Of a motion that no mix describes the coefficients are not known.
    if !fit.report.adequacy.adequate {
        table.write(columns, out)?;
        writeln!(out)?;
        if !targets.details {
            return Ok(());
        }
        writeln!(out, "{}", catalogue.text("fit-heading-all-the-same"))?;
        table = Table::new(catalogue);
    }
    for parameter in parameters(fit) {
        let value = match targets.details {
            true => details::with_interval(fit, parameter, catalogue),
            false => value(fit, parameter, catalogue),
        };
        table.row(parameter_name(parameter), value);
    }
    physical.into_iter().for_each(|(name, value)| table.named(name, value));
    if let Some(model) = fit.report.best() {
        table.row("fit-row-residual", catalogue.quantity(model.rms, &fit.report.unit, 3));
    }
    table.write(columns, out)?;
    writeln!(out)?;
    if targets.details {
        details::write(fit, columns, catalogue, out)?;
    }
    Ok(())
}

/// Writes one fit of many: its name, the verdict, and the values that tell them apart.
pub(super) fn write_short(
    fit: &Fitted,
    targets: &Targets,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    if targets.details {
        return write(fit, targets, catalogue, out);
    }
    let (columns, _) = room(ROWS_BESIDES);
    writeln!(out, "{}", style(&fit.name).bold())?;
    verdict(fit, columns, catalogue, out)?;
    about(fit, catalogue).write(columns, out)?;
    writeln!(out)
}

fn verdict(
    fit: &Fitted,
    columns: usize,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let sentences = [sentences(fit, catalogue), physical_sentences(fit, catalogue)].concat();
    let mut lines = sentences.iter().flat_map(|sentence| wrap(sentence, columns));
    lines.try_for_each(|line| writeln!(out, "{line}"))
}

/// What was fitted, and what an engineer asks first.
fn about<'a>(fit: &Fitted, catalogue: &'a Catalogue) -> Table<'a> {
    let mut table = Table::new(catalogue);
    let report = &fit.report;
    table.row("fit-row-column", fit.read.value.label.clone());
    let window = [
        ("from", catalogue.quantity(report.window.from, "s", 5).into()),
        ("to", catalogue.quantity(report.window.to, "s", 5).into()),
        ("samples", report.samples.into()),
    ];
    table.row("fit-row-window", catalogue.format("fit-window-value", &window));
    if fit.read.recording.unit.is_empty() {
        table.row("fit-row-unit", catalogue.text("fit-unit-nameless"));
    }
    let figures = damping(report);
    let frequency = figures.as_ref().map(|figures| figures.natural_frequency);
    let ratio = figures.and_then(|figures| figures.damping_ratio);
    for (id, figure) in [("fit-row-frequency", frequency), ("fit-row-damping-ratio", ratio)] {
        if let Some((value, error)) = figure.and_then(|one| one.value.zip(one.stderr)) {
            table.row(id, catalogue.measured(value, error, figure.map_or("1", |one| one.unit)));
        }
    }
    table
}

fn parameters(fit: &Fitted) -> &[Parameter] {
    fit.report.best().map_or(&[], |model| &model.parameters)
}

/// The sentence that names a parameter.
pub(super) fn parameter_name(parameter: &Parameter) -> &'static str {
    match parameter.name {
        "angular_frequency" => "fit-parameter-angular-frequency",
        "damping_rate" => "fit-parameter-damping-rate",
        "coulomb_acceleration" => "fit-parameter-coulomb-acceleration",
        "newton_rate" => "fit-parameter-newton-rate",
        "position0" => "fit-parameter-position0",
        "velocity0" => "fit-parameter-velocity0",
        "static_acceleration" => "fit-parameter-static-acceleration",
        _ => "fit-parameter-equilibrium",
    }
}

/// A value with its error, or the interval that is all that is known.
pub(super) fn value(fit: &Fitted, parameter: &Parameter, catalogue: &Catalogue) -> String {
    let unit = fit.report.unit_of(parameter.name);
    match parameter.value {
        Some(value) => catalogue.measured(value, parameter.stderr.unwrap_or(f64::NAN), &unit),
        None => {
            let (low, high) = details::interval(parameter, &unit, catalogue);
            format!("{low} … {high}")
        }
    }
}
