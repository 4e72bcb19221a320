//! A first screen of a comparison: one plot, one sentence, a table of the methods.

use std::io::{self, Write};

use console::style as typeset;
use federpendel::Outcome;
use federpendel_text::plot::Plot;

use super::super::Style;
use super::super::plot::write_terminal;
use super::super::summary::{room, wrap, write_columns};
use crate::comparison::{Candidate, Compared, Comparison, Measured};

/// Digits of a number in the table.
const DIGITS: usize = 3;

/// Rows besides the plot and one for each method.
const ROWS_BESIDES: usize = 8;

/// Fewest rows of the plot.
const FEWEST_ROWS: usize = 14;

pub(super) fn write(
    comparison: &Comparison,
    plot: &Plot,
    style: Style<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let (columns, rows) = room(ROWS_BESIDES + comparison.methods.len());
    let size = (columns, rows.max(FEWEST_ROWS));
    write_terminal(plot, size, out)?;
    let sentences = [Some(exact_ending(comparison, style)), range(comparison, style)];
    for line in sentences.iter().flatten().flat_map(|sentence| wrap(sentence, columns)) {
        writeln!(out, "{line}")?;
    }
    writeln!(out)?;
    let head = head(style);
    let rows: Vec<_> = comparison.methods.iter().map(|compared| row(compared, style)).collect();
    write_columns(&head, &rows, &[1, 4, 5], columns, out)?;
    writeln!(out, "  {}", typeset(style.catalogue.text("compare-order-note")).dim())?;
    failures(comparison, style, columns, out)?;
    if style.details {
        details(comparison, style, out)?;
    }
    Ok(())
}

/// How the exact motion ends.
fn exact_ending(comparison: &Comparison, style: Style<'_>) -> String {
    let outcome = style.catalogue.outcome(&comparison.record.outcome);
    style.catalogue.format("summary-sentence", &[("outcome", outcome.into())])
}

/// Which method is nearest to the exact motion, and which is farthest from it.
fn range(comparison: &Comparison, style: Style<'_>) -> Option<String> {
    let catalogue = style.catalogue;
    let error = |found: &(Candidate, &Measured)| found.1.errors.largest;
    let by_error =
        |a: &(Candidate, &Measured), b: &(Candidate, &Measured)| error(a).total_cmp(&error(b));
    let nearest = comparison.measured().min_by(by_error)?;
    let farthest = comparison.measured().max_by(by_error)?;
    let length = |found: &(Candidate, &Measured)| catalogue.quantity(error(found), "m", DIGITS);
    if nearest.0.name() == farthest.0.name() {
        return Some(catalogue.format(
            "compare-one",
            &[("method", nearest.0.name().into()), ("error", length(&nearest).into())],
        ));
    }
    Some(catalogue.format(
        "compare-range",
        &[
            ("nearest", nearest.0.name().into()),
            ("least", length(&nearest).into()),
            ("farthest", farthest.0.name().into()),
            ("most", length(&farthest).into()),
        ],
    ))
}

/// The table: the method, its largest error, its order, what it does at rest, steps, run time.
fn head(style: Style<'_>) -> [String; 6] {
    let ids = [
        "compare-head-method",
        "compare-head-error",
        "compare-head-order",
        "compare-head-rest",
        "compare-head-steps",
        "compare-head-time",
    ];
    ids.map(|id| style.catalogue.text(id))
}

fn row(compared: &Compared, style: Style<'_>) -> [String; 6] {
    let catalogue = style.catalogue;
    let name = compared.candidate.name().to_owned();
    let Ok(measured) = &compared.found else {
        let none = || "–".to_owned();
        return [name, catalogue.text("compare-failed"), none(), none(), none(), none()];
    };
    let order = catalogue.orders(compared.candidate.order(), measured.ladder.order());
    let steps = match measured.errors.steps {
        0 => "–".to_owned(),
        steps => steps.to_string(),
    };
    let time = catalogue.quantity(measured.run_time.as_secs_f64(), "s", 2);
    let error = catalogue.quantity(measured.errors.largest, "m", DIGITS);
    [name, error, order, catalogue.at_rest(measured.sticks, measured.creep), steps, time]
}

/// Why methods failed, and why some have no order; methods with one reason in one sentence.
fn failures(
    comparison: &Comparison,
    style: Style<'_>,
    columns: usize,
    out: &mut dyn Write,
) -> io::Result<()> {
    let mut reasons: Vec<(&str, String, Vec<&str>)> = Vec::new();
    for compared in &comparison.methods {
        let Some((id, reason)) = reason(compared, style) else { continue };
        let name = compared.candidate.name();
        match reasons.iter_mut().find(|known| (known.0, &known.1) == (id, &reason)) {
            Some((_, _, names)) => names.push(name),
            None => reasons.push((id, reason, vec![name])),
        }
    }
    for (id, reason, names) in reasons {
        let variables = [("method", names.join(", ").into()), ("reason", reason.into())];
        for line in wrap(&style.catalogue.format(id, &variables), columns) {
            writeln!(out, "{line}")?;
        }
    }
    Ok(())
}

/// The sentence and the reason of a failure, if there is one.
fn reason(compared: &Compared, style: Style<'_>) -> Option<(&'static str, String)> {
    let catalogue = style.catalogue;
    match &compared.found {
        Err(error) => Some(("compare-failure", catalogue.error(error))),
        Ok(measured) => {
            let failed = measured.ladder.failed.as_ref()?;
            let setting = match (failed.time_step, failed.tolerance) {
                (Some(step), _) => format!("Δt = {}", catalogue.quantity(step, "s", DIGITS)),
                (None, Some(tolerance)) => format!("ε = {}", catalogue.number(tolerance, 2)),
                (None, None) => String::new(),
            };
            let reason = catalogue.error(&failed.error);
            let variables = [("setting", setting.into()), ("reason", reason.into())];
            Some(("compare-no-order", catalogue.format("compare-failed-rung", &variables)))
        }
    }
}

/// What the table has no room for.
fn details(comparison: &Comparison, style: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
    let catalogue = style.catalogue;
    for (candidate, measured) in comparison.measured() {
        writeln!(out, "\n{}", typeset(candidate.name()).bold())?;
        let errors = &measured.errors;
        let length = |value: f64| catalogue.quantity(value, "m", 6);
        let energy = errors.energy.map_or("–".into(), |error| catalogue.number(error, 3));
        let rows = [
            ("compare-detail-largest", length(errors.largest)),
            ("compare-detail-when", catalogue.quantity(errors.time_of_largest, "s", 6)),
            ("compare-detail-mean", length(errors.root_mean_square)),
            ("compare-detail-energy", energy),
            ("compare-detail-final", length(errors.final_position)),
        ];
        for (id, value) in rows {
            writeln!(out, "  {}  {value}", typeset(catalogue.text(id)).dim())?;
        }
        if !measured.ladder.rungs.is_empty() {
            writeln!(out, "  {}", typeset(catalogue.text("compare-detail-rungs")).dim())?;
        }
        for rung in &measured.ladder.rungs {
            let step = match rung.tolerance {
                Some(tolerance) => format!("ε  {:>12}", catalogue.number(tolerance, 2)),
                None => format!("Δt {:>12}", catalogue.quantity(rung.time_step, "s", 4)),
            };
            writeln!(out, "    {step}  {:>14}  {:>10}", length(rung.error), rung.steps)?;
        }
    }
    if matches!(comparison.record.outcome, Outcome::Rests(_)) {
        writeln!(out, "\n  {}", catalogue.text("compare-detail-creep"))?;
    }
    Ok(())
}
