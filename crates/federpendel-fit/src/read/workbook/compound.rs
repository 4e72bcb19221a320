//! The file system within an .xls. [MS-CFB], sections 2.2 to 2.6.
//!
//! A table says of each sector which comes next, so a damaged one may lead in a circle, and reading would never end.

use super::super::error::ReadError;
use super::damaged;

/// Entries from here on are no sectors: the end of a chain, a sector that is free or of the table itself.
const SPECIAL: u32 = 0xffff_fffa;

/// Size of the sectors of small streams, which together are a stream themselves.
const SMALL_SECTOR: usize = 64;

/// Streams below this size are small.
const SMALL: usize = 4096;

/// A stream.
struct Entry {
    name: String,
    start: u32,
    length: usize,
}

/// A file of streams.
pub(super) struct Compound<'a> {
    bytes: &'a [u8],
    /// Size of a sector.
    size: usize,
    /// Which sector follows each.
    table: Vec<u32>,
    /// The first stream is that of all small ones.
    entries: Vec<Entry>,
}

fn number(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}

fn numbers(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect()
}

impl<'a> Compound<'a> {
    pub fn open(bytes: &'a [u8]) -> Result<Self, ReadError> {
        let size = if bytes.get(30) == Some(&12) { 4096 } else { 512 };
        let mut file = Compound { bytes, size, table: Vec::new(), entries: Vec::new() };
        let cut_off = || damaged("compound file cut off");
        file.table = file.table().ok_or_else(cut_off)?;
        let directory = number(bytes, 48).ok_or_else(cut_off)?;
        let directory = file.chain(directory, usize::MAX)?;
        file.entries = directory.as_chunks().0.iter().map(entry).collect();
        Ok(file)
    }

    /// A sector; the last may be cut short.
    fn sector(&self, id: u32) -> Option<&'a [u8]> {
        self.bytes.chunks(self.size).nth((id as usize).checked_add(1)?)
    }

    /// The table, whose sectors are named by the header, 109 of them, and by a chain of sectors.
    fn table(&self) -> Option<Vec<u32>> {
        let mut parts = numbers(self.bytes.get(76..512)?);
        let mut more = number(self.bytes, 68)?;
        let most = self.bytes.len() / self.size + 1;
        for _ in 0..most {
            if more >= SPECIAL {
                break;
            }
            parts.extend(numbers(self.sector(more)?));
            more = parts.pop()?;
        }
        let mut table = Vec::new();
        for id in parts.into_iter().filter(|id| *id < SPECIAL).take(most) {
            table.extend(numbers(self.sector(id)?));
        }
        Some(table)
    }

    /// The bytes of a chain of sectors, at most so many.
    fn chain(&self, start: u32, length: usize) -> Result<Vec<u8>, ReadError> {
        follow(start, length, &self.table, |id| self.sector(id))
    }

    fn find(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.name.eq_ignore_ascii_case(name))
    }

    /// Whether there is a stream of this name.
    pub fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// The stream of this name.
    pub fn stream(&self, name: &str) -> Result<Option<Vec<u8>>, ReadError> {
        let Some(entry) = self.find(name) else { return Ok(None) };
        if entry.length >= SMALL {
            return self.chain(entry.start, entry.length).map(Some);
        }
        let whole =
            self.entries.first().map_or(Ok(Vec::new()), |all| self.chain(all.start, all.length))?;
        let table = numbers(&match number(self.bytes, 60) {
            Some(start) if start < SPECIAL => self.chain(start, usize::MAX)?,
            _ => Vec::new(),
        });
        let sector = |id: u32| whole.chunks(SMALL_SECTOR).nth(id as usize);
        follow(entry.start, entry.length, &table, sector).map(Some)
    }
}

/// Puts the sectors of a chain together.
fn follow<'a>(
    start: u32,
    length: usize,
    table: &[u32],
    sector: impl Fn(u32) -> Option<&'a [u8]>,
) -> Result<Vec<u8>, ReadError> {
    let (mut bytes, mut at) = (Vec::new(), start);
    let mut seen = vec![false; table.len()];
    while at < SPECIAL && bytes.len() < length {
        let seen = seen.get_mut(at as usize);
        let (Some(seen), Some(sector)) = (seen, sector(at)) else {
            return Err(damaged("compound file with a sector beyond its end"));
        };
        if std::mem::replace(seen, true) {
            return Err(damaged("compound file with a circle of sectors"));
        }
        bytes.extend_from_slice(sector);
        at = table[at as usize];
    }
    bytes.truncate(length);
    Ok(bytes)
}

/// An entry of the directory; sizes beyond four bytes are beyond what is read.
fn entry(bytes: &[u8; 128]) -> Entry {
    let (units, _) = bytes[..64].as_chunks();
    let units = units.iter().map(|unit| u16::from_le_bytes(*unit)).take_while(|unit| *unit != 0);
    let name = char::decode_utf16(units).map(|sign| sign.unwrap_or(char::REPLACEMENT_CHARACTER));
    let field = |at| number(bytes, at).unwrap_or(0);
    Entry { name: name.collect(), start: field(116), length: field(120) as usize }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOOK: &[u8] = include_bytes!("../../../tests/data/raw-data.xls");

    fn reason(bytes: &[u8]) -> Option<ReadError> {
        Compound::open(bytes).and_then(|file| file.stream("workbook")).err()
    }

    #[test]
    fn a_circle_of_sectors_is_refused() {
        assert_eq!(reason(BOOK), None);
        let first = number(BOOK, 76).unwrap() as usize;
        let stream = Compound::open(BOOK).unwrap().find("Workbook").unwrap().start as usize;
        let mut book = BOOK.to_vec();
        // A sector follows itself.
        let at = 512 * (first + 1) + 4 * stream;
        book[at..][..4].copy_from_slice(&(stream as u32).to_le_bytes());
        assert_eq!(reason(&book), Some(damaged("compound file with a circle of sectors")));
        book[at..][..4].copy_from_slice(&[0, 0, 1, 0]);
        assert_eq!(reason(&book), Some(damaged("compound file with a sector beyond its end")));
        assert_eq!(reason(&BOOK[..511]), Some(damaged("compound file cut off")));
        assert!(reason(&BOOK[..3000]).is_some());
        assert!(reason(&[]).is_some());
    }
}
