//! Why a file is no recording.

use federpendel::parameter::Range;
use federpendel_fit::Quantity;
use federpendel_fit::read::{Decimal, Field, Found, LEAST_ROWS, ReadError};
use federpendel_text::{Catalogue, Value, excerpt};

/// Most names of a list that a message repeats; a table may have thousands of columns.
const MOST_NAMES: usize = 12;

/// One sentence that says why a file is no recording; `file` is what the user called it.
pub fn read_error(catalogue: &Catalogue, error: &ReadError, file: &str) -> String {
    let sentence = of_file(catalogue, error);
    match (error, line(error)) {
        // What was asked for does not stand in the file.
        (
            ReadError::Rate { .. } | ReadError::RateAndTime { .. } | ReadError::ValueUnit { .. },
            _,
        ) => sentence,
        (_, Some(line)) => format!("{file}:{line}: {sentence}"),
        (_, None) => format!("{file}: {sentence}"),
    }
}

/// Sentences about a file as a whole and the tables in it.
pub(super) fn of_file(catalogue: &Catalogue, error: &ReadError) -> String {
    let allowed = || ("allowed", Value::from(catalogue.text("recording-allowed")));
    match error {
        ReadError::Empty => catalogue.format("recording-empty", &[allowed()]),
        ReadError::NoTable { found, text, .. } => {
            let what = ("found", catalogue.text(&format!("found-{}", found.key())).into());
            if is_text(*found) {
                let text = ("text", excerpt(text).into());
                catalogue.format("recording-no-table-text", &[what, text, allowed()])
            } else {
                catalogue.format("recording-no-table", &[what, allowed()])
            }
        }
        ReadError::TooLarge { bytes, most } => catalogue.format(
            "recording-too-large",
            &[("bytes", bytes.to_string().into()), ("most", most.to_string().into())],
        ),
        ReadError::Password => catalogue.text("recording-password"),
        ReadError::Damaged { reason } => {
            catalogue.format("recording-damaged", &[("reason", excerpt(reason).into())])
        }
        ReadError::SeveralTables { tables } => {
            catalogue.format("recording-several-tables", &[("tables", listed(catalogue, tables))])
        }
        ReadError::TableNotFound { asked: None, .. } => catalogue.text("recording-no-tables"),
        ReadError::TableNotFound { asked: Some(asked), tables } if tables.is_empty() => {
            catalogue.format("recording-no-named-tables", &[("asked", excerpt(asked).into())])
        }
        ReadError::TableNotFound { asked: Some(asked), tables } => catalogue.format(
            "recording-table-not-found",
            &[("asked", excerpt(asked).into()), ("tables", listed(catalogue, tables))],
        ),
        _ => of_columns(catalogue, error),
    }
}

/// Sentences about the columns of a table.
fn of_columns(catalogue: &Catalogue, error: &ReadError) -> String {
    let columns = |columns| ("columns", listed(catalogue, columns));
    match error {
        ReadError::TooManyColumns { found, most } => catalogue.format(
            "recording-too-many-columns",
            &[("found", (*found).into()), ("most", (*most).into())],
        ),
        ReadError::ColumnNotFound { field, asked, columns: known } => catalogue.format(
            "recording-column-not-found",
            &[
                ("field", field_name(catalogue, *field).into()),
                ("asked", excerpt(asked).into()),
                columns(known),
            ],
        ),
        ReadError::ColumnAmbiguous { field, asked, columns: fitting } => catalogue.format(
            "recording-column-ambiguous",
            &[
                ("field", field_name(catalogue, *field).into()),
                ("asked", excerpt(asked).into()),
                columns(fitting),
            ],
        ),
        ReadError::RunNotFound { asked, runs } if runs.is_empty() => {
            catalogue.format("recording-no-runs", &[("asked", excerpt(asked).into())])
        }
        ReadError::RunNotFound { asked, runs } => catalogue.format(
            "recording-run-not-found",
            &[("asked", excerpt(asked).into()), ("runs", listed(catalogue, runs))],
        ),
        ReadError::NoTime { columns: known } => {
            catalogue.format("recording-no-time", &[columns(known)])
        }
        ReadError::TimeUnit { column, unit, allowed } => catalogue.format(
            "recording-time-unit",
            &[
                ("column", excerpt(column).into()),
                ("unit", excerpt(unit).into()),
                ("allowed", allowed.join(", ").into()),
            ],
        ),
        ReadError::NoValue { columns: known } => {
            catalogue.format("recording-no-value", &[columns(known)])
        }
        ReadError::QuantityUnit { column, unit, asked } => {
            let (quantity, units) = quantity(catalogue, *asked);
            catalogue.format(
                "recording-quantity-unit",
                &[
                    ("column", excerpt(column).into()),
                    ("unit", excerpt(unit).into()),
                    ("quantity", quantity.into()),
                    ("allowed", units.into()),
                ],
            )
        }
        ReadError::ValueUnit { asked } => {
            catalogue.format("recording-value-unit", &[("asked", excerpt(asked).into())])
        }
        ReadError::Rate { value } => catalogue.format(
            "recording-rate",
            &[
                ("value", catalogue.exact_quantity(*value, "Hz").into()),
                ("allowed", catalogue.range(Range::Positive).into()),
            ],
        ),
        ReadError::RateAndTime { time } => {
            catalogue.format("recording-rate-and-time", &[("time", excerpt(time).into())])
        }
        _ => of_rows(catalogue, error),
    }
}

