//! Fits as a table: a row for each, and for each recording that could not be fitted.

use std::io::{self, Write};

use federpendel::Mix;
use federpendel_fit::physical::Absent;
use federpendel_fit::{Damping, Estimate, Given, Model, Parameters, Physical, damping};
use federpendel_report::recording::{Fitted, sentences};
use federpendel_text::Catalogue;

use super::super::csv::{Dialect, cell, records};
use super::names::{law_names, quantity_name};
use crate::fit::{Failed, Fits};

/// What stands in the columns of each parameter and physical number, after its name.
const ENDS: [&str; 4] = ["", "_stderr", "_low95", "_high95"];

/// A cell; of what is not known, or not in the mix, it is empty.
enum Cell {
    Text(String),
    Number(Option<f64>),
}

/// A cell below the name of its column.
type Column = (String, Cell);

/// A row for each fit, with the same columns in all, and then one for each recording that has none: its name and why.
pub(super) fn write(
    fits: &Fits,
    dialect: Dialect,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let row = |fit: &Fitted| Some(columns(fit, fit.report.best()?, catalogue));
    let rows: Vec<Vec<Column>> = fits.fitted.iter().filter_map(row).collect();
    let header: Vec<String> =
        rows.first().into_iter().flatten().map(|(name, _)| name.clone()).collect();
    let written = |(_, found): Column| match found {
        Cell::Text(text) => text,
        Cell::Number(number) => number.map_or(String::new(), |number| cell(number, dialect)),
    };
    let rows = rows.into_iter().map(|row| row.into_iter().map(written).collect());
    let failed = fits.failed.iter().map(|failed| without_fit(failed, header.len()));
    records(&header, rows.chain(failed), dialect, out)
}

/// The row of a recording that could not be fitted: its name, empty cells, and why.
fn without_fit(failed: &Failed, columns: usize) -> Vec<String> {
    let mut row = vec![String::new(); columns];
    row[columns - 1] = failed.failure.sentence();
    row[0] = harmless(&failed.name);
    row
}

/// All of a row; the name is first, and why there is no fit last.
fn columns(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> Vec<Column> {
    let mut columns = about(fit);
    for name in Parameters::NAMES.into_iter().chain(["static_acceleration"]) {
        let found = model.parameter(name);
        let interval = found.map(|found| found.interval95).unwrap_or_default();
        let value = found.and_then(|found| found.value);
        columns.extend(number(name, value, found.and_then(|found| found.stderr), interval));
    }
    columns.extend(figures(damping(&fit.report).as_ref()));
    for (name, answer) in fit.physical.unwrap_or(NOTHING_BESIDE).numbers() {
        let one = answer.ok();
        let interval = one.map(|one| one.interval95).unwrap_or_default();
        let (value, error) = (one.and_then(|one| one.value), one.and_then(|one| one.stderr));
        columns.extend(number(name, value, error, interval));
    }
    let rest = model.rest.as_ref();
    columns.extend([
        of("rest_time", rest.map(|rest| rest.time)),
        of("rest_position", rest.map(|rest| rest.position)),
        of("rms", Some(model.rms)),
        of("aicc", Some(model.criteria.aicc)),
        text("verdict", sentences(fit, catalogue).join(" ")),
        text("notes", fit.notes(catalogue).join(" ")),
        text("error", String::new()),
    ]);
    columns
}

/// What was fitted, and whether the mix describes it.
fn about(fit: &Fitted) -> Vec<Column> {
    let report = &fit.report;
    // A mix without any law has a name here, since no cell would be nothing to choose from.
    let named = |one: &Mix| if *one == Mix::default() { "none".to_owned() } else { mix(*one) };
    let alternatives = report.verdict.alternatives.iter().map(named);
    vec![
        text("name", harmless(&fit.name)),
        text("quantity", quantity_name(report.quantity).to_owned()),
        text("unit", report.unit.clone()),
        text("length_unit", report.length_unit()),
        text("laws", mix(report.verdict.mix)),
        text("alternatives", alternatives.collect::<Vec<_>>().join(" ")),
        text("adequate", report.adequacy.adequate.to_string()),
        text("n", report.samples.to_string()),
        of("from", Some(report.window.from)),
        of("to", Some(report.window.to)),
    ]
}

/// The laws of a mix: `stokes+coulomb`.
fn mix(mix: Mix) -> String {
    law_names(mix).join("+")
}

/// Engineers' figures, and the equivalent damping ratio at the first and the last amplitude.
fn figures(damping: Option<&Damping>) -> Vec<Column> {
    let single = [
        ("natural_frequency", damping.map(|one| one.natural_frequency)),
        ("damping_ratio", damping.and_then(|one| one.damping_ratio)),
        ("quality_factor", damping.and_then(|one| one.quality_factor)),
        ("logarithmic_decrement", damping.and_then(|one| one.logarithmic_decrement)),
    ];
    let with_error = |(name, figure): (&str, Option<Estimate>)| {
        let error = of(&format!("{name}_stderr"), figure.and_then(|one| one.stderr));
        [of(name, figure.and_then(|one| one.value)), error]
    };
    let mut columns: Vec<_> = single.into_iter().flat_map(with_error).collect();
    let equivalent = damping.map(|one| &one.equivalent[..]).unwrap_or_default();
    for (end, one) in [("first", equivalent.first()), ("last", equivalent.last())] {
        let name = format!("equivalent_damping_{end}");
        let error = one.and_then(|one| one.stderr);
        let amplitude = one.map(|one| one.amplitude);
        columns.extend([
            of(&name, one.map(|one| one.damping_ratio)),
            of(&format!("{name}_stderr"), error),
            of(&format!("{name}_amplitude"), amplitude),
        ]);
    }
    columns
}

/// What is known where nothing was measured beside the recording.
const NOTHING_BESIDE: Physical = Physical {
    given: Given { mass: None, stiffness: None, spring_mass: None, normal: None },
    mass: Err(Absent::Mass),
    moving_mass: Err(Absent::Mass),
    stiffness: Err(Absent::Mass),
    damping: Err(Absent::Mass),
    coulomb_force: Err(Absent::Mass),
    newton_coefficient: Err(Absent::Mass),
    kinetic: Err(Absent::Mass),
    static_: Err(Absent::Mass),
    agreement: None,
};

/// The columns of a number with its error and its 95 % interval.
fn number(
    name: &str,
    value: Option<f64>,
    stderr: Option<f64>,
    interval95: (Option<f64>, Option<f64>),
) -> [Column; ENDS.len()] {
    let cells = [value, stderr, interval95.0, interval95.1];
    std::array::from_fn(|i| of(&format!("{name}{}", ENDS[i]), cells[i]))
}

fn of(name: &str, number: Option<f64>) -> Column {
    (name.to_owned(), Cell::Number(number))
}

fn text(name: &str, cell: String) -> Column {
    (name.to_owned(), Cell::Text(cell))
}

/// A file of this name as no spreadsheet takes it for a formula: `./=1+1.csv`.
fn harmless(name: &str) -> String {
    if name.starts_with(['=', '+', '-', '@', '\t', '\r']) {
        format!("./{name}")
    } else {
        name.to_owned()
    }
}
