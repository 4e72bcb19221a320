//! Memory goes to the columns that are kept, not to the text: a file of gigabytes needs no more than its two columns.

use std::io::{self, Read, Seek, SeekFrom};

use federpendel_fit::read::{Choice, recordings_from};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// A table that lies nowhere: a time, a value, and further columns. The header is a line as wide as all others.
struct Table {
    rows: u64,
    columns: usize,
    at: u64,
}

/// The beginning of the header, and what each further column adds to it and to a row.
const HEADER: &str = "t (s);x (m)";
const FURTHER: [&str; 2] = [";Voltage U (mV)", ";1234.567890123"];

impl Table {
    fn new(rows: u64, columns: usize) -> Self {
        Table { rows, columns, at: 0 }
    }

    fn width(&self) -> u64 {
        (HEADER.len() + self.columns * FURTHER[0].len() + 1) as u64
    }

    fn line(&self, row: u64) -> String {
        let (kept, further) = match row.checked_sub(1) {
            Some(row) => (format!("{row:07};{}.{}", row % 7, row % 9), FURTHER[1]),
            None => (HEADER.to_owned(), FURTHER[0]),
        };
        kept + &further.repeat(self.columns) + "\n"
    }
}

impl Read for Table {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut written = 0;
        while written < buffer.len() && self.at < self.rows * self.width() {
            let line = self.line(self.at / self.width());
            let rest = &line.as_bytes()[(self.at % self.width()) as usize..];
            let take = rest.len().min(buffer.len() - written);
            buffer[written..written + take].copy_from_slice(&rest[..take]);
            written += take;
            self.at += take as u64;
        }
        Ok(written)
    }
}

impl Seek for Table {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = match to {
            SeekFrom::Start(at) => at,
            SeekFrom::End(offset) => (self.rows * self.width()).wrapping_add_signed(offset),
            SeekFrom::Current(offset) => self.at.wrapping_add_signed(offset),
        };
        Ok(self.at)
    }
}

/// The most memory that reading holds at once, bytes.
fn peak(table: Table) -> usize {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let rows = table.rows as usize - 1;
    let read = recordings_from(table, &Choice::default()).expect("a recording").remove(0);
    assert_eq!(read.recording.times.len(), rows);
    assert_eq!(read.recording.times.last(), Some(&(rows as f64 - 1.0)));
    assert_eq!(read.recording.values[..3], [0.0, 1.1, 2.2]);
    MEMORY.peak_usage() - before
}

/// One test, since threads would count each other's memory.
#[test]
fn memory_is_that_of_the_kept_columns() {
    // A vector that grows has room for twice its numbers at most, and a first look at a table takes some megabytes.
    let constant = 10 << 20;
    for (rows, columns) in [(1_000, 1), (1_000_000, 1), (1_000_000, 30), (100_000, 300)] {
        let table = Table::new(rows, columns);
        let (text, kept) = (rows * table.width(), 16 * rows as usize);
        let peak = peak(table);
        println!("{text} bytes of text, {kept} of numbers kept: {peak} at most");
        assert!(peak <= 2 * kept + constant, "{rows} rows, {columns} columns: {peak} bytes");
    }
}
