//! A .zip with tables in it, as phyphox exports them.

use std::io::{Cursor, Read};

use zip::ZipArchive;
use zip::result::ZipError;

use super::error::ReadError;
use super::layout::{Layout, START};
use super::line::plain;
use super::source::{self, Container, Source};
use super::{Choice, LARGEST_TABLE, sheet};

fn damaged(error: ZipError) -> ReadError {
    ReadError::Damaged { reason: error.to_string() }
}

/// Opens an archive, or the workbook that is one.
pub(super) fn open<'a>(bytes: &'a [u8], choice: &Choice) -> Result<Source<'a>, ReadError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(damaged)?;
    let names: Vec<String> =
        archive.file_names().filter_map(|name| Some(name.ok()?.into_owned())).collect();
    if names.iter().any(|name| name == "xl/workbook.xml") {
        unpacked_size(&mut archive)?;
        return sheet::open(bytes, Container::Xlsx, choice);
    }
    let tables: Vec<String> = names.into_iter().filter(|name| is_table(name)).collect();
    let asked = choice.table.as_deref();
    let at = source::choose(&tables, asked, |name| {
        let start = archive.by_name(name).map_err(damaged).and_then(|mut file| start(&mut file));
        start.is_ok_and(|start| {
            source::text(&start)
                .is_ok_and(|text| source::holds_recording(&text, Container::Zip, choice))
        })
    })?;
    let name = &tables[at];
    let mut file = archive.by_name(name).map_err(damaged)?;
    let mut text = start(&mut file)?;
    if text.is_empty() {
        return Err(ReadError::Empty);
    }
    // What begins like no table is unpacked no further.
    Layout::of(&source::text(&text)?, false)?;
    unpack(&mut file, LARGEST_TABLE + 1 - text.len() as u64, &mut text)?;
    let text = source::text(&text)?.into_owned();
    let table = Some(plain(name.chars()));
    Ok(Source { text: text.into(), container: Container::Zip, table })
}

/// The beginning of a file, by which its layout is told.
fn start(file: &mut impl Read) -> Result<Vec<u8>, ReadError> {
    let mut text = Vec::new();
    unpack(file, START as u64, &mut text)?;
    Ok(text)
}

fn unpack(file: &mut impl Read, most: u64, text: &mut Vec<u8>) -> Result<(), ReadError> {
    let unpacked = file.take(most).read_to_end(text);
    unpacked.map(drop).map_err(|error| ReadError::Damaged { reason: error.to_string() })
}

/// Refuses an archive that says it unpacks to more than is read.
fn unpacked_size(archive: &mut ZipArchive<Cursor<&[u8]>>) -> Result<(), ReadError> {
    let mut bytes: u64 = 0;
    for at in 0..archive.len() {
        bytes = bytes.saturating_add(archive.by_index_raw(at).map_err(damaged)?.size());
    }
    let most = LARGEST_TABLE;
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
