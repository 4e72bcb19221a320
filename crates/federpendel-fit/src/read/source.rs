//! From the bytes of a file to the text of one table.

use std::borrow::Cow;

use super::error::{Found, ReadError};
use super::layout::Layout;
use super::line::excerpt;
use super::{Choice, LARGEST_TABLE, archive, column, sheet, size};

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
    pub text: Cow<'a, [u8]>,
    pub container: Container,
    /// Name of the sheet, or of the file within the archive.
    pub table: Option<String>,
}

/// First bytes of files that are no tables.
const MAGIC: &[(&[u8], Found)] = &[
    (b"\x89PNG", Found::Picture),
    (b"\xff\xd8\xff", Found::Picture),
    (b"GIF8", Found::Picture),
    (b"%PDF", Found::Pdf),
    (b"\x1f\x8b", Found::Gzip),
    (b"RIFF", Found::Media),
    (b"\x89HDF", Found::Hdf5),
    (b"MATLAB 5", Found::Hdf5),
];

/// Opens a file.
pub(super) fn open<'a>(bytes: &'a [u8], choice: &Choice) -> Result<Source<'a>, ReadError> {
    if bytes.is_empty() {
        return Err(ReadError::Empty);
    }
    // The second begins an archive of no files.
    if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06") {
        return archive::open(bytes, choice);
    }
    if bytes.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1") {
        return sheet::open(bytes, Container::Xls, choice);
    }
    if let Some(asked) = &choice.table {
        let asked = Some(asked.clone());
        return Err(ReadError::TableNotFound { asked, tables: Vec::new() });
    }
    Ok(Source { text: text(bytes)?, container: Container::Text, table: None })
}

/// The bytes of a text, in an encoding that has ASCII in it: UTF-16 is turned into UTF-8.
pub(super) fn text(bytes: &[u8]) -> Result<Cow<'_, [u8]>, ReadError> {
    if bytes.len() as u64 > LARGEST_TABLE {
        return Err(ReadError::TooLarge { bytes: bytes.len() as u64, most: LARGEST_TABLE });
    }
    let refused = |found| Err(ReadError::NoTable { found, line: 1, text: excerpt(bytes) });
    if let Some((_, found)) = MAGIC.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return refused(*found);
    }
    if let Some(rest) = bytes.strip_prefix(b"\xef\xbb\xbf") {
        return Ok(Cow::Borrowed(rest));
    }
    match bytes {
        [0xff, 0xfe, rest @ ..] => return Ok(Cow::Owned(utf16(rest, u16::from_le_bytes))),
        [0xfe, 0xff, rest @ ..] => return Ok(Cow::Owned(utf16(rest, u16::from_be_bytes))),
        [first, 0, second, 0, ..] if *first != 0 && *second != 0 => {
            return Ok(Cow::Owned(utf16(bytes, u16::from_le_bytes)));
        }
        [0, first, 0, second, ..] if *first != 0 && *second != 0 => {
            return Ok(Cow::Owned(utf16(bytes, u16::from_be_bytes)));
        }
        _ => {}
    }
    let start = &bytes[..bytes.len().min(1 << 16)];
    let control = |byte: &&u8| matches!(byte, 0..=8 | 14..=26 | 28..=31);
    if start.contains(&0) || start.iter().filter(control).count() * 20 > start.len() {
        return refused(Found::Binary);
    }
    match start.trim_ascii_start() {
        [b'<', ..] => refused(Found::Xml),
        [b'{', ..] | [b'[', b'{' | b'[' | b'\n', ..] => refused(Found::Json),
        _ => Ok(Cow::Borrowed(bytes)),
    }
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Vec<u8> {
    let (pairs, _) = bytes.as_chunks::<2>();
    let units = pairs.iter().map(|pair| unit(*pair));
    let mut text = String::with_capacity(pairs.len());
    text.extend(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)));
    text.into_bytes()
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
pub(super) fn holds_recording(start: &[u8], container: Container, choice: &Choice) -> bool {
    let rate = Choice { rate: choice.rate, ..Choice::default() };
    Layout::of(start, container.is_workbook())
        .is_ok_and(|layout| column::runs(&layout, &size::sizes(start, &layout), &rate).is_ok())
}
