//! A .zip with tables in it, as phyphox exports them.

use std::io::{self, BufReader, ErrorKind, Read};

use zip::ZipArchive;
use zip::read::ZipFile;
use zip::result::ZipError;

use super::error::ReadError;
use super::line::plain;
use super::source::{self, Container, Source};
use super::text::{File, Raw, Stream, Text, beginning, read_past};
use super::{Choice, LARGEST_UNPACKED, sheet};

/// An archive in a file; its library reads a few bytes at a time.
type Archive<'a> = ZipArchive<BufReader<&'a mut dyn File>>;

/// A file in an archive.
pub(super) struct Entry<'a> {
    archive: Archive<'a>,
    name: String,
}

/// What the system says stays; all else comes from what the archive holds.
fn unpacking(error: io::Error) -> io::Error {
    if error.raw_os_error().is_some() || error.kind() == ErrorKind::Interrupted {
        return error;
    }
    io::Error::other(ReadError::Damaged { reason: error.to_string() })
}

fn damaged(error: ZipError) -> ReadError {
    match error {
        ZipError::Io(error) => unpacking(error).into(),
        error => ReadError::Damaged { reason: error.to_string() },
    }
}

/// Opens an archive, or the workbook that is one.
pub(super) fn open<'a>(file: &'a mut dyn File, choice: &Choice) -> Result<Source<'a>, ReadError> {
    let mut archive = ZipArchive::new(BufReader::new(file)).map_err(damaged)?;
    let names: Vec<String> =
        archive.file_names().filter_map(|name| Some(name.ok()?.into_owned())).collect();
    if names.iter().any(|name| name == "xl/workbook.xml") {
        unpacked_size(&mut archive)?;
        return sheet::open(archive.into_inner().into_inner(), Container::Xlsx, choice);
    }
    let tables: Vec<String> = names.into_iter().filter(|name| is_table(name)).collect();
    let asked = choice.table.as_deref();
    let at = source::choose(&tables, asked, |name| {
        start(&mut archive, name).is_ok_and(|start| {
            let raw = Raw::File(Box::new(io::Cursor::new(start)));
            Text::new(raw).is_ok_and(|text| source::holds_recording(text, Container::Zip, choice))
        })
    })?;
    let name = &tables[at];
    if start(&mut archive, name)?.is_empty() {
        return Err(ReadError::Empty);
    }
    let table = Some(plain(name.chars()));
    let entry = Entry { archive, name: name.clone() };
    Ok(Source { text: Text::new(Raw::Entry(entry))?, container: Container::Zip, table })
}

/// The beginning of a file of an archive.
fn start(archive: &mut Archive, name: &str) -> Result<Vec<u8>, ReadError> {
    beginning(&mut Unpacked::new(archive, name)?)
}

impl Entry<'_> {
    /// Unpacks it from its beginning.
    pub fn open(&mut self) -> Result<impl Stream, ReadError> {
        Unpacked::new(&mut self.archive, &self.name)
    }

    /// How many bytes it says it has unpacked.
    pub fn length(&mut self) -> Result<u64, ReadError> {
        Ok(self.archive.by_name(&self.name).map_err(damaged)?.size())
    }
}

/// A file as it is unpacked, no further than what may be read.
struct Unpacked<'a, 'f> {
    file: ZipFile<'a, BufReader<&'f mut dyn File>>,
    bytes: u64,
}

impl<'a, 'f> Unpacked<'a, 'f> {
    fn new(archive: &'a mut Archive<'f>, name: &str) -> Result<Self, ReadError> {
        Ok(Unpacked { file: archive.by_name(name).map_err(damaged)?, bytes: 0 })
    }
}

impl Read for Unpacked<'_, '_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.file.read(buffer).map_err(unpacking)?;
        self.bytes += read as u64;
        allowed(self.bytes).map_err(io::Error::other)?;
        Ok(read)
    }
}

impl Stream for Unpacked<'_, '_> {
    fn skip(&mut self, bytes: u64) -> io::Result<()> {
        read_past(self, bytes)
    }
}

/// Refuses an archive that says it unpacks to more than is read.
fn unpacked_size(archive: &mut Archive) -> Result<(), ReadError> {
    let mut bytes: u64 = 0;
    for at in 0..archive.len() {
        bytes = bytes.saturating_add(archive.by_index_raw(at).map_err(damaged)?.size());
    }
    allowed(bytes)
}

fn allowed(bytes: u64) -> Result<(), ReadError> {
    let most = LARGEST_UNPACKED;
    if bytes > most { Err(ReadError::TooLarge { bytes, most }) } else { Ok(()) }
}

/// Whether a file of an archive may be a table: phyphox keeps notes on the device under meta/, macOS others of its own.
fn is_table(name: &str) -> bool {
    let small = name.to_lowercase();
    let known = [".csv", ".txt", ".tsv", ".dat", ".asc"].iter().any(|end| small.ends_with(end));
    let aside =
        small.split('/').any(|part| matches!(part, "meta" | "__macosx") || part.starts_with('.'));
    known && !aside
}
