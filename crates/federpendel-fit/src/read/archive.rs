//! A .zip with tables in it, as phyphox exports them.

use std::io::{Cursor, Read};

use zip::ZipArchive;
use zip::result::ZipError;

use super::error::ReadError;
use super::line::plain;
use super::source::{self, Container, Source};
use super::{LARGEST_TABLE, sheet};

fn damaged(error: ZipError) -> ReadError {
    ReadError::Damaged { reason: error.to_string() }
}

/// Opens an archive, or the workbook that is one.
pub(super) fn open<'a>(bytes: &'a [u8], asked: Option<&str>) -> Result<Source<'a>, ReadError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(damaged)?;
    let names: Vec<String> =
        archive.file_names().filter_map(|name| Some(name.ok()?.into_owned())).collect();
    if names.iter().any(|name| name == "xl/workbook.xml") {
        unpacked_size(&mut archive)?;
        return sheet::open(bytes, Container::Xlsx, asked);
    }
    let tables: Vec<String> = names.into_iter().filter(|name| is_table(name)).collect();
    let name = tables[source::choose(&tables, asked)?].clone();
    let mut text = Vec::new();
    let file = archive.by_name(&name).map_err(damaged)?;
    file.take(LARGEST_TABLE + 1)
        .read_to_end(&mut text)
        .map_err(|error| ReadError::Damaged { reason: error.to_string() })?;
    if text.is_empty() {
        return Err(ReadError::Empty);
    }
    let text = source::text(&text)?.into_owned();
    Ok(Source { text: text.into(), container: Container::Zip, table: Some(plain(name.chars())) })
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
