//! A first screen for a person: one plot, one sentence, a short table; details on request.

mod details;
mod table;

use std::io::{self, Write};

use federpendel::{Outcome, Regime};

use super::Style;
use crate::record::{Method, Record};
use table::Table;

/// Digits of a quantity in a table.
const DIGITS: usize = 4;

pub(super) fn write(record: &Record, style: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
    let catalogue = style.catalogue;
    let outcome = catalogue.outcome(&record.outcome);
    writeln!(out, "{}", catalogue.format("summary-sentence", &[("outcome", outcome.into())]))?;
    if matches!(record.outcome, Outcome::Rests(rest) if rest.tie) {
        writeln!(out, "{}", catalogue.text("summary-tie"))?;
    }
    writeln!(out)?;
    short_table(record, style)?.write(out)?;
    if style.details {
        details::write(record, style, out)?;
    }
    Ok(())
}

/// What most people want to know besides the sentence.
fn short_table<'a>(record: &Record, style: Style<'a>) -> io::Result<Table<'a>> {
    let catalogue = style.catalogue;
    let oscillator = record.motion.oscillator();
    let mut table = Table::new(catalogue);
    table.row("summary-friction", catalogue.mix(oscillator.friction().mix()));
    match oscillator.period() {
        Some(period) => {
            let value = catalogue.format(
                "summary-period-value",
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
                ("ratio", catalogue.number(oscillator.damping_ratio(), DIGITS).into()),
                ("regime", catalogue.regime(oscillator.regime()).into()),
            ],
        );
        table.row("summary-damping", value);
    }
    let ledger = record.ledger_at_end().map_err(io::Error::other)?;
    let value = catalogue.format(
        "summary-energy-value",
        &[
            ("initial", catalogue.quantity(record.motion.initial_energy(), "J", DIGITS).into()),
            ("left", catalogue.quantity(ledger.kinetic + ledger.potential, "J", DIGITS).into()),
        ],
    );
    table.row("summary-energy", value);
    let value = catalogue.format(
        "summary-record-value",
        &[
            ("samples", record.samples.len().to_string().into()),
            ("duration", catalogue.quantity(record.duration, "s", DIGITS).into()),
        ],
    );
    table.row("summary-record", value);
    if record.method != Method::Exact {
        table.row("summary-method", record.method.name().to_owned());
    }
    table.row("summary-kind", catalogue.kind(record.motion.kind()));
    Ok(table)
}