/// Sentences about the rows of a table and what stands in them.
fn of_rows(catalogue: &Catalogue, error: &ReadError) -> String {
    let exact = |value: f64, unit: &str| Value::from(catalogue.exact_quantity(value, unit));
    let cells = |id: &str, found: usize, expected: usize| {
        catalogue.format(id, &[("found", found.into()), ("expected", expected.into())])
    };
    match error {
        ReadError::NoRows { header, .. } => catalogue.format(
            "recording-no-rows",
            &[("header", excerpt(header).into()), ("least", LEAST_ROWS.into())],
        ),
        ReadError::HeaderCells { found, expected, .. } => {
            cells("recording-header-cells", *found, *expected)
        }
        ReadError::Commas { text, .. } => {
            catalogue.format("recording-commas", &[("text", excerpt(text).into())])
        }
        ReadError::Cells { found, expected, .. } => cells("recording-cells", *found, *expected),
        ReadError::NoNumber { column, value, decimal, .. } => catalogue.format(
            "recording-no-number",
            &[
                ("column", excerpt(column).into()),
                ("value", excerpt(value).into()),
                ("sign", if *decimal == Decimal::Comma { "comma" } else { "point" }.into()),
            ],
        ),
        ReadError::OutOfRange { column, value, most, .. } => catalogue.format(
            "recording-out-of-range",
            &[
                ("column", excerpt(column).into()),
                ("value", excerpt(value).into()),
                ("most", exact(*most, "1")),
            ],
        ),
        ReadError::LongLine { most, .. } => {
            catalogue.format("recording-long-line", &[("most", most.to_string().into())])
        }
        ReadError::TooFewRows { rows, least } => catalogue.format(
            "recording-too-few-rows",
            &[("rows", (*rows).into()), ("least", (*least).into())],
        ),
        ReadError::StartsOver { value, before, .. } => catalogue.format(
            "recording-starts-over",
            &[("value", exact(*value, "s")), ("before", exact(*before, "s"))],
        ),
        ReadError::ConstantTime { column, value } => catalogue.format(
            "recording-constant-time",
            &[("column", excerpt(column).into()), ("value", exact(*value, "s"))],
        ),
        ReadError::ConstantValue { column, value } => catalogue.format(
            "recording-constant-value",
            &[("column", excerpt(column).into()), ("value", exact(*value, "1"))],
        ),
        // Every other error is said by `of_file` and `of_columns`.
        other => other.to_string(),
    }
}

