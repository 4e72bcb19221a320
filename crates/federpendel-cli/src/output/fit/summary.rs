//! A first screen of a fit: one picture, one verdict, the values rounded to their uncertainty.

use std::io::{self, Write};

use console::style;
use federpendel_fit::{Parameter, damping};
use federpendel_report::recording::{
    Fitted, parameter_name, physical_rows, physical_sentences, sentences,
};
use federpendel_text::Catalogue;

use super::super::plot::write_terminal;
use super::super::summary::{Table, room, wrap};
use super::super::targets::Targets;
use super::{Picture, details};

/// Rows besides the picture.
const ROWS_BESIDES: usize = 16;

/// So many recordings are written in full.
const MOST_IN_FULL: usize = 4;

/// Fewest rows of the picture.
const FEWEST_ROWS: usize = 14;

/// Writes all about one fit.
pub(super) fn write(
    fit: &Fitted,
    picture: Picture,
    targets: &Targets,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let physical = physical_rows(fit, catalogue);
    let (columns, rows) = room(ROWS_BESIDES + physical.len());
    write_terminal(&picture.on_terminal(fit, catalogue), (columns, rows.max(FEWEST_ROWS)), out)?;
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
    table.row("fit-row-plus-minus", catalogue.text("fit-plus-minus"));
    table.write(columns, out)?;
    let metres = fit.report.length_unit() == "m" && !fit.read.value.is_angle();
    if metres && fit.physical.is_none() && fit.report.adequacy.adequate {
        let hint = catalogue.text("physical-hint");
        wrap(&hint, columns).iter().try_for_each(|line| writeln!(out, "{line}"))?;
    }
    writeln!(out)?;
    if targets.details {
        details::write(fit, columns, catalogue, out)?;
    }
    Ok(())
}

/// Writes many fits, each below its name: a few in full, of more what tells them apart.
pub(super) fn write_many(
    fits: &[Fitted],
    picture: Picture,
    targets: &Targets,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let full = fits.len() <= MOST_IN_FULL || targets.details;
    fits.iter().try_for_each(|fit| {
        writeln!(out, "{}", style(&fit.name).bold())?;
        if full {
            write(fit, picture, targets, catalogue, out)
        } else {
            write_short(fit, catalogue, out)
        }
    })
}

/// The verdict, and the values that tell many fits apart.
fn write_short(fit: &Fitted, catalogue: &Catalogue, out: &mut dyn Write) -> io::Result<()> {
    let (columns, _) = room(ROWS_BESIDES);
    verdict(fit, columns, catalogue, out)?;
    let mut table = about(fit, catalogue);
    physical_rows(fit, catalogue).into_iter().for_each(|(name, value)| table.named(name, value));
    table.write(columns, out)?;
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
    let adequate = report.adequacy.adequate;
    let ratio = figures.filter(|_| adequate).and_then(|figures| figures.damping_ratio);
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

/// A value with its error, or the interval that is all that is known.
pub(super) fn value(fit: &Fitted, parameter: &Parameter, catalogue: &Catalogue) -> String {
    let unit = fit.report.unit_of(parameter.name);
    let error = parameter.stderr.unwrap_or(f64::NAN);
    match parameter.value {
        Some(value) => catalogue.measured(value, error, &unit),
        None => catalogue.interval(parameter.interval95, f64::NAN, error, &unit),
    }
}
