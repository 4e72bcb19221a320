//! A first screen of a fit: one picture, one verdict, the values rounded to their uncertainty.

use std::io::{self, Write};

use console::style;
use federpendel_report::recording::{
    Fitted, about_rows, parameter_rows, physical_rows, physical_sentences, residual_row, sentences,
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
    let mut rows = about_rows(fit, catalogue);
    // Of a motion that no mix describes the coefficients are not known.
    if !fit.report.adequacy.adequate {
        table(rows, catalogue).write(columns, out)?;
        writeln!(out)?;
        if !targets.details {
            return Ok(());
        }
        writeln!(out, "{}", catalogue.text("fit-heading-all-the-same"))?;
        rows = Vec::new();
    }
    rows.extend(match targets.details {
        true => details::intervals(fit, catalogue),
        false => parameter_rows(fit, catalogue),
    });
    rows.extend(physical);
    rows.extend(residual_row(fit, catalogue));
    let plus_minus = ["fit-row-plus-minus", "fit-plus-minus"].map(|id| catalogue.text(id));
    rows.extend([plus_minus.into()]);
    table(rows, catalogue).write(columns, out)?;
    let metres = fit.report.length_unit() == "m" && !fit.read.value.is_angle();
    if metres && fit.physical.is_none() && fit.report.adequacy.adequate {
        let dry = fit.report.verdict.mix.coulomb;
        let hint = catalogue.text(if dry { "physical-hint.guided" } else { "physical-hint" });
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
    let mut rows = about_rows(fit, catalogue);
    rows.extend(physical_rows(fit, catalogue));
    table(rows, catalogue).write(columns, out)?;
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

/// A table of rows that are named elsewhere.
fn table(rows: impl IntoIterator<Item = (String, String)>, catalogue: &Catalogue) -> Table<'_> {
    let mut table = Table::new(catalogue);
    rows.into_iter().for_each(|(name, value)| table.named(name, value));
    table
}
