//! What is wrong with a program's samples.

use federpendel_text::{Catalogue, Value, excerpt};

use crate::score::{Column, Fault, LARGEST_FILE, LARGEST_NUMBER};

/// One sentence: file, line, column, value, what is allowed.
pub(crate) fn samples_fault(catalogue: &Catalogue, fault: &Fault, file: &str) -> String {
    let say = |id: &str, line: Option<usize>, variables: &[(&'static str, Value<'static>)]| {
        let place = line.map_or(file.to_owned(), |line| format!("{file}:{line}"));
        let place = ("place", Value::from(place));
        catalogue.format(id, &[&[place], variables].concat())
    };
    let cell = |id: &str, line: usize, column: Column, value: &str| {
        let largest = catalogue.exact_quantity(LARGEST_NUMBER, "1");
        let variables = [
            ("column", column.names().0.into()),
            ("value", excerpt(value).into()),
            ("largest", largest.into()),
        ];
        say(id, Some(line), &variables)
    };
    match fault {
        Fault::TooLarge => {
            say("samples-too-large", None, &[("limit", LARGEST_FILE.to_string().into())])
        }
        Fault::NotUtf8 { line } => say("samples-not-utf8", Some(*line), &[]),
        Fault::Empty => say("samples-empty", None, &[]),
        Fault::NoRows => say("samples-no-rows", None, &[]),
        Fault::Missing { line, header, column } => {
            let (name, short) = column.names();
            let variables = [
                ("header", excerpt(header).into()),
                ("name", name.into()),
                ("short", short.into()),
            ];
            say("samples-missing-column", Some(*line), &variables)
        }
        Fault::Twice { line, column } => {
            say("samples-column-twice", Some(*line), &[("column", column.names().0.into())])
        }
        Fault::Unit { line, column, unit } => {
            let variables = [
                ("column", column.names().0.into()),
                ("unit", excerpt(unit).into()),
                ("allowed", column.unit().into()),
            ];
            say("samples-unit", Some(*line), &variables)
        }
        Fault::Cells { line, found, expected } => {
            let variables = [("found", (*found).into()), ("expected", (*expected).into())];
            say("samples-cells", Some(*line), &variables)
        }
        Fault::NoNumber { line, column, value } => cell("samples-no-number", *line, *column, value),
        Fault::NotFinite { line, column, value } => {
            cell("samples-not-finite", *line, *column, value)
        }
        Fault::Negative { line, value } => {
            cell("samples-negative-time", *line, Column::Time, value)
        }
    }
}