/// The line that an error is about; none for the file as a whole.
pub(super) fn line(error: &ReadError) -> Option<usize> {
    match error {
        ReadError::NoTable { found, line, .. } => is_text(*found).then_some(*line),
        ReadError::NoRows { line, .. }
        | ReadError::HeaderCells { line, .. }
        | ReadError::Commas { line, .. }
        | ReadError::LongLine { line, .. }
        | ReadError::Cells { line, .. }
        | ReadError::NoNumber { line, .. }
        | ReadError::OutOfRange { line, .. }
        | ReadError::StartsOver { line, .. } => Some(*line),
        _ => None,
    }
}

/// Whether the beginning of what was found can be shown.
fn is_text(found: Found) -> bool {
    matches!(found, Found::Xml | Found::Json | Found::Prose)
}

fn field_name(catalogue: &Catalogue, field: Field) -> String {
    catalogue.text(match field {
        Field::Time => "recording-field-time",
        Field::Value => "recording-field-value",
    })
}

/// A quantity, and some of its units.
pub(super) fn quantity(catalogue: &Catalogue, quantity: Quantity) -> (String, &'static str) {
    let (id, units) = match quantity {
        Quantity::Position => ("recording-quantity-position", "m, cm, mm, rad, °"),
        Quantity::Velocity => ("recording-quantity-velocity", "m/s, cm/s, km/h, rad/s, °/s"),
        Quantity::Acceleration => {
            ("recording-quantity-acceleration", "m/s², cm/s², g, rad/s², °/s²")
        }
    };
    (catalogue.text(id), units)
}

/// Names in quotes, not too many of them.
fn listed(catalogue: &Catalogue, names: &[String]) -> Value<'static> {
    let mut shown: Vec<String> =
        names.iter().take(MOST_NAMES).map(|name| catalogue.quoted(&excerpt(name))).collect();
    if names.len() > MOST_NAMES {
        shown.push("…".to_owned());
    }
    shown.join(", ").into()
}

#[cfg(test)]
mod tests {
    use federpendel_fit::read::{Choice, recordings};
    use federpendel_text::Language;

    use super::*;

    /// What is said of a file, in both languages.
    fn refused(text: &str, choice: &Choice) -> [String; 2] {
        let error = recordings(text.as_bytes(), choice).expect_err("no recording");
        Language::ALL.map(|language| read_error(&Catalogue::new(language), &error, "a.csv"))
    }

    #[test]
    fn refusals_name_place_and_value() {
        let none = Choice::default();
        let value = |name: &str| Choice { value: Some(name.into()), ..Choice::default() };
        let rows = "t (s),x (m)\n0,1\n1,2\n2,3\n3,4\n";
        // What is refused, its place, and what must be repeated of it.
        for (text, choice, place, repeated) in [
            ("", &none, "a.csv: ", ".xlsx"),
            ("%PDF-1.7 …", &none, "a.csv: ", "PDF"),
            ("{\"x\": 1}", &none, "a.csv:1: ", "JSON"),
            ("\nDear reader", &none, "a.csv:2: ", "Dear reader"),
            ("t (s),x (m)\n", &none, "a.csv:1: ", "t (s),x (m)"),
            (&format!("{rows}{}", " ".repeat(1 << 20)), &none, "a.csv:6: ", "1048576"),
            (&format!("{rows}4,much\n"), &none, "a.csv:6: ", "much"),
            (&format!("{rows}4,1e101\n"), &none, "a.csv:6: ", "1e101"),
            (&format!("{rows}4,5,6\n"), &none, "a.csv:6: ", "3"),
            (rows, &value("y"), "a.csv: ", "y"),
            (&rows.replace("(s)", "(kg)"), &none, "a.csv: ", "kg"),
            ("t (s),x (m)\n0,1\n1,2\n", &none, "a.csv: ", "4"),
            (&rows.replace([',', '2', '3', '4'], ",1"), &none, "a.csv", "1"),
        ] {
            for sentence in refused(text, choice) {
                assert!(sentence.starts_with(place), "{text:?}: {sentence}");
                assert!(sentence.contains(repeated), "{text:?}: {sentence}");
            }
        }
        for sentence in refused(rows, &Choice { rate: Some(-2.5), ..Choice::default() }) {
            assert!(sentence.contains("-2.5 Hz") || sentence.contains("-2,5 Hz"), "{sentence}");
        }
    }
}
