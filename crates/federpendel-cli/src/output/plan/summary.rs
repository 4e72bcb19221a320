//! A first screen of a plan: one picture, what to do, a table of the laws.

use std::io::{self, Write};

use federpendel_fit::plan::{Law, Plan, Prospect};
use federpendel_report::plan::{as_given, coefficient, name, quantity, sentences};
use federpendel_text::plot::Plot;

use super::super::Style;
use super::super::fit::law_names;
use super::super::plot::write_terminal;
use super::super::summary::{Table, room, wrap, write_columns};

/// Digits of a number.
const DIGITS: usize = 3;

/// Rows besides the picture.
const ROWS_BESIDES: usize = 14;

/// Fewest rows of the picture.
const FEWEST_ROWS: usize = 16;

pub(super) fn write(
    plan: &Plan,
    picture: &Plot,
    style: Style<'_>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let catalogue = style.catalogue;
    let (columns, rows) = room(ROWS_BESIDES);
    if !plan.prospects.is_empty() {
        write_terminal(picture, (columns, rows.max(FEWEST_ROWS)), out)?;
    }
    let sentences = sentences(catalogue, plan);
    for line in sentences.iter().flat_map(|sentence| wrap(sentence, columns)) {
        writeln!(out, "{line}")?;
    }
    if !plan.prospects.is_empty() {
        writeln!(out)?;
        let ids = [
            "plan-head-law",
            "plan-head-coefficient",
            "plan-head-amplitude",
            "plan-head-duration",
            "plan-head-stderr",
        ];
        let head = ids.map(|id| catalogue.text(id));
        let rows: Vec<_> = plan.prospects.iter().map(|one| row(one, style)).collect();
        write_columns(&head, &rows, &[2, 3, 4], columns, out)?;
    }
    if style.details {
        writeln!(out)?;
        details(plan, style).write(columns, out)?;
        writeln!(out)?;
        for line in wrap(&catalogue.text("plan-assumed"), columns) {
            writeln!(out, "{line}")?;
        }
    }
    Ok(())
}

fn row(prospect: &Prospect, style: Style<'_>) -> [String; 5] {
    let catalogue = style.catalogue;
    let (law, none) = (prospect.law, || "–".to_owned());
    let [amplitude, duration, stderr] = match prospect.smallest {
        None => [none(), none(), none()],
        Some((amplitude, known)) => [
            catalogue.quantity(amplitude, "m", DIGITS),
            catalogue.quantity(known.duration, "s", DIGITS),
            catalogue.quantity(known.stderr, law.unit(), 2),
        ],
    };
    let coefficient = coefficient(catalogue, law, prospect.coefficient);
    [name(catalogue, law), coefficient, amplitude, duration, stderr]
}

/// What was asked, and all that the sentences leave out.
fn details<'a>(plan: &Plan, style: Style<'a>) -> Table<'a> {
    let (catalogue, setup) = (style.catalogue, &plan.setup);
    let length = |value: f64| catalogue.quantity(value, "m", DIGITS);
    let mut table = Table::new(catalogue);
    let unit = ["m", "m/s", "m/s^2"][setup.quantity as usize];
    let recording = [
        ("quantity", quantity(catalogue, setup.quantity).into()),
        ("noise", catalogue.quantity(setup.noise, unit, DIGITS).into()),
        ("rate", catalogue.number(setup.rate, DIGITS).into()),
    ];
    table.row("plan-row-recording", catalogue.format("plan-recording-value", &recording));
    let range =
        [("from", length(setup.smallest()).into()), ("to", length(setup.max_amplitude).into())];
    table.row("plan-row-amplitudes", catalogue.format("plan-amplitudes-value", &range));
    table.row("plan-row-fitted", catalogue.mix(setup.fitted()));
    let fitted = match law_names(setup.fitted()).join(",") {
        none if none.is_empty() => "none".to_owned(),
        laws => laws,
    };
    table.row("plan-row-fit", format!("federpendel fit … --laws {fitted}"));
    let both = |law: Law, value: f64| {
        let given = as_given(catalogue, law, value, &setup.oscillator);
        [("reduced", coefficient(catalogue, law, value).into()), ("given", given.into())]
    };
    for prospect in &plan.prospects {
        let law = prospect.law;
        let value = both(law, prospect.coefficient);
        table.named(name(catalogue, law), catalogue.format("plan-coefficient-value", &value));
        let Some(known) = prospect.largest else { continue };
        let from = [
            ("law", name(catalogue, law).into()),
            ("amplitude", length(setup.max_amplitude).into()),
        ];
        let known = [
            ("significance", catalogue.number(known.significance, 2).into()),
            ("duration", catalogue.quantity(known.duration, "s", DIGITS).into()),
        ];
        let value = catalogue.format("plan-largest-value", &known);
        table.named(catalogue.format("plan-row-largest", &from), value);
    }
    for pair in &plan.pairs {
        let [one, other] = pair.laws.map(|law| name(catalogue, law).into());
        let value = [
            ("correlation", catalogue.number(pair.correlation, 2).into()),
            ("amplitude", length(setup.max_amplitude).into()),
        ];
        let names = catalogue.format("fit-and", &[("one", one), ("other", other)]);
        table.named(names, catalogue.format("plan-pair-value", &value));
    }
    for limit in &plan.limits {
        let [reduced, given] = both(limit.law, limit.resolved());
        let upper = coefficient(catalogue, limit.law, limit.upper95());
        let name = [("law", name(catalogue, limit.law).into())];
        let value = [reduced, given, ("upper", upper.into())];
        let value = catalogue.format("plan-limit-value", &value);
        table.named(catalogue.format("plan-row-limit", &name), value);
    }
    table
}
