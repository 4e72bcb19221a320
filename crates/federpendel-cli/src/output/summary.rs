//! A first screen for a person: one plot, one sentence, a short table; details on request.

mod columns;
mod details;
mod noise;
mod table;
mod wrap;

use std::io::{self, Write};

use federpendel::parameter::{self, ParameterInfo};
use federpendel::{Mix, Outcome, Regime, Rest, State};
use federpendel_text::plot::Plot;

use super::Style;
use super::plot::write_terminal;
use crate::record::{Record, Source};
use crate::words::remark;
pub(super) use columns::write_columns;
pub(super) use noise::Noise;
pub(super) use table::Table;
pub(super) use wrap::wrap;

/// Digits of a quantity in a table.
const DIGITS: usize = 4;

/// Rows of sentence, table and the next prompt.
const ROWS_BELOW: usize = 12;

/// Columns and rows of the plot where no terminal says how large it is.
const PAPER: (usize, usize) = (80, 20);

pub(super) fn write(
    record: &Record,
    plot: &Plot,
    style: Style<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let catalogue = style.catalogue;
    let (columns, rows) = room(ROWS_BELOW);
    write_terminal(plot, (columns, rows), out)?;
    let outcome = catalogue.outcome(&Noise::of(record)?.outcome(record.outcome));
    let sentence = catalogue.format("summary-sentence", &[("outcome", outcome.into())]);
    let tied = match &record.outcome {
        Outcome::Rests(rest) if rest.tie => Some(rest),
        _ => None,
    };
    let sentences = [
        Some(sentence),
        tied.map(|rest| catalogue.text(tie(rest))),
        deviation(record, style)?,
        remark(catalogue, record),
    ];
    for line in sentences.iter().flatten().flat_map(|sentence| wrap(sentence, columns)) {
        writeln!(out, "{line}")?;
    }
    writeln!(out)?;
    short_table(record, style)?.write(columns, out)?;
    if style.details {
        details::write(record, style, columns, out)?;
    }
    Ok(())
}

/// How far the method asked for is from the exact motion.
fn deviation(record: &Record, style: Style<'_>) -> io::Result<Option<String>> {
    let catalogue = style.catalogue;
    let Some((time, distance)) = record.largest_deviation() else { return Ok(None) };
    let method = ("method", record.method.name().into());
    if Noise::of(record)?.agrees(distance) {
        return Ok(Some(catalogue.format("summary-agrees", &[method])));
    }
    Ok(Some(catalogue.format(
        "summary-deviation",
        &[
            method,
            ("distance", catalogue.quantity(distance, "m", DIGITS).into()),
            ("time", catalogue.quantity(time, "s", DIGITS).into()),
        ],
    )))
}

/// Which sentence tells of a tie: a mass that never moves has no last swing.
fn tie(rest: &Rest) -> &'static str {
    if rest.time == 0.0 { "summary-tie-at-release" } else { "summary-tie" }
}

/// Columns and rows for the plot, such that the first screen holds what follows it too.
pub(super) fn room(rows_below: usize) -> (usize, usize) {
    let Some((rows, columns)) = console::Term::stdout().size_checked() else {
        return PAPER;
    };
    let rows = usize::from(rows).saturating_sub(rows_below).clamp(12, 30);
    (usize::from(columns).clamp(40, 120), rows)
}

