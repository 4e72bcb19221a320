//! A sheet of a workbook, written as text with tabs: the shortest decimal of a number reads back as itself, so that
//! one reader serves both.

use std::fmt::Write;

use super::error::ReadError;
use super::layout::START;
use super::source::{self, Container, Source};
use super::text::Text;
use super::workbook::{Book, Value};
use super::{Choice, LARGEST_UNPACKED, MOST_COLUMNS, line};

/// Opens a workbook.
pub(super) fn open<'a>(
    book: &mut dyn Book,
    container: Container,
    choice: &Choice,
) -> Result<Source<'a>, ReadError> {
    let table = chosen(book.sheets(), choice, |sheet| {
        let start = text(book, sheet, START);
        start.is_ok_and(|start| source::holds_recording(Text::utf8(start), container, choice))
    })?;
    let text = text(book, &table, usize::MAX)?;
    if text.trim_ascii().is_empty() {
        return Err(ReadError::Empty);
    }
    let table = Some(line::plain(table.chars()));
    Ok(Source { text: Text::utf8(text), container, table })
}

/// The text of a sheet, at least so many bytes if it has them.
fn text(book: &mut dyn Book, sheet: &str, least: usize) -> Result<Vec<u8>, ReadError> {
    let mut grid = Grid::default();
    book.cells(sheet, &mut |row, column, value| {
        grid.write(row, column, value)?;
        Ok(grid.text.len() < least)
    })?;
    Ok(grid.text.into_bytes())
}

/// Sheets on the device and the time of recording, which phyphox adds, are no tables.
fn chosen(
    sheets: Vec<String>,
    choice: &Choice,
    holds: impl FnMut(&str) -> bool,
) -> Result<String, ReadError> {
    let mut tables: Vec<String> =
        sheets.into_iter().filter(|name| !name.to_lowercase().starts_with("metadata")).collect();
    let at = source::choose(&tables, choice.table.as_deref(), holds)?;
    Ok(tables.swap_remove(at))
}

/// The text of a sheet as it grows; a row of the sheet is a line.
#[derive(Default)]
struct Grid {
    text: String,
    row: u32,
    column: u32,
}

impl Grid {
    fn write(&mut self, row: u32, column: u32, value: Value) -> Result<(), ReadError> {
        if (row, column) < (self.row, self.column) {
            return Err(ReadError::Damaged {
                reason: format!("cell {row}, {column} out of order"),
            });
        }
        if column as usize >= MOST_COLUMNS {
            let found = column as usize + 1;
            return Err(ReadError::TooManyColumns { found, most: MOST_COLUMNS });
        }
        let most = LARGEST_UNPACKED;
        let bytes = self.text.len() as u64 + u64::from(row - self.row) + u64::from(column);
        if bytes > most {
            return Err(ReadError::TooLarge { bytes, most });
        }
        for _ in self.row..row {
            self.text.push('\n');
            self.column = 0;
        }
        for _ in self.column..column {
            self.text.push('\t');
        }
        (self.row, self.column) = (row, column);
        self.put(value);
        Ok(())
    }

    fn put(&mut self, value: Value) {
        match value {
            Value::Time { days, duration } => self.time(days, duration),
            // Counted things as they are counted: a column may be called 1.
            Value::Number(number) if number.fract() == 0.0 && number.abs() < 1e15 => {
                self.format(format_args!("{number}"));
            }
            Value::Number(number) => self.format(format_args!("{number:e}")),
            Value::Error => self.text.push_str("#N/A"),
            Value::Truth(yes) => self.format(format_args!("{yes}")),
            Value::Text(text) => self.words(text),
        }
    }

    fn format(&mut self, arguments: std::fmt::Arguments) {
        // A string takes everything.
        let _ = self.text.write_fmt(arguments);
    }

    /// A time of day, with a date or without, or a duration as a clock shows it; a date alone is no number of anything
    /// and is refused as it looks.
    fn time(&mut self, days: f64, duration: bool) {
        let shown = if duration { days } else { days.fract() };
        if days < 0.0 || days >= 1.0 && shown == 0.0 {
            return self.format(format_args!("[{days} d]"));
        }
        let milliseconds = (shown * 86_400_000.0).round() as u64;
        let (seconds, milliseconds) = (milliseconds / 1000, milliseconds % 1000);
        let (hours, minutes) = (seconds / 3600, seconds / 60 % 60);
        let seconds = seconds % 60;
        self.format(format_args!("{hours}:{minutes:02}:{seconds:02}.{milliseconds:03}"));
    }

    /// A cell of text stays one cell of one line.
    fn words(&mut self, text: &str) {
        let plain = text.trim().trim_start_matches('"');
        self.text.push_str(&line::plain(plain.chars()).replace('\t', " "));
    }
}
