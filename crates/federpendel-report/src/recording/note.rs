//! How a recording was read, and which part of it is fitted.

use federpendel_fit::read::{Note, ReadError, Rows};
use federpendel_fit::{Edge, StopReason};
use federpendel_text::{Catalogue, Value, excerpt};

use super::refused_file::{line, of_file, quantity};

/// Digits of a step between times.
const DIGITS: usize = 3;

/// One sentence that says what was assumed, left out or put in order in a recording.
pub fn read_note(catalogue: &Catalogue, note: &Note) -> String {
    let of_rows = |id: &str, rows: &Rows, more: &[(&'static str, Value<'static>)]| {
        let variables = [("count", rows.count.into()), ("line", rows.first_line.into())];
        catalogue.format(id, &[&variables, more].concat())
    };
    let step = |step: f64| Value::from(catalogue.quantity(step, "s", DIGITS));
    match note {
        Note::TimeGuessed => catalogue.text("recording-note-time"),
        Note::TimeUnitAssumed => catalogue.text("recording-note-time-unit"),
        Note::TimeIgnored { column } => {
            catalogue.format("recording-note-time-ignored", &[("column", excerpt(column).into())])
        }
        Note::QuantityAssumed => catalogue.text("recording-note-quantity"),
        Note::NameContradictsUnit { name } => {
            let (quantity, _) = quantity(catalogue, *name);
            catalogue.format("recording-note-name", &[("quantity", quantity.into())])
        }
        Note::CutOff { line } => {
            catalogue.format("recording-note-cut-off", &[("line", (*line).into())])
        }
        Note::Missing(rows) => of_rows("recording-note-missing", rows, &[]),
        Note::Sorted(rows) => of_rows("recording-note-sorted", rows, &[]),
        Note::Averaged(rows) => of_rows("recording-note-averaged", rows, &[]),
        Note::Gaps { rows, longest, usual } => {
            let steps = [("longest", step(*longest)), ("usual", step(*usual))];
            of_rows("recording-note-gaps", rows, &steps)
        }
        Note::RunLeftOut { run, why } => left_out(catalogue, run, why),
        other => format!("{other:?}"),
    }
}

fn left_out(catalogue: &Catalogue, run: &str, why: &ReadError) -> String {
    let sentence = of_file(catalogue, why);
    let reason = match line(why) {
        Some(line) => {
            let place = catalogue.format("recording-line", &[("line", line.into())]);
            format!("{place}: {sentence}")
        }
        None => sentence,
    };
    let reason = ("reason", Value::from(reason));
    if run.is_empty() {
        catalogue.format("recording-note-nameless-run", &[reason])
    } else {
        catalogue.format("recording-note-run", &[("run", excerpt(run).into()), reason])
    }
}

/// Why the fitted part begins or ends where it does, without a full stop.
pub fn edge(catalogue: &Catalogue, edge: Edge) -> String {
    catalogue.text(match edge {
        Edge::Recording => "fit-edge-recording",
        Edge::Given => "fit-edge-given",
        Edge::Held => "fit-edge-held",
        Edge::Driven => "fit-edge-driven",
        Edge::Misfit => "fit-edge-misfit",
        Edge::Still => "fit-edge-still",
        Edge::Disturbed => "fit-edge-disturbed",
        Edge::Unrest => "fit-edge-unrest",
        Edge::Stopped => "fit-edge-stopped",
        Edge::Clipped => "fit-edge-clipped",
    })
}

/// Why a search ended, without a full stop.
pub fn stop_reason(catalogue: &Catalogue, reason: StopReason) -> String {
    catalogue.text(match reason {
        StopReason::Converged => "fit-stop-converged",
        StopReason::NoProgress => "fit-stop-no-progress",
        StopReason::StepLimit => "fit-stop-step-limit",
    })
}
