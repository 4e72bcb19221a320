//! Tables of decimal numbers as CSV, for spreadsheets in two dialects.

use std::io::{self, Write};

use csv::{ErrorKind, Terminator, WriterBuilder};
use federpendel::Sample;

/// The first line of a table of samples, the same in every language and dialect.
pub const HEADER: [&str; 5] =
    ["Time (s)", "Position (m)", "Velocity (m/s)", "Acceleration (m/s^2)", "Mode"];

/// How cells and decimals are separated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dialect {
    /// Commas between cells, decimal points.
    #[default]
    Standard,
    /// Semicolons between cells, decimal commas, as German spreadsheets expect.
    German,
}

impl Dialect {
    /// All dialects.
    pub const ALL: [Dialect; 2] = [Dialect::Standard, Dialect::German];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Dialect::Standard => "standard",
            Dialect::German => "german",
        }
    }

    /// The dialect of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|dialect| dialect.name() == name)
    }
}

/// Writes the samples of a motion.
///
/// # Errors
/// Those of `out`.
pub fn samples(samples: &[Sample], dialect: Dialect, out: &mut dyn Write) -> io::Result<()> {
    let rows = samples.iter().map(|sample| {
        let mode = f64::from(sample.mode as i8);
        [sample.time, sample.position, sample.velocity, sample.acceleration, mode]
    });
    table(&HEADER.map(str::to_owned), rows, dialect, out)
}

/// Writes a table of numbers under its header.
///
/// # Errors
/// Those of `out`.
pub fn table<R: AsRef<[f64]>>(
    header: &[String],
    rows: impl Iterator<Item = R>,
    dialect: Dialect,
    out: &mut dyn Write,
) -> io::Result<()> {
    let cells =
        |row: R| -> Vec<_> { row.as_ref().iter().map(|number| cell(*number, dialect)).collect() };
    records(header, rows.map(cells), dialect, out)
}

/// Writes a table of cells under its header.
///
/// # Errors
/// Those of `out`.
pub fn records(
    header: &[String],
    rows: impl Iterator<Item = Vec<String>>,
    dialect: Dialect,
    out: &mut dyn Write,
) -> io::Result<()> {
    write_records(header, rows, dialect, out).map_err(|error| match error.into_kind() {
        // As it is, so that a broken pipe is known as one.
        ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    })
}

fn write_records(
    header: &[String],
    rows: impl Iterator<Item = Vec<String>>,
    dialect: Dialect,
    out: &mut dyn Write,
) -> csv::Result<()> {
    let delimiter = if dialect == Dialect::German { b';' } else { b',' };
    let mut table = WriterBuilder::new()
        .delimiter(delimiter)
        .terminator(Terminator::Any(b'\n'))
        .from_writer(out);
    table.write_record(header)?;
    for row in rows {
        table.write_record(row)?;
    }
    Ok(table.flush()?)
}

/// The shortest text that gives back the same number.
pub fn cell(number: f64, dialect: Dialect) -> String {
    // Adding zero turns −0 into 0 and changes nothing else.
    let number = number + 0.0;
    let text = match number.abs() {
        0.0 | 1e-5..1e16 => number.to_string(),
        _ => format!("{number:e}"),
    };
    if dialect == Dialect::German { text.replace('.', ",") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn cells_are_short() {
        let cells = [0.1, -0.0, 2.0, 1e-7, -1.5e300, 123456.789]
            .map(|number| cell(number, Dialect::Standard));
        assert_eq!(cells, ["0.1", "0", "2", "1e-7", "-1.5e300", "123456.789"]);
        assert_eq!(cell(-0.25, Dialect::German), "-0,25");
    }

    proptest! {
        #[test]
        fn cells_give_back_the_number(number in proptest::num::f64::NORMAL) {
            prop_assert_eq!(cell(number, Dialect::Standard).parse(), Ok(number));
            let german = cell(number, Dialect::German).replace(',', ".");
            prop_assert_eq!(german.parse(), Ok(number));
        }
    }
}
