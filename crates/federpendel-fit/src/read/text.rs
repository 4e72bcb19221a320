//! The text of a table, read from its beginning as often as need be and never held as a whole.

use std::io::{self, Read, Seek, SeekFrom};

use super::archive::Entry;
use super::blocks::Blocks;
use super::encoding::{Encoding, Utf16};
use super::error::ReadError;
use super::layout::START;

/// What can be read from its beginning again.
pub(super) trait File: Read + Seek {}

impl<T: Read + Seek> File for T {}

/// One reading of a text.
pub(super) trait Stream: Read {
    /// Leaves out so many bytes, or all that are left.
    fn skip(&mut self, bytes: u64) -> io::Result<()>;
}

/// Leaves out bytes of what can only be read on.
pub(super) fn read_past(stream: &mut impl Read, bytes: u64) -> io::Result<()> {
    io::copy(&mut stream.take(bytes), &mut io::sink()).map(drop)
}

impl Stream for &mut dyn File {
    fn skip(&mut self, bytes: u64) -> io::Result<()> {
        // Beyond its end there is nothing to read.
        let bytes = i64::try_from(bytes).map_err(io::Error::other)?;
        self.seek(SeekFrom::Current(bytes)).map(drop)
    }
}

/// Where the bytes of a text are.
pub(super) enum Raw<'a> {
    /// A file, or memory.
    File(Box<dyn File + 'a>),
    /// A file in an archive, unpacked anew for each reading.
    Entry(Entry<'a>),
}

impl Raw<'_> {
    fn open(&mut self) -> Result<Box<dyn Stream + '_>, ReadError> {
        match self {
            Raw::File(file) => {
                file.rewind()?;
                let file: &mut dyn File = &mut **file;
                Ok(Box::new(file))
            }
            Raw::Entry(entry) => Ok(Box::new(entry.open()?)),
        }
    }

    fn length(&mut self) -> Result<u64, ReadError> {
        match self {
            Raw::File(file) => Ok(file.seek(SeekFrom::End(0))?),
            Raw::Entry(entry) => Ok(entry.length()),
        }
    }
}

/// A text, in an encoding that has ASCII in it whatever the file's is.
pub(super) struct Text<'a> {
    raw: Raw<'a>,
    encoding: Encoding,
}

impl<'a> Text<'a> {
    /// A text in whatever encoding its first bytes show.
    pub fn new(mut raw: Raw<'a>) -> Result<Self, ReadError> {
        let start = beginning(&mut raw.open()?)?;
        let encoding = Encoding::of(&start)?;
        Ok(Text { raw, encoding })
    }

    /// A text in memory that is known to be UTF-8.
    pub fn utf8(bytes: impl AsRef<[u8]> + 'a) -> Self {
        let raw = Raw::File(Box::new(io::Cursor::new(bytes)));
        Text { raw, encoding: Encoding::PLAIN }
    }

    fn open(&mut self) -> Result<Box<dyn Stream + '_>, ReadError> {
        let mut raw = self.raw.open()?;
        raw.skip(self.encoding.mark)?;
        Ok(match self.encoding.wide {
            Some(unit) => Box::new(Utf16::new(raw, unit)),
            None => raw,
        })
    }

    /// Its beginning, by which its layout is told.
    pub fn start(&mut self) -> Result<Vec<u8>, ReadError> {
        beginning(&mut self.open()?)
    }

    /// How many bytes it has; about as many, if it is packed or in UTF-16.
    pub fn length(&mut self) -> Result<u64, ReadError> {
        let bytes = self.raw.length()?.saturating_sub(self.encoding.mark);
        Ok(if self.encoding.wide.is_some() { bytes / 2 } else { bytes })
    }

    /// Its lines, which this byte ends, from the one that begins at byte `at`.
    pub fn lines(&mut self, end: u8, at: u64) -> Result<Blocks<'_>, ReadError> {
        let mut stream = self.open()?;
        stream.skip(at)?;
        Ok(Blocks::new(stream, end, at))
    }
}

/// As many bytes as tell the layout of a table.
pub(super) fn beginning(stream: &mut impl Read) -> Result<Vec<u8>, ReadError> {
    let mut bytes = Vec::new();
    stream.take(START as u64).read_to_end(&mut bytes)?;
    Ok(bytes)
}
