//! A score for a person: a sentence, what the samples do at rest, a short table.

use std::io::{self, Write};

use federpendel_text::Catalogue;

use super::summary::{Table, room, wrap};
use super::{Format, json, to_stdout};
use crate::failure::Failure;
use crate::score::{AfterRest, Errors, Score};

/// Digits of an error.
const DIGITS: usize = 3;

/// Digits of a time.
const TIME_DIGITS: usize = 5;

/// A way that goes on is called a creep if at least this part of the range of places lies between the
/// first and the last.
const ONE_WAY: f64 = 0.5;

/// Writes a score to standard output.
pub(crate) fn write_score(
    score: &Score<'_>,
    format: Option<Format>,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    to_stdout(
        |out| match format {
            Some(Format::Json) => json::write_score(score, out),
            _ => summary(score, catalogue, out),
        },
        catalogue,
    )
}

fn summary(score: &Score<'_>, catalogue: &Catalogue, out: &mut dyn Write) -> io::Result<()> {
    let (columns, _) = room(0);
    let ending = score.rest.as_ref().map(|rest| after_rest(rest, catalogue));
    let sentences = [Some(verdict(score, catalogue)), ending];
    for line in sentences.iter().flatten().flat_map(|sentence| wrap(sentence, columns)) {
        writeln!(out, "{line}")?;
    }
    writeln!(out)?;
    table(score, catalogue).write(columns, out)
}

/// How good the samples are.
fn verdict(score: &Score<'_>, catalogue: &Catalogue) -> String {
    if score.position.largest <= score.bound {
        return catalogue.text("score-agrees");
    }
    catalogue.format(
        "score-sentence",
        &[
            ("error", over_amplitude(score, score.position.largest, catalogue).into()),
            ("time", time(score.position.time_of_largest, catalogue).into()),
        ],
    )
}

/// What the samples do where the mass rests.
fn after_rest(rest: &AfterRest, catalogue: &Catalogue) -> String {
    let when = ("time", time(rest.time, catalogue).into());
    match rest.found {
        None => catalogue.format("score-rest-unknown", &[when]),
        Some(found) if found.sticks => catalogue.format("score-rest-sticks", &[when]),
        Some(found) => {
            let span = ("range", catalogue.quantity(found.range, "m", DIGITS).into());
            let speed = ("speed", catalogue.quantity(found.creep, "m/s", DIGITS).into());
            let creeps = found.drift >= ONE_WAY * found.range;
            let id = if creeps { "score-rest-creeps" } else { "score-rest-moves" };
            catalogue.format(id, &[when, span, speed])
        }
    }
}

fn time(time: f64, catalogue: &Catalogue) -> String {
    catalogue.quantity(time, "s", TIME_DIGITS)
}

/// An error of a position; a mass that never moves has no amplitude to compare with.
fn over_amplitude(score: &Score<'_>, error: f64, catalogue: &Catalogue) -> String {
    if score.amplitude == 0.0 {
        return catalogue.quantity(error, "m", DIGITS);
    }
    let error = catalogue.number(error, DIGITS);
    catalogue.format("score-of-amplitude", &[("error", error.into())])
}

fn over_speed(score: &Score<'_>, error: f64, catalogue: &Catalogue) -> String {
    if score.amplitude == 0.0 {
        return catalogue.quantity(error * score.speed, "m/s", DIGITS);
    }
    let error = catalogue.number(error, DIGITS);
    catalogue.format("score-of-speed", &[("error", error.into())])
}

fn table<'a>(score: &Score<'_>, catalogue: &'a Catalogue) -> Table<'a> {
    let mut table = Table::new(catalogue);
    let problem = &score.problem;
    table.row("score-problem", format!("{} ({})", problem.name, problem.description));
    let (last, error) = score.last;
    let count = [("samples", score.samples.into()), ("time", time(last, catalogue).into())];
    table.row("score-samples", catalogue.format("score-samples-value", &count));
    let row = |errors: &Errors, largest: String| {
        let variables = [
            ("error", largest.into()),
            ("time", time(errors.time_of_largest, catalogue).into()),
            ("mean", catalogue.number(errors.root_mean_square, DIGITS).into()),
        ];
        catalogue.format("score-errors-value", &variables)
    };
    let largest = over_amplitude(score, score.position.largest, catalogue);
    table.row("score-position", row(&score.position, largest));
    if let Some(velocity) = &score.velocity {
        table.row("score-velocity", row(velocity, over_speed(score, velocity.largest, catalogue)));
    }
    table.row("score-last", over_amplitude(score, error, catalogue));
    if let Some(stored) = &score.stored {
        let error = over_amplitude(score, stored.position, catalogue);
        let variables = [("error", error.into()), ("samples", stored.samples.into())];
        table.row("score-stored", catalogue.format("score-stored-value", &variables));
    }
    table.row("score-bound", over_amplitude(score, score.bound, catalogue));
    table
}
