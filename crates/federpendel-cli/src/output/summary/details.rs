//! What `--details` adds: everything given, derived, passed and spent.

use std::io::{self, Write};

use console::style;
use federpendel::parameter::{self, ParameterInfo};
use federpendel::{NormalForce, Outcome};

use super::super::Style;
use super::table::Table;
use crate::record::Record;

/// Digits of a quantity in the details.
const DIGITS: usize = 9;

/// Turning points listed; JSON has them all.
const POINTS: usize = 30;

/// Width of a column of numbers.
const WIDTH: usize = 16;

pub(super) fn write(record: &Record, style: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
    let sections = [
        ("summary-given", given(record, style)),
        ("summary-derived", derived(record, style)),
        ("summary-spent", spent(record, style)?),
        ("summary-certainty", certainty(record, style)?),
    ];
    for (id, table) in sections {
        heading(id, style, out)?;
        table.write(out)?;
    }
    turning_points(record, style, out)
}

fn heading(id: &str, style_: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\n{}", style(style_.catalogue.text(id)).bold())
}

fn given<'a>(record: &Record, style: Style<'a>) -> Table<'a> {
    let oscillator = record.motion.oscillator();
    let friction = oscillator.friction();
    let release = record.motion.release();
    let mut table = Table::new(style.catalogue);
    let mut add = |info: &ParameterInfo, value: f64| {
        let text = style.catalogue.parameter(info);
        let value = style.catalogue.quantity(value, info.unit, DIGITS);
        table.named(format!("{} {}", text.name, text.symbol), value);
    };
    add(&parameter::MASS, oscillator.mass());
    add(&parameter::STIFFNESS, oscillator.stiffness());
    if let Some(law) = friction.stokes {
        add(&parameter::DAMPING, law.damping());
    }
    if let Some(law) = friction.coulomb {
        match record.experiment.normal_force {
            NormalForce::Weight(gravity) => add(&parameter::GRAVITY, gravity),
            NormalForce::Given(force) => add(&parameter::NORMAL_FORCE, force),
        }
        add(&parameter::KINETIC, law.kinetic());
        add(&parameter::STATIC, law.static_coefficient());
    }
    if let Some(law) = friction.newton {
        add(&parameter::NEWTON_COEFFICIENT, law.coefficient());
    }
    add(&parameter::POSITION, release.position);
    add(&parameter::VELOCITY, release.velocity);
    table
}

fn derived<'a>(record: &Record, style: Style<'a>) -> Table<'a> {
    let oscillator = record.motion.oscillator();
    let mix = oscillator.friction().mix();
    let mut table = Table::new(style.catalogue);
    let mut add = |id: &str, symbol: &str, value: f64, unit: &str| {
        let name = format!("{} {symbol}", style.catalogue.text(id));
        table.named(name.trim_end().to_owned(), style.catalogue.quantity(value, unit, DIGITS));
    };
    add("derived-angular-frequency", "ω0", oscillator.angular_frequency(), "1/s");
    if let Some(period) = oscillator.period() {
        add("summary-period", "T", period, "s");
    }
    if mix.stokes {
        add("derived-damping-rate", "γ", oscillator.damping_rate(), "1/s");
        add("derived-damping-ratio", "ζ", oscillator.damping_ratio(), "1");
    }
    if let Some(factor) = oscillator.quality_factor() {
        add("derived-quality-factor", "Q", factor, "1");
    }
    if let Some(decrement) = oscillator.logarithmic_decrement().filter(|_| mix.stokes) {
        add("derived-logarithmic-decrement", "Λ", decrement, "1");
    }
    if mix.coulomb {
        add("derived-offset", "f", oscillator.offset(), "m");
        add("derived-sticking-offset", "f_s", oscillator.sticking_offset(), "m");
    }
    if mix.newton {
        add("derived-newton-rate", "κ", oscillator.newton_rate(), "1/m");
    }
    table
}

fn spent<'a>(record: &Record, style: Style<'a>) -> io::Result<Table<'a>> {
    let ledger = record.ledger_at_end().map_err(io::Error::other)?;
    let mix = record.motion.oscillator().friction().mix();
    let mut table = Table::new(style.catalogue);
    let mut add =
        |id: &str, value: f64| table.row(id, style.catalogue.quantity(value, "J", DIGITS));
    add("summary-energy-initial", record.motion.initial_energy());
    add("summary-energy-kinetic", ledger.kinetic);
    add("summary-energy-potential", ledger.potential);
    let heats = [
        (mix.stokes, "summary-heat-stokes", ledger.heat.stokes),
        (mix.coulomb, "summary-heat-coulomb", ledger.heat.coulomb),
        (mix.newton, "summary-heat-newton", ledger.heat.newton),
    ];
    for (_, id, heat) in heats.into_iter().filter(|(acts, _, _)| *acts) {
        add(id, heat);
    }
    Ok(table)
}

/// How well all this is known.
fn certainty<'a>(record: &Record, style: Style<'a>) -> io::Result<Table<'a>> {
    let bound = record.motion.error_bound(record.duration).map_err(io::Error::other)?;
    let mut table = Table::new(style.catalogue);
    table.row("summary-kind", style.catalogue.kind(record.motion.kind()));
    table.row("summary-error-bound", style.catalogue.quantity(bound, "m", 2));
    if let Outcome::Rests(rest) = record.outcome {
        let percent = style.catalogue.number(100.0 * rest.margin, 4);
        let margin = style.catalogue.format("summary-margin-value", &[("margin", percent.into())]);
        table.row("summary-margin", margin);
    }
    Ok(table)
}

fn turning_points(record: &Record, style: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
    let catalogue = style.catalogue;
    let points: Vec<_> = record.turning_points().take(POINTS + 1).collect();
    heading("summary-turning-points", style, out)?;
    if points.is_empty() {
        return writeln!(out, "  {}", catalogue.text("summary-none"));
    }
    let row = |index: &str, time: &str, position: &str| {
        format!("  {index:>4}  {time:>WIDTH$}  {position:>WIDTH$}")
    };
    let names = [catalogue.text("summary-point-time"), catalogue.text("summary-point-position")];
    writeln!(out, "{}", console::style(row("", &names[0], &names[1])).dim())?;
    for (index, point) in points.iter().take(POINTS).enumerate() {
        let time = catalogue.number(point.time, DIGITS);
        let position = catalogue.number(point.position, DIGITS);
        writeln!(out, "{}", row(&(index + 1).to_string(), &time, &position))?;
    }
    if points.len() > POINTS {
        writeln!(out, "  {}", catalogue.text("summary-more-points"))?;
    }
    Ok(())
}
