//! A .zip with tables in it, as phyphox exports them.

use std::cell::RefCell;
use std::io::{self, BufReader, ErrorKind, Read, SeekFrom};

use crc::{CRC_32_ISO_HDLC, Crc, Digest, Table};
use flate2::bufread::DeflateDecoder;
use rawzip::{
    CompressionMethod, RECOMMENDED_BUFFER_SIZE, ReaderAt, ZipArchive, ZipArchiveEntryWayfinder,
    ZipLocator,
};

use super::error::ReadError;
use super::line::plain;
use super::source::{self, Container, Source};
use super::text::{File, Raw, Stream, Text, beginning, read_past};
use super::workbook::Xlsx;
use super::{Choice, LARGEST_UNPACKED, sheet};

/// Of the check sums: one table, since the page carries it.
static CHECK: Crc<u32, Table<1>> = Crc::<u32, Table<1>>::new(&CRC_32_ISO_HDLC);

/// An archive in a file, and what is in it.
pub(super) struct Archive<'a> {
    zip: ZipArchive<Places<'a>>,
    files: Vec<Packed>,
}

/// A file that is read here and there.
struct Places<'a>(RefCell<&'a mut dyn File>);

impl ReaderAt for Places<'_> {
    fn read_at(&self, buffer: &mut [u8], at: u64) -> io::Result<usize> {
        let mut file = self.0.borrow_mut();
        loop {
            file.seek(SeekFrom::Start(at))?;
            match file.read(buffer) {
                // The library takes that for a fault.
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                read => return read,
            }
        }
    }
}

/// A file as it lies in an archive.
struct Packed {
    name: String,
    place: ZipArchiveEntryWayfinder,
    method: CompressionMethod,
    locked: bool,
    check: u32,
    size: u64,
}

/// What the system says stays; all else comes from what the archive holds.
fn unpacking(error: io::Error) -> io::Error {
    if error.raw_os_error().is_some() || error.kind() == ErrorKind::Interrupted {
        return error;
    }
    io::Error::other(ReadError::Damaged { reason: error.to_string() })
}

fn damaged(error: rawzip::Error) -> ReadError {
    match error.into_kind() {
        rawzip::ErrorKind::IO(error) => unpacking(error).into(),
        kind => ReadError::Damaged { reason: kind.to_string() },
    }
}

impl<'a> Archive<'a> {
    /// Reads what is in it.
    pub fn new(file: &'a mut dyn File) -> Result<Self, ReadError> {
        let mut buffer = vec![0; RECOMMENDED_BUFFER_SIZE];
        let end = file.seek(SeekFrom::End(0))?;
        let zip = ZipLocator::new()
            .locate_in_reader(Places(RefCell::new(file)), &mut buffer, end)
            .map_err(|(_, error)| damaged(error))?;
        let mut files = Vec::new();
        let mut entries = zip.entries(&mut buffer);
        while let Some(entry) = entries.next_entry().map_err(damaged)? {
            files.push(Packed {
                name: String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned(),
                place: entry.wayfinder(),
                method: entry.compression_method(),
                locked: entry.flags().is_encrypted(),
                check: entry.crc32(),
                size: entry.uncompressed_size_hint(),
            });
        }
        Ok(Archive { zip, files })
    }

    /// The first file whose name does.
    pub fn find(&self, does: impl Fn(&str) -> bool) -> Option<usize> {
        self.files.iter().position(|file| does(&file.name))
    }

    /// Unpacks a file from its beginning.
    pub fn open(&self, at: usize) -> Result<Unpacked<'_>, ReadError> {
        let packed = &self.files[at];
        let refused = |reason: &str| ReadError::Damaged { reason: reason.to_owned() };
        if packed.locked {
            return Err(refused("locked with a password"));
        }
        let bytes = BufReader::new(self.zip.get_entry(packed.place).map_err(damaged)?.reader());
        let file: Box<dyn Read> = match packed.method {
            CompressionMethod::STORE => Box::new(bytes),
            CompressionMethod::DEFLATE => Box::new(DeflateDecoder::new(bytes)),
            _ => return Err(refused("packed in a way that is not known here")),
        };
        Ok(Unpacked { file, packed, bytes: 0, check: CHECK.digest() })
    }

    /// Refuses an archive that says it unpacks to more than is read.
    fn unpacked_size(&self) -> Result<(), ReadError> {
        allowed(self.files.iter().fold(0, |bytes: u64, file| bytes.saturating_add(file.size)))
    }
}

