//! Why a file is refused: what was found, where, and what is allowed.

use super::number::Decimal;
use super::system::SystemError;

/// What a file is instead of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Found {
    /// Bytes that are no text.
    Binary,
    /// A picture.
    Picture,
    /// A PDF document.
    Pdf,
    /// A file packed by gzip.
    Gzip,
    /// A sound or a film.
    Media,
    /// A file of HDF5 or MATLAB.
    Hdf5,
    /// XML or HTML, as Tracker and Logger Pro keep their projects.
    Xml,
    /// JSON.
    Json,
    /// Text without rows of numbers.
    Prose,
}

impl Found {
    /// A key for the message catalogue.
    pub fn key(self) -> &'static str {
        match self {
            Found::Binary => "binary",
            Found::Picture => "picture",
            Found::Pdf => "pdf",
            Found::Gzip => "gzip",
            Found::Media => "media",
            Found::Hdf5 => "hdf5",
            Found::Xml => "xml",
            Found::Json => "json",
            Found::Prose => "prose",
        }
    }
}

/// What a column is looked for as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// The time.
    Time,
    /// The value recorded.
    Value,
}

/// Why a recording is refused. Lines count from 1, in a workbook they are its rows; columns are named as in the file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// Nothing at all.
    #[error("empty")]
    Empty,
    /// No table of numbers.
    #[error("no table: {found:?} at line {line}: {text:?}")]
    NoTable {
        /// What it is instead.
        found: Found,
        /// The first line that is not blank.
        line: usize,
        /// How it begins.
        text: String,
    },
    /// An archive or workbook that unpacks to more than is read.
    #[error("{bytes} bytes; at most {most}")]
    TooLarge {
        /// Its size, at least.
        bytes: u64,
        /// The largest that is read.
        most: u64,
    },
    /// A workbook that a password locks.
    #[error("locked with a password")]
    Password,
    /// The system does not read the file.
    #[error("{}", .0.0)]
    System(SystemError),
    /// A line longer than is read.
    #[error("line {line}: longer than {most} bytes")]
    LongLine {
        /// Its number.
        line: usize,
        /// The longest that is read, with its end.
        most: usize,
    },
    /// An archive or workbook that cannot be opened.
    #[error("damaged: {reason}")]
    Damaged {
        /// What its library says.
        reason: String,
    },
    /// An archive or workbook with several tables, none of them named.
    #[error("several tables: {tables:?}")]
    SeveralTables {
        /// Their names.
        tables: Vec<String>,
    },
    /// No table, or none of the name asked for.
    #[error("table {asked:?} not found in {tables:?}")]
    TableNotFound {
        /// The name asked for, if any.
        asked: Option<String>,
        /// What there is.
        tables: Vec<String>,
    },
    /// More columns than are read.
    #[error("{found} columns; at most {most}")]
    TooManyColumns {
        /// The columns, at least.
        found: usize,
        /// The most that are read.
        most: usize,
    },
    /// A header and nothing below it.
    #[error("line {line}: no rows below {header:?}")]
    NoRows {
        /// Line of the header.
        line: usize,
        /// The header.
        header: String,
    },
    /// A header with more or fewer cells than the rows below it.
    #[error("line {line}: header of {found} cells above rows of {expected}")]
    HeaderCells {
        /// Line of the header.
        line: usize,
        /// Its cells.
        found: usize,
        /// Cells of the rows.
        expected: usize,
    },
    /// Commas that may separate columns or be decimal signs.
    #[error("line {line}: commas in {text:?} separate, or are decimal signs")]
    Commas {
        /// Its line.
        line: usize,
        /// The row.
        text: String,
    },
    /// A row with more or fewer cells than there are columns.
    #[error("line {line}: {found} cells; allowed: {expected}")]
    Cells {
        /// Its line.
        line: usize,
        /// Its cells.
        found: usize,
        /// The columns.
        expected: usize,
    },
    /// A cell that is no number.
    #[error("line {line}, {column}: {value:?} is no number")]
    NoNumber {
        /// Its line.
        line: usize,
        /// Its column.
        column: String,
        /// What it holds.
        value: String,
        /// The decimal sign of the file.
        decimal: Decimal,
    },
    /// A number beyond [`LARGEST_NUMBER`](super::LARGEST_NUMBER).
    #[error("line {line}, {column}: {value} is beyond {most}")]
    OutOfRange {
        /// Its line.
        line: usize,
        /// Its column.
        column: String,
        /// What it holds.
        value: String,
        /// Largest magnitude allowed.
        most: f64,
    },
    /// A column asked for is not there.
    #[error("{field:?} column {asked:?} not found in {columns:?}")]
    ColumnNotFound {
        /// What for.
        field: Field,
        /// The name asked for.
        asked: String,
        /// What there is.
        columns: Vec<String>,
    },
    /// A column asked for is there more than once.
    #[error("{field:?} column {asked:?} fits {columns:?}")]
    ColumnAmbiguous {
        /// What for.
        field: Field,
        /// The name asked for.
        asked: String,
        /// The columns that it fits.
        columns: Vec<String>,
    },
    /// A run asked for is not there.
    #[error("run {asked:?} not found in {runs:?}")]
    RunNotFound {
        /// The run asked for.
        asked: String,
        /// What there is.
        runs: Vec<String>,
    },
    /// No column of times, and no rate.
    #[error("no time among {columns:?}")]
    NoTime {
        /// What there is.
        columns: Vec<String>,
    },
    /// Times in something that is no unit of time.
    #[error("{column}: unit {unit:?}; allowed: {allowed:?}")]
    TimeUnit {
        /// The column.
        column: String,
        /// Its unit.
        unit: String,
        /// Units of time.
        allowed: &'static [&'static str],
    },
    /// No column of values besides the time.
    #[error("no values among {columns:?}")]
    NoValue {
        /// What there is.
        columns: Vec<String>,
    },
    /// The unit of a column contradicts the quantity asked for.
    #[error("{column}: unit {unit:?} is not one of {asked:?}")]
    QuantityUnit {
        /// The column.
        column: String,
        /// Its unit.
        unit: String,
        /// The quantity asked for.
        asked: crate::Quantity,
    },
    /// The unit asked for is none of a position, velocity or acceleration.
    #[error("unit {asked:?} is none of a position, velocity or acceleration")]
    ValueUnit {
        /// What was asked for.
        asked: String,
    },
    /// A rate that is not positive and finite.
    #[error("rate {value}; allowed: positive")]
    Rate {
        /// The rate, 1/s.
        value: f64,
    },
    /// A rate and a column of times, both asked for.
    #[error("time {time:?} and a rate; allowed: one of them")]
    RateAndTime {
        /// The column asked for.
        time: String,
    },
    /// Too few rows to hold an oscillation.
    #[error("{rows} rows; at least {least}")]
    TooFewRows {
        /// Rows with a time and a value, at different times.
        rows: usize,
        /// How many it takes.
        least: usize,
    },
    /// Times of one of several runs jump back to their beginning and rise again.
    #[error("line {line}: time {value} after {before}")]
    StartsOver {
        /// Where.
        line: usize,
        /// The time there, s.
        value: f64,
        /// The time before, s.
        before: f64,
    },
    /// All times are the same.
    #[error("{column} is {value} throughout")]
    ConstantTime {
        /// The column.
        column: String,
        /// The time, s.
        value: f64,
    },
    /// All values are the same.
    #[error("{column} is {value} throughout")]
    ConstantValue {
        /// The column.
        column: String,
        /// The value.
        value: f64,
    },
}
