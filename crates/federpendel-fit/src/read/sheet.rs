//! A sheet of a workbook, written as text with tabs: the shortest decimal of a number reads back as itself, so that
//! one reader serves both.

use std::fmt::Write;
use std::io::Cursor;

use calamine::{DataType, ExcelDateTime, Reader, Xls, XlsError, Xlsx, XlsxError};

use super::error::ReadError;
use super::source::{self, Container, Source};
use super::{LARGEST_TABLE, compound, line};

/// Most columns of a sheet: those of .xlsx.
const COLUMNS: u32 = 16_384;

/// Opens a workbook.
pub(super) fn open<'a>(
    bytes: &'a [u8],
    container: Container,
    asked: Option<&str>,
) -> Result<Source<'a>, ReadError> {
    // On some damaged workbooks the library panics.
    let opened = std::panic::catch_unwind(|| match container {
        Container::Xls => xls(bytes, asked),
        _ => xlsx(bytes, asked),
    });
    let (table, text) = opened.unwrap_or_else(|_| {
        Err(ReadError::Damaged { reason: "the reader of workbooks stopped".to_owned() })
    })?;
    if text.trim_ascii().is_empty() {
        return Err(ReadError::Empty);
    }
    Ok(Source { text: text.into(), container, table: Some(line::plain(table.chars())) })
}

fn xlsx(bytes: &[u8], asked: Option<&str>) -> Result<(String, Vec<u8>), ReadError> {
    let damaged = |error: XlsxError| ReadError::Damaged { reason: error.to_string() };
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).map_err(damaged)?;
    let table = chosen(book.sheet_names(), asked)?;
    let mut cells = book.worksheet_cells_reader(&table).map_err(damaged)?;
    let mut grid = Grid::default();
    while let Some(cell) = cells.next_cell().map_err(damaged)? {
        let (row, column) = cell.get_position();
        grid.write(row, column, cell.get_value())?;
    }
    Ok((table, grid.text.into_bytes()))
}

fn xls(bytes: &[u8], asked: Option<&str>) -> Result<(String, Vec<u8>), ReadError> {
    let damaged = |error: XlsError| ReadError::Damaged { reason: error.to_string() };
    compound::check(bytes)?;
    let mut book: Xls<_> = Xls::new(Cursor::new(bytes)).map_err(damaged)?;
    let table = chosen(book.sheet_names(), asked)?;
    let range = book.worksheet_range(&table).map_err(damaged)?;
    let (top, left) = range.start().unwrap_or_default();
    let mut grid = Grid::default();
    for (row, column, value) in range.used_cells() {
        grid.write(top + row as u32, left + column as u32, value)?;
    }
    Ok((table, grid.text.into_bytes()))
}

/// Sheets on the device and the time of recording, which phyphox adds, are no tables.
fn chosen(sheets: Vec<String>, asked: Option<&str>) -> Result<String, ReadError> {
    let mut tables: Vec<String> =
        sheets.into_iter().filter(|name| !name.to_lowercase().starts_with("metadata")).collect();
    let at = source::choose(&tables, asked)?;
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
        if (row, column) < (self.row, self.column) || column >= COLUMNS {
            return Err(ReadError::Damaged {
                reason: format!("cell {row}, {column} out of order"),
            });
        }
        if value.is_empty() {
            return Ok(());
        }
        let most = LARGEST_TABLE;
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

    /// A date or a time of day is no number of anything; let it be refused as it looks.
    fn time(&mut self, time: &ExcelDateTime) {
        self.format(format_args!("[{} d]", time.as_f64()));
    }

    /// A cell of text stays one cell of one line.
    fn words(&mut self, text: &str) {
        let plain = text.trim().trim_start_matches('"');
        self.text.push_str(&line::plain(plain.chars()).replace('\t', " "));
    }
}
