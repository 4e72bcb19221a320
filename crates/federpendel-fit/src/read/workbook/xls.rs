//! Workbooks before 2007: records in a compound file. [MS-XLS], sections 2.1.7 and 2.4.

use super::biff::Record;
use super::compound::Compound;
use super::format::{Format, Formats};
use super::{Book, ReadError, Take, Texts, Value, damaged};

/// Kinds of records.
mod kind {
    pub const FORMULA: u16 = 0x06;
    pub const EOF: u16 = 0x0a;
    pub const FILE_PASS: u16 = 0x2f;
    pub const BOUND_SHEET: u16 = 0x85;
    pub const MUL_RK: u16 = 0xbd;
    pub const R_STRING: u16 = 0xd6;
    pub const XF: u16 = 0xe0;
    pub const SST: u16 = 0xfc;
    pub const LABEL_SST: u16 = 0xfd;
    pub const NUMBER: u16 = 0x203;
    pub const LABEL: u16 = 0x204;
    pub const BOOL_ERR: u16 = 0x205;
    pub const STRING: u16 = 0x207;
    pub const RK: u16 = 0x27e;
    pub const FORMAT: u16 = 0x41e;
    pub const BOF: u16 = 0x809;
}

/// A workbook.
pub struct Xls {
    stream: Vec<u8>,
    /// Whether texts are of BIFF8, from 1997 on, or older.
    recent: bool,
    /// The name of each sheet, and where in the stream it begins.
    sheets: Vec<(String, usize)>,
    texts: Texts,
    formats: Formats,
    /// The format of each style.
    styles: Vec<u16>,
}

/// What a cell holds.
#[derive(Clone, Copy)]
enum Holds {
    Value(Value<'static>),
    /// The number of a text that cells share.
    Shared(usize),
    /// The number of a text of the sheet.
    Own(usize),
}

impl Xls {
    /// The workbook of these bytes.
    pub fn open(bytes: &[u8]) -> Result<Self, ReadError> {
        let file = Compound::open(bytes)?;
        if file.has("EncryptedPackage") {
            return Err(ReadError::Password);
        }
        let stream = match file.stream("Workbook")? {
            Some(stream) => stream,
            None => file.stream("Book")?.ok_or_else(|| damaged("no workbook in it"))?,
        };
        let mut book = Xls {
            stream: Vec::new(),
            recent: true,
            sheets: Vec::new(),
            texts: Texts::default(),
            formats: Formats::new(),
            styles: Vec::new(),
        };
        each(&stream, |record| match record.kind {
            kind::FILE_PASS => Err(ReadError::Password),
            kind::EOF => Ok(false),
            _ => book.global(record).map(|()| true).ok_or_else(|| cut_off(record.kind)),
        })?;
        book.stream = stream;
        Ok(book)
    }

    /// What a record says of the whole workbook.
    fn global(&mut self, mut record: Record) -> Option<()> {
        match record.kind {
            kind::BOF => self.recent = record.u16()? != 0x500,
            kind::BOUND_SHEET => {
                let at = record.u32()? as usize;
                record.u16()?;
                let count = record.u8()?.into();
                let mut name = String::new();
                self.text(&mut record, count, &mut name)?;
                self.sheets.push((name.replace('\0', ""), at));
            }
            // One that cannot be read is none.
            kind::FORMAT => drop(self.format(record)),
            kind::XF => {
                record.u16()?;
                self.styles.push(record.u16()?);
            }
            kind::SST => {
                record.bytes::<8>()?;
                while !record.is_over() {
                    record.rich_text(&mut self.texts.text)?;
                    self.texts.end().ok()?;
                }
            }
            _ => {}
        }
        Some(())
    }

    fn format(&mut self, mut record: Record) -> Option<()> {
        let id = record.u16()?;
        let count = if self.recent { record.u16()? } else { record.u8()?.into() };
        let mut code = String::new();
        self.text(&mut record, count, &mut code)?;
        // Those below are built in, and written in the language of the program.
        if id >= 164 {
            self.formats.set(id, Format::written(&code));
        }
        Some(())
    }

    /// A number in this style.
    fn number(&self, style: u16, number: f64) -> Value<'static> {
        let id = self.styles.get(usize::from(style)).copied().unwrap_or(0);
        self.formats.get(id).of(number)
    }

    /// Adds a text of so many signs: in BIFF8 a byte before them says how wide they are.
    fn text(&self, record: &mut Record, count: u16, text: &mut String) -> Option<()> {
        let wide = self.recent && count > 0 && record.u8()? & 1 != 0;
        record.signs(count.into(), wide, text)
    }
}

impl Book for Xls {
    fn sheets(&self) -> Vec<String> {
        self.sheets.iter().map(|(name, _)| name.clone()).collect()
    }

