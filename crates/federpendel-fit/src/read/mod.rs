//! Reads recordings as measuring programs write them: text of many dialects, alone or in a .zip, and Excel workbooks.
//!
//! Bytes in, recordings out: no clock, no names of files. A first look at some lines tells how the table is laid out
//! (`layout`), which columns there are (`heading`, `unit`, `meaning`) and how much each of them oscillates (`size`);
//! `column` chooses those that are kept, `row` reads them and nothing else, `clean` puts them in order.
//!
//! A text is never held as a whole: each step reads it from its beginning, or parts of it (`text`), some lines at a time
//! (`blocks`). Memory goes to the columns that are kept, whatever else the file holds; only workbooks, which their
//! library holds, are read at once.

mod archive;
mod below;
mod blocks;
mod clean;
mod column;
mod comma;
mod encoding;
mod error;
mod header;
mod heading;
mod labview;
mod layout;
mod line;
mod meaning;
mod number;
mod rate;
mod row;
mod sheet;
mod size;
mod source;
mod system;
mod text;
mod times;
mod unit;
mod workbook;

pub use error::{Field, Found, ReadError};
pub use line::Separator;
pub use number::Decimal;
pub use source::Container;
pub use system::SystemError;

use std::io::{self, Cursor};

use crate::{Quantity, Recording};
use column::Run;
use layout::Layout;
use row::Kept;
use times::Times;

/// Most bytes that a table of an archive or a workbook unpacks to: a small file may unpack to more than any disk holds. A
/// text that is not packed may be as large as its disk allows.
/// Fewer where the memory has no more addresses.
pub const LARGEST_UNPACKED: u64 = if usize::BITS > 32 { 1 << 32 } else { 1 << 28 };

/// Most columns of a table.
pub const MOST_COLUMNS: usize = 4096;

/// Numbers beyond this, either way, are no measurement, and their squares would overflow.
pub const LARGEST_NUMBER: f64 = 1e100;

/// Fewest rows that hold an oscillation: its middle, amplitude, phase and frequency.
pub const LEAST_ROWS: usize = 4;

/// What to read, where the file leaves a choice. Columns are named by their whole heading, by their name without unit
/// and run, or by their number from 1.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Choice {
    /// The column of times; without it, the one that the header calls so.
    pub time: Option<String>,
    /// The column of values; without it, the component with the largest oscillating part.
    pub value: Option<String>,
    /// What the values are; without it, what unit or name say.
    pub quantity: Option<Quantity>,
    /// The unit of the values, whatever the file says.
    pub unit: Option<String>,
    /// The run, by its name or number; without it, all of them.
    pub run: Option<String>,
    /// The sheet of a workbook or the file of an archive.
    pub table: Option<String>,
    /// Times are even, at this rate, 1/s, whatever the file says.
    pub rate: Option<f64>,
}

/// A column of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnName {
    /// Its whole heading; its number if it has none.
    pub label: String,
    /// The heading without unit and run.
    pub name: String,
    /// The unit as the file writes it; empty if it does not.
    pub unit: String,
    /// Its number, from 1.
    pub number: usize,
}

/// Where the times come from.
#[derive(Debug, Clone, PartialEq)]
pub enum Clock {
    /// A column.
    Column(ColumnName),
    /// Even times, beginning at zero, at this rate, 1/s.
    Rate(f64),
}

/// Rows that something is said of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rows {
    /// How many.
    pub count: usize,
    /// The line of the first.
    pub first_line: usize,
}

impl Rows {
    /// Counts rows, the first of them on `line`.
    fn count(rows: &mut Option<Rows>, line: usize, more: usize) {
        rows.get_or_insert(Rows { count: 0, first_line: line }).count += more;
    }
}

/// What a user should know of how a recording was read.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// No header calls the time so: it is the first column, which rises.
    TimeGuessed,
    /// The file gives the time no unit; seconds are assumed.
    TimeUnitAssumed,
    /// A rate is asked for, so this column of times is not read.
    TimeIgnored {
        /// Its heading.
        column: String,
    },
    /// Neither unit nor name say what is recorded; a position is assumed.
    QuantityAssumed,
    /// Unit and name of the value contradict each other; the unit counts.
    NameContradictsUnit {
        /// What the name says.
        name: Quantity,
    },
    /// The last line ends too early and is left out.
    CutOff {
        /// The line.
        line: usize,
    },
    /// Rows without time or value are left out: empty cells, NaN and the like.
    Missing(Rows),
    /// Times fell in these rows; all are sorted.
    Sorted(Rows),
    /// Rows with the time of another, merged with it: the mean of their values stands.
    Averaged(Rows),
    /// Steps much longer than usual end in these rows.
    Gaps {
        /// The rows.
        rows: Rows,
        /// The longest step, s.
        longest: f64,
        /// The median step, s.
        usual: f64,
    },
    /// Another run of the file is no recording; told with the first that is one.
    RunLeftOut {
        /// Its name.
        run: String,
        /// Why.
        why: Box<ReadError>,
    },
}

