//! What `--details` adds: everything given, derived, passed and spent.

use std::io::{self, Write};

use console::style;
use federpendel::parameter::{self, ParameterInfo};
use federpendel::{NormalForce, Oscillator, Outcome, Rest};
use federpendel_text::Catalogue;

use super::super::Style;
use super::noise::Noise;
use super::table::Table;
use super::wrap::wrap;
use crate::record::Record;

/// Digits of a quantity in the details.
const DIGITS: usize = 9;

/// Turning points listed; JSON has them all.
const POINTS: usize = 30;

/// Width of a column of numbers, and where there is no room for two of them.
const WIDTHS: [usize; 2] = [16, 14];

pub(super) fn write(
    record: &Record,
    style: Style<'_>,
    columns: usize,
    out: &mut dyn Write,
) -> io::Result<()> {
    let catalogue = style.catalogue;
    // Beside another method it is said what belongs to the motion.
    let motion = record.other.as_ref().map(|_| catalogue.motion(record.motion.kind()));
    let of_motion = |id: &str| of(catalogue, id, motion.as_deref());
    let mut sections = vec![
        (catalogue.text("summary-given"), given(record, style)),
        (catalogue.text("summary-derived"), derived(record, style)),
        (of_motion("summary-spent"), spent(record, style)?),
    ];
    if let Some(table) = left_to_method(record, style) {
        sections.push((of(catalogue, "summary-spent", Some(record.method.name())), table));
    }
    sections.push((of_motion("summary-certainty"), certainty(record, style)?));
    for (name, table) in sections {
        heading(&name, columns, out)?;
        table.write(columns, out)?;
    }
    heading(&of_motion("summary-turning-points"), columns, out)?;
    turning_points(record, style, columns, out)
}

/// A heading, and whose it is.
fn of(catalogue: &Catalogue, id: &str, whose: Option<&str>) -> String {
    let heading = catalogue.text(id);
    match whose {
        None => heading,
        Some(whose) => {
            let variables = [("heading", heading.into()), ("whose", whose.into())];
            catalogue.format("summary-heading-of", &variables)
        }
    }
}

fn heading(name: &str, columns: usize, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out)?;
    wrap(name, columns).iter().try_for_each(|line| writeln!(out, "{}", style(line).bold()))
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
    let mut table = Table::new(style.catalogue);
    for (name, symbol, value) in style.catalogue.derived(record.motion.oscillator(), DIGITS) {
        table.named(format!("{name} {symbol}").trim_end().to_owned(), value);
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
    let noise = Noise::of(record)?;
    add("summary-energy-kinetic", noise.kinetic(ledger.kinetic));
    add("summary-energy-potential", noise.potential(ledger.potential));
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

/// The energy at the end by the method asked for, as the JSON has it.
fn left_to_method<'a>(record: &Record, style: Style<'a>) -> Option<Table<'a>> {
    let (kinetic, potential) = record.other_energy()?;
    let mut table = Table::new(style.catalogue);
    for (id, value) in
        [("summary-energy-kinetic", kinetic), ("summary-energy-potential", potential)]
    {
        table.row(id, style.catalogue.quantity(value, "J", DIGITS));
    }
    Some(table)
}

/// How well all this is known.
fn certainty<'a>(record: &Record, style: Style<'a>) -> io::Result<Table<'a>> {
    let bound = record.motion.error_bound(record.duration).map_err(io::Error::other)?;
    let mut table = Table::new(style.catalogue);
    table.row("summary-kind", style.catalogue.kind(record.motion.kind()));
    table.row("summary-error-bound", style.catalogue.quantity(bound, "m", 2));
    let oscillator = record.motion.oscillator();
    if let Outcome::Rests(rest) = record.outcome
        && oscillator.sticking_offset() > 0.0
    {
        table.row("summary-margin", margin(&rest, oscillator, style));
    }
    Ok(table)
}

/// How far inside the sticking band the mass rests. The core measures it in offsets f, which say how
/// many swings less or more would change it.
fn margin(rest: &Rest, oscillator: &Oscillator, style: Style<'_>) -> String {
    let catalogue = style.catalogue;
    if rest.tie {
        return catalogue.text("summary-margin-tie");
    }
    let offset = oscillator.offset();
    if offset == 0.0 {
        let distance = rest.margin * oscillator.sticking_offset();
        let distance = catalogue.quantity(distance, "m", 4);
        return catalogue.format("summary-margin-distance", &[("distance", distance.into())]);
    }
    catalogue.format(
        "summary-margin-value",
        &[
            ("distance", catalogue.quantity(rest.margin * offset, "m", 4).into()),
            ("margin", catalogue.number(100.0 * rest.margin, 4).into()),
        ],
    )
}

fn turning_points(
    record: &Record,
    style: Style<'_>,
    columns: usize,
    out: &mut dyn Write,
) -> io::Result<()> {
    let catalogue = style.catalogue;
    let noise = Noise::of(record)?;
    let points: Vec<_> = record.turning_points().take(POINTS + 1).collect();
    if points.is_empty() {
        return writeln!(out, "  {}", catalogue.text("summary-none"));
    }
    let [wide, narrow] = WIDTHS;
    let width = if 10 + 2 * wide > columns { narrow } else { wide };
    let row = |index: &str, time: &str, position: &str| {
        format!("  {index:>4}  {time:>width$}  {position:>width$}")
    };
    let names = [catalogue.text("summary-point-time"), catalogue.text("summary-point-position")];
    writeln!(out, "{}", console::style(row("", &names[0], &names[1])).dim())?;
    for (index, point) in points.iter().take(POINTS).enumerate() {
        let time = catalogue.number(point.time, DIGITS);
        let position = catalogue.number(noise.length(point.position), DIGITS);
        writeln!(out, "{}", row(&(index + 1).to_string(), &time, &position))?;
    }
    if points.len() > POINTS {
        writeln!(out, "  {}", catalogue.text("summary-more-points"))?;
    }
    Ok(())
}
