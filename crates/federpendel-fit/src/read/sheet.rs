//! A sheet of a workbook, written as text with tabs: the shortest decimal of a number reads back as itself, so that
//! one reader serves both.

use std::fmt::Write;
use std::io::{Cursor, Read};

use calamine::{DataType, ExcelDateTime, Reader, Xls, XlsError, Xlsx, XlsxError};

use super::error::ReadError;
use super::layout::START;
use super::source::{self, Container, Source};
use super::text::{File, Text};
use super::{Choice, LARGEST_UNPACKED, MOST_COLUMNS, compound, line};

/// Opens a workbook.
pub(super) fn open<'a>(
    file: &mut dyn File,
    container: Container,
    choice: &Choice,
) -> Result<Source<'a>, ReadError> {
    let bytes = &whole(file)?;
    // On some damaged workbooks the library panics.
    let opened = std::panic::catch_unwind(|| match container {
        Container::Xls => xls(bytes, choice),
        _ => xlsx(bytes, choice),
    });
    let (table, text) = opened.unwrap_or_else(|_| {
        Err(ReadError::Damaged { reason: "the reader of workbooks stopped".to_owned() })
    })?;
    if text.trim_ascii().is_empty() {
        return Err(ReadError::Empty);
    }
    let table = Some(line::plain(table.chars()));
    Ok(Source { text: Text::utf8(text), container, table })
}

/// All of a workbook, which its library holds anyway.
fn whole(file: &mut dyn File) -> Result<Vec<u8>, ReadError> {
    let (mut bytes, most) = (Vec::new(), LARGEST_UNPACKED);
    file.rewind()?;
    match file.take(most + 1).read_to_end(&mut bytes)? as u64 {
        found if found > most => Err(ReadError::TooLarge { bytes: found, most }),
        _ => Ok(bytes),
    }
}

fn xlsx(bytes: &[u8], choice: &Choice) -> Result<(String, Vec<u8>), ReadError> {
    let damaged = |error: XlsxError| ReadError::Damaged { reason: error.to_string() };
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(damaged)?;
    let sheets = book.sheet_names();
    let mut text = |sheet: &str, most: usize| {
        let mut cells = book.worksheet_cells_reader(sheet).map_err(damaged)?;
        let mut grid = Grid::default();
        while grid.text.len() < most
            && let Some(cell) = cells.next_cell().map_err(damaged)?
        {
            let (row, column) = cell.get_position();
            grid.write(row, column, cell.get_value())?;
        }
        Ok(grid.text.into_bytes())
    };
    let holds = |sheet: &str| {
        let start: Result<Vec<u8>, ReadError> = text(sheet, START);
        start.is_ok_and(|start| source::holds_recording(Text::utf8(start), Container::Xlsx, choice))
    };
    let table = chosen(sheets, choice, holds)?;
    let text = text(&table, usize::MAX)?;
    Ok((table, text))
}

fn xls(bytes: &[u8], choice: &Choice) -> Result<(String, Vec<u8>), ReadError> {
    let damaged = |error: XlsError| ReadError::Damaged { reason: error.to_string() };
    compound::check(bytes)?;
    let mut book: Xls<_> = Xls::new(Cursor::new(bytes)).map_err(damaged)?;
    let sheets = book.sheet_names();
    let mut text = |sheet: &str| {
        let range = book.worksheet_range(sheet).map_err(damaged)?;
        let (top, left) = range.start().unwrap_or_default();
        let mut grid = Grid::default();
        for (row, column, value) in range.used_cells() {
            grid.write(top + row as u32, left + column as u32, value)?;
        }
        Ok(grid.text.into_bytes())
    };
    let holds = |sheet: &str| {
        let whole: Result<Vec<u8>, ReadError> = text(sheet);
        whole.is_ok_and(|text| source::holds_recording(Text::utf8(text), Container::Xls, choice))
    };
    let table = chosen(sheets, choice, holds)?;
    let text = text(&table)?;
    Ok((table, text))
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
    fn write(&mut self, row: u32, column: u32, value: &impl DataType) -> Result<(), ReadError> {
        if (row, column) < (self.row, self.column) {
            return Err(ReadError::Damaged {
                reason: format!("cell {row}, {column} out of order"),
            });
        }
        if value.is_empty() {
            return Ok(());
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

    fn put(&mut self, value: &impl DataType) {
        if let Some(time) = value.get_datetime() {
            self.time(&time);
        } else if let Some(number) = value.get_int() {
            self.format(format_args!("{number}"));
        } else if let Some(number) = value.get_float() {
            self.format(format_args!("{number:e}"));
        } else if value.is_error() {
            self.text.push_str("#N/A");
        } else if let Some(yes) = value.get_bool() {
            self.format(format_args!("{yes}"));
        } else {
            let text = value.get_string().or(value.get_datetime_iso());
            self.words(text.or(value.get_duration_iso()).unwrap_or_default());
        }
    }

    fn format(&mut self, arguments: std::fmt::Arguments) {
        // A string takes everything.
        let _ = self.text.write_fmt(arguments);
    }

    /// A time of day, with a date or without, or a duration as a clock shows it; a date alone is no number of anything
    /// and is refused as it looks.
    fn time(&mut self, time: &ExcelDateTime) {
        let days = time.as_f64();
        let shown = if time.is_duration() { days } else { days.fract() };
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