    fn cells(&mut self, sheet: &str, take: &mut Take) -> Result<(), ReadError> {
        let found = self.sheets.iter().find(|(name, _)| name == sheet);
        let stream = found.and_then(|(_, at)| self.stream.get(*at..));
        let stream = stream.ok_or_else(|| damaged("no such sheet"))?;
        let mut sheet =
            Sheet { book: self, cells: Vec::new(), texts: Texts::default(), at: (0, 0) };
        let mut depth = 0;
        each(stream, |record| {
            match record.kind {
                // Charts within a sheet hold numbers of their own.
                kind::BOF => depth += 1,
                kind::EOF => depth -= 1,
                _ if depth == 1 => sheet.read(record).ok_or_else(|| cut_off(record.kind))?,
                _ => {}
            }
            Ok(depth > 0)
        })?;
        sheet.hand_out(take)
    }
}

/// A sheet as it is read.
struct Sheet<'a> {
    book: &'a Xls,
    /// Row and column of each cell, in the order of the file.
    cells: Vec<((u16, u16), Holds)>,
    texts: Texts,
    /// Where the last formula stands, whose text follows.
    at: (u16, u16),
}

impl Sheet<'_> {
    fn read(&mut self, mut record: Record) -> Option<()> {
        let kind = record.kind;
        match kind {
            kind::NUMBER | kind::RK | kind::MUL_RK | kind::FORMULA => {}
            kind::LABEL | kind::R_STRING | kind::LABEL_SST | kind::BOOL_ERR => {}
            kind::STRING => {
                let holds = self.own(&mut record)?;
                self.cells.push((self.at, holds));
                return Some(());
            }
            _ => return Some(()),
        }
        let (row, mut column, style) = (record.u16()?, record.u16()?, record.u16()?);
        let number = |style, number| Some(Holds::Value(self.book.number(style, number)));
        let holds = match kind {
            kind::NUMBER => number(style, record.f64()?),
            kind::RK => number(style, packed(record.u32()?)),
            kind::MUL_RK => {
                // The last column ends the record.
                let mut style = style;
                while let Some(value) = record.u32() {
                    self.cells.push((
                        (row, column),
                        Holds::Value(self.book.number(style, packed(value))),
                    ));
                    (style, column) = (record.u16()?, column.checked_add(1)?);
                }
                None
            }
            kind::FORMULA => {
                self.at = (row, column);
                match record.bytes::<8>()? {
                    [0, .., 0xff, 0xff] => None,
                    [1, _, truth, .., 0xff, 0xff] => Some(Holds::Value(Value::Truth(truth != 0))),
                    [2, .., 0xff, 0xff] => Some(Holds::Value(Value::Error)),
                    [_, .., 0xff, 0xff] => Some(Holds::Value(Value::Text(""))),
                    bytes => number(style, f64::from_le_bytes(bytes)),
                }
            }
            kind::LABEL_SST => Some(Holds::Shared(record.u32()? as usize)),
            kind::BOOL_ERR => Some(Holds::Value(match record.bytes()? {
                [truth, 0] => Value::Truth(truth != 0),
                _ => Value::Error,
            })),
            _ => Some(self.own(&mut record)?),
        };
        self.cells.extend(holds.map(|holds| ((row, column), holds)));
        Some(())
    }

    /// A text that stands in the record.
    fn own(&mut self, record: &mut Record) -> Option<Holds> {
        let count = record.u16()?;
        self.book.text(record, count, &mut self.texts.text)?;
        self.texts.end().ok()?;
        Some(Holds::Own(self.texts.ends.len() - 1))
    }

    /// Row after row; what is written over stands no longer.
    fn hand_out(mut self, take: &mut Take) -> Result<(), ReadError> {
        self.cells.sort_by_key(|cell| cell.0);
        let after = self.cells.iter().skip(1).map(Some).chain([None]);
        for (((row, column), holds), after) in self.cells.iter().zip(after) {
            if after.is_some_and(|after| after.0 == (*row, *column)) {
                continue;
            }
            let value = match *holds {
                Holds::Value(value) => Some(value),
                Holds::Shared(at) => self.book.texts.get(at).map(Value::Text),
                Holds::Own(at) => self.texts.get(at).map(Value::Text),
            };
            if let Some(value) = value
                && !take((*row).into(), (*column).into(), value)?
            {
                break;
            }
        }
        Ok(())
    }
}

/// A number in four bytes: an integer or the upper half of a float, of which two bits say which and whether it stands
/// for a hundred times the value. [MS-XLS], section 2.5.217.
fn packed(bits: u32) -> f64 {
    let number = match bits & 2 {
        0 => f64::from_bits(u64::from(bits & !3) << 32),
        _ => f64::from(bits.cast_signed() >> 2),
    };
    if bits & 1 == 0 { number } else { number / 100.0 }
}

/// Goes through the records of a stream until `take` has enough.
fn each(
    mut stream: &[u8],
    mut take: impl FnMut(Record) -> Result<bool, ReadError>,
) -> Result<(), ReadError> {
    while !stream.is_empty() {
        let record = Record::first(stream).ok_or_else(|| damaged("workbook cut off"))?;
        stream = record.rest;
        if !take(record)? {
            break;
        }
    }
    Ok(())
}

fn cut_off(kind: u16) -> ReadError {
    damaged(format!("record {kind:#x} cut off"))
}