/// What most people want to know besides the sentence.
fn short_table<'a>(record: &Record, style: Style<'a>) -> io::Result<Table<'a>> {
    let catalogue = style.catalogue;
    let oscillator = record.motion.oscillator();
    let mut table = Table::new(catalogue);
    table.row("summary-given-row", given(record, style));
    let mix = oscillator.friction().mix();
    let acts =
        if mix == Mix::default() { catalogue.text("summary-none") } else { catalogue.mix(mix) };
    table.row("summary-friction", acts);
    match oscillator.period() {
        Some(period) => {
            // Newton friction stretches large swings.
            let id = if mix.newton { "summary-period-small-value" } else { "summary-period-value" };
            let value = catalogue.format(
                id,
                &[
                    ("period", catalogue.quantity(period, "s", DIGITS).into()),
                    ("frequency", catalogue.quantity(period.recip(), "Hz", DIGITS).into()),
                ],
            );
            table.row("summary-period", value);
        }
        None => table.row("summary-period", catalogue.text("summary-none")),
    }
    if oscillator.regime() != Regime::Undamped {
        let value = catalogue.format(
            "summary-damping-value",
            &[
                ("ratio", catalogue.damping_ratio(oscillator, DIGITS).into()),
                ("regime", catalogue.regime(oscillator.regime()).into()),
            ],
        );
        table.row("summary-damping", value);
    }
    energies(record, style, &mut table)?;
    let value = catalogue.format(
        "summary-record-value",
        &[
            ("samples", record.samples().len().to_string().into()),
            ("duration", catalogue.quantity(record.duration, "s", DIGITS).into()),
        ],
    );
    table.row("summary-record", value);
    if let Some(other) = &record.other {
        table.row("summary-method", method(record, other.source, style));
        return Ok(table);
    }
    table.row("summary-kind", catalogue.kind(record.motion.kind()));
    Ok(table)
}

/// What a forgotten unit would show in: “m = 500 g, C = 20 N/m, x0 = 10 cm”.
fn given(record: &Record, style: Style<'_>) -> String {
    let oscillator = record.motion.oscillator();
    let State { position, velocity } = record.motion.release();
    let values = [
        (&parameter::MASS, oscillator.mass()),
        (&parameter::STIFFNESS, oscillator.stiffness()),
        (&parameter::POSITION, position),
        (&parameter::VELOCITY, velocity),
    ];
    let still = |info: &ParameterInfo| info.name == parameter::VELOCITY.name && velocity == 0.0;
    let written = values.into_iter().filter(|(info, _)| !still(info)).map(|(info, value)| {
        let value = style.catalogue.quantity(value, info.unit, DIGITS);
        format!("{} = {value}", info.symbol)
    });
    written.collect::<Vec<_>>().join(", ")
}

/// The energy that is left: of the motion, and where another method is asked for its own beside it.
fn energies(record: &Record, style: Style<'_>, table: &mut Table<'_>) -> io::Result<()> {
    let catalogue = style.catalogue;
    let joule = |energy: f64| catalogue.quantity(energy, "J", DIGITS).into();
    let ledger = record.ledger_at_end().map_err(io::Error::other)?;
    let initial = ("initial", joule(record.motion.initial_energy()));
    let noise = Noise::of(record)?;
    let left = noise.kinetic(ledger.kinetic) + noise.potential(ledger.potential);
    let left = ("left", joule(left));
    let value = match record.other_energy() {
        None => catalogue.format("summary-energy-value", &[initial, left]),
        Some((kinetic, potential)) => catalogue.format(
            "summary-energy-values",
            &[
                initial,
                left,
                ("motion", catalogue.motion(record.motion.kind()).into()),
                ("other", joule(kinetic + potential)),
                ("method", record.method.name().into()),
            ],
        ),
    };
    table.row("summary-energy", value);
    Ok(())
}

/// The method asked for and how it made its samples.
fn method(record: &Record, source: Source, style: Style<'_>) -> String {
    let catalogue = style.catalogue;
    let name = record.method.name();
    match source {
        // The two that the article gives without a number.
        Source::Equation("overdamped") => {
            catalogue.format("summary-method-overdamped", &[("method", name.into())])
        }
        Source::Equation("critical") => {
            catalogue.format("summary-method-critical", &[("method", name.into())])
        }
        Source::Equation(number) => catalogue.format(
            "summary-method-equation",
            &[("method", name.into()), ("equation", number.into())],
        ),
        Source::Steps { time_step, interpolated } => {
            let id =
                if interpolated { "summary-method-interpolated" } else { "summary-method-steps" };
            let time_step = catalogue.quantity(time_step, "s", DIGITS);
            catalogue.format(id, &[("method", name.into()), ("step", time_step.into())])
        }
    }
}
