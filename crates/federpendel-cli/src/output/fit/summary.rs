//! A first screen of a fit: one picture, one verdict, the values rounded to their uncertainty.

use std::f64::consts::PI;
use std::io::{self, Write};

use console::style;
use federpendel_fit::{Model, Parameter};
use federpendel_report::recording::{Fitted, sentences};
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
    let (columns, rows) = room(ROWS_BESIDES);
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
    let sentences = sentences(fit, catalogue);
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
    let omega = report.best().and_then(|model| known(model, "angular_frequency"));
    if let Some((value, error)) = omega {
        let frequency = catalogue.measured(value / (2.0 * PI), error / (2.0 * PI), "Hz");
        table.row("fit-row-frequency", frequency);
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

/// A value and its standard error, where both are known.
fn known(model: &Model, name: &str) -> Option<(f64, f64)> {
    let parameter = model.parameter(name)?;
    Some((parameter.value?, parameter.stderr?))
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