/// How the file is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Dialect {
    /// What the table came in.
    pub container: Container,
    /// Name of the sheet, or of the file within an archive.
    pub table: Option<String>,
    /// What stands between cells; a tab for those of a workbook.
    pub separator: Separator,
    /// The decimal sign.
    pub decimal: Decimal,
    /// Whether columns have headings.
    pub header: bool,
}

/// A recording, and where in the file it comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Read {
    /// The recording.
    pub recording: Recording,
    /// Its run, if the file has several.
    pub run: Option<String>,
    /// Where its times come from.
    pub clock: Clock,
    /// The column of its values.
    pub value: ColumnName,
    /// Columns that it could have been instead.
    pub others: Vec<ColumnName>,
    /// What was assumed, left out and put in order.
    pub notes: Vec<Note>,
    /// How the file is written.
    pub dialect: Dialect,
}

/// Reads all runs of a file in memory, or the one that is chosen; never none.
///
/// # Errors
/// What was found instead of a recording. Of several runs some may be none: a note with the others says so.
pub fn recordings(bytes: &[u8], choice: &Choice) -> Result<Vec<Read>, ReadError> {
    recordings_from(Cursor::new(bytes), choice)
}

/// Reads all runs of a file, as [`recordings`] does, from its beginning wherever it stands, some of it more than once. A
/// file of text is never held as a whole.
///
/// # Errors
/// As [`recordings`], and [`ReadError::System`] where the file cannot be read.
pub fn recordings_from(
    mut file: impl io::Read + io::Seek,
    choice: &Choice,
) -> Result<Vec<Read>, ReadError> {
    let mut source = source::open(&mut file, choice)?;
    let text = &mut source.text;
    let layout = Layout::of(text, source.container.is_workbook())?;
    let sizes = size::sizes(text, &layout)?;
    let runs = column::runs(&layout, &sizes, choice)?;
    let dialect = Dialect {
        container: source.container,
        table: source.table,
        separator: layout.separator,
        decimal: layout.decimal,
        header: layout.header,
    };
    let (mut reads, mut left_out) = (Vec::<Read>::new(), Vec::new());
    let kept = row::read(text, &layout, runs)?;
    for kept in below::runs(kept, choice.run.as_deref())? {
        let name = kept.run.name.clone();
        match read(kept, &layout, &dialect) {
            Ok(read) => reads.push(read),
            Err(why) => left_out.push((name.unwrap_or_default(), why)),
        }
    }
    let Some(first) = reads.first_mut() else {
        return Err(left_out.into_iter().next().map_or(ReadError::Empty, |(_, why)| why));
    };
    let note = |(run, why)| Note::RunLeftOut { run, why: Box::new(why) };
    first.notes.extend(left_out.into_iter().map(note));
    Ok(reads)
}

fn read(kept: Kept, layout: &Layout, dialect: &Dialect) -> Result<Read, ReadError> {
    let run = kept.run.clone();
    let value = column::name(layout, run.value);
    let clock = match run.times {
        Times::Column(at, _) | Times::Clock(at) => Clock::Column(column::name(layout, at)),
        Times::Rate(rate) => Clock::Rate(rate),
    };
    let time = match &clock {
        Clock::Column(name) => name.label.clone(),
        Clock::Rate(_) => String::new(),
    };
    let clean = clean::clean(kept, &time, &value.label)?;
    let mut notes = assumed(&run, layout);
    notes.extend(clean.notes);
    Ok(Read {
        recording: Recording {
            times: clean.times,
            values: clean.values,
            quantity: run.quantity,
            unit: run.unit.map_or(value.unit.clone(), |unit| unit.si.to_owned()),
        },
        others: run.others.iter().map(|at| column::name(layout, *at)).collect(),
        run: run.name,
        clock,
        value,
        notes,
        dialect: dialect.clone(),
    })
}

/// What the choice of columns assumed.
fn assumed(run: &Run, layout: &Layout) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut note = |is: bool, note| notes.extend(is.then_some(note));
    note(run.time_guessed, Note::TimeGuessed);
    note(run.time_unit_assumed, Note::TimeUnitAssumed);
    if let Some(at) = run.time_ignored {
        note(true, Note::TimeIgnored { column: layout.headings[at].label.clone() });
    }
    note(run.quantity_assumed, Note::QuantityAssumed);
    let (name, heading) =
        (layout.headings[run.value].named_quantity(), &layout.headings[run.value]);
    // Letters say little: an axis is called x whatever is measured along it.
    if let Some(name) = name.filter(|_| heading.name.chars().count() > 3) {
        note(run.unit.is_some() && name != run.quantity, Note::NameContradictsUnit { name });
    }
    notes
}
