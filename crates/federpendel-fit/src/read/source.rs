//! From a file to the text of one table.

use std::io::Read;

use super::error::ReadError;
use super::layout::Layout;
use super::text::{File, Raw, Text};
use super::workbook::Xls;
use super::{Choice, LARGEST_UNPACKED, archive, column, sheet, size};

/// Bytes that tell an archive or a workbook.
const LONGEST_MAGIC: u64 = 8;

/// What a table came in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Container {
    /// A text file.
    Text,
    /// A text file in a .zip.
    Zip,
    /// A sheet of an Excel workbook, .xlsx.
    Xlsx,
    /// A sheet of an Excel workbook before 2007, .xls.
    Xls,
}

impl Container {
    /// Whether this is a workbook, in whose sheets every cell stands in its column.
    pub(super) fn is_workbook(self) -> bool {
        matches!(self, Container::Xlsx | Container::Xls)
    }
}

/// The text of a table.
pub(super) struct Source<'a> {
    pub text: Text<'a>,
    pub container: Container,
    /// Name of the sheet, or of the file within the archive.
    pub table: Option<String>,
}

/// Opens a file.
pub(super) fn open<'a>(file: &'a mut dyn File, choice: &Choice) -> Result<Source<'a>, ReadError> {
    let mut bytes = Vec::new();
    file.rewind()?;
    file.take(LONGEST_MAGIC).read_to_end(&mut bytes)?;
    if bytes.is_empty() {
        return Err(ReadError::Empty);
    }
    // The second begins an archive of no files.
    if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06") {
        return archive::open(file, choice);
    }
    if bytes.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1") {
        return sheet::open(&mut Xls::open(&whole(file)?)?, Container::Xls, choice);
    }
    if let Some(asked) = &choice.table {
        let asked = Some(asked.clone());
        return Err(ReadError::TableNotFound { asked, tables: Vec::new() });
    }
    let text = Text::new(Raw::File(Box::new(file)))?;
    Ok(Source { text, container: Container::Text, table: None })
}

/// All of a workbook that is no archive: its parts lie scattered.
fn whole(file: &mut dyn File) -> Result<Vec<u8>, ReadError> {
    let (mut bytes, most) = (Vec::new(), LARGEST_UNPACKED);
    file.rewind()?;
    match file.take(most + 1).read_to_end(&mut bytes)? as u64 {
        found if found > most => Err(ReadError::TooLarge { bytes: found, most }),
        _ => Ok(bytes),
    }
}

/// Chooses one of several tables: by its name, without its folder or extension if need be; else one of raw data, as
/// phyphox calls its own; else the only one, or the only one that holds a recording.
pub(super) fn choose(
    tables: &[String],
    asked: Option<&str>,
    mut holds: impl FnMut(&str) -> bool,
) -> Result<usize, ReadError> {
    let base = |name: &str| {
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name).to_lowercase();
        name.rsplit_once('.').map_or(name.clone(), |(stem, _)| stem.to_owned())
    };
    let find = |fits: &dyn Fn(&str) -> bool| tables.iter().position(|name| fits(name));
    if let Some(asked) = asked {
        return find(&|name| name == asked)
            .or_else(|| find(&|name| base(name) == base(asked)))
            .ok_or_else(|| ReadError::TableNotFound {
                asked: Some(asked.to_owned()),
                tables: tables.to_vec(),
            });
    }
    let raw = find(&|name| ["raw data", "rohdaten"].contains(&base(name).as_str()));
    match (raw, tables.len()) {
        (Some(at), _) => Ok(at),
        (None, 1) => Ok(0),
        (None, 0) => Err(ReadError::TableNotFound { asked: None, tables: Vec::new() }),
        (None, _) => {
            let mut held = (0..tables.len()).filter(|at| holds(&tables[*at]));
            match (held.next(), held.next()) {
                (Some(only), None) => Ok(only),
                _ => Err(ReadError::SeveralTables { tables: tables.to_vec() }),
            }
        }
    }
}

/// Whether a table that begins so may hold a recording: numbers, and times among them or a rate.
pub(super) fn holds_recording(mut start: Text, container: Container, choice: &Choice) -> bool {
    let rate = Choice { rate: choice.rate, ..Choice::default() };
    let layout = Layout::of(&mut start, container.is_workbook());
    layout.is_ok_and(|layout| {
        let sizes = size::sizes(&mut start, &layout);
        sizes.is_ok_and(|sizes| column::runs(&layout, &sizes, &rate).is_ok())
    })
}