/// Opens an archive, or the workbook that is one.
pub(super) fn open<'a>(file: &'a mut dyn File, choice: &Choice) -> Result<Source<'a>, ReadError> {
    let archive = Archive::new(file)?;
    if archive.find(|name| name == "xl/workbook.xml").is_some() {
        archive.unpacked_size()?;
        return sheet::open(&mut Xlsx::open(archive)?, Container::Xlsx, choice);
    }
    let names = archive.files.iter().map(|file| file.name.clone());
    let tables: Vec<String> = names.filter(|name| is_table(name)).collect();
    let asked = choice.table.as_deref();
    let at = source::choose(&tables, asked, |name| {
        start(&archive, name).is_ok_and(|start| {
            let raw = Raw::File(Box::new(io::Cursor::new(start)));
            Text::new(raw).is_ok_and(|text| source::holds_recording(text, Container::Zip, choice))
        })
    })?;
    let name = &tables[at];
    if start(&archive, name)?.is_empty() {
        return Err(ReadError::Empty);
    }
    let at = archive.find(|found| found == name).unwrap_or_default();
    let table = Some(plain(name.chars()));
    let text = Text::new(Raw::Entry(Entry { archive, at }))?;
    Ok(Source { text, container: Container::Zip, table })
}

/// The beginning of a file of an archive.
fn start(archive: &Archive, name: &str) -> Result<Vec<u8>, ReadError> {
    beginning(&mut archive.open(archive.find(|found| found == name).unwrap_or_default())?)
}

/// A file in an archive.
pub(super) struct Entry<'a> {
    archive: Archive<'a>,
    at: usize,
}

impl Entry<'_> {
    /// Unpacks it from its beginning.
    pub fn open(&self) -> Result<impl Stream, ReadError> {
        self.archive.open(self.at)
    }

    /// How many bytes it says it has unpacked.
    pub fn length(&self) -> u64 {
        self.archive.files[self.at].size
    }
}

/// A file as it is unpacked, no further than what may be read, and checked at its end.
pub(super) struct Unpacked<'a> {
    file: Box<dyn Read + 'a>,
    packed: &'a Packed,
    bytes: u64,
    check: Digest<'static, u32, Table<1>>,
}

impl Read for Unpacked<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.file.read(buffer).map_err(unpacking)?;
        self.check.update(&buffer[..read]);
        self.bytes += read as u64;
        allowed(self.bytes).map_err(io::Error::other)?;
        let ended = read == 0 && !buffer.is_empty();
        if ended && self.check.clone().finalize() != self.packed.check {
            return Err(unpacking(io::Error::other("wrong check sum")));
        }
        Ok(read)
    }
}

impl Stream for Unpacked<'_> {
    fn skip(&mut self, bytes: u64) -> io::Result<()> {
        read_past(self, bytes)
    }
}

fn allowed(bytes: u64) -> Result<(), ReadError> {
    let most = LARGEST_UNPACKED;
    if bytes > most { Err(ReadError::TooLarge { bytes, most }) } else { Ok(()) }
}

/// Whether a file of an archive may be a table: phyphox keeps notes on the device under meta/, macOS others of its own.
fn is_table(name: &str) -> bool {
    let small = name.to_lowercase();
    let known =
        [".csv", ".txt", ".tsv", ".dat", ".asc", ".lvm"].iter().any(|end| small.ends_with(end));
    let aside =
        small.split('/').any(|part| matches!(part, "meta" | "__macosx") || part.starts_with('.'));
    known && !aside
}
