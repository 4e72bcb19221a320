//! Workbooks since 2007: XML in a .zip. ECMA-376, part 1, sections 18.2 to 18.4 and 18.8.

use std::io::BufReader;

use super::super::archive::Archive;
use super::format::{Format, Formats};
use super::written::Written;
use super::xml::{self, Attributes, Part};
use super::{Book, ReadError, Take, Texts, Value, damaged};

/// A workbook.
pub struct Xlsx<'a> {
    archive: Archive<'a>,
    /// The name of each sheet, and its part of the archive.
    sheets: Vec<(String, String)>,
    texts: Texts,
    /// What the numbers of each style are shown as.
    styles: Vec<Format>,
}

impl<'a> Xlsx<'a> {
    /// The workbook that an archive is.
    pub fn open(mut archive: Archive<'a>) -> Result<Self, ReadError> {
        let sheets = sheets(&mut archive)?;
        let texts = texts(&mut archive)?;
        let styles = styles(&mut archive)?;
        Ok(Xlsx { archive, sheets, texts, styles })
    }
}

impl Book for Xlsx<'_> {
    fn sheets(&self) -> Vec<String> {
        self.sheets.iter().map(|(name, _)| name.clone()).collect()
    }

    fn cells(&mut self, sheet: &str, take: &mut Take) -> Result<(), ReadError> {
        let path =
            self.sheets.iter().find(|(name, _)| name == sheet).map(|(_, path)| path.as_str());
        let mut cell = Cell::default();
        let mut written = Written::default();
        let found = walk(&mut self.archive, path.unwrap_or_default(), &mut |part| {
            written.take(part);
            match part {
                Part::Start("row", attributes) => cell.begin_row(attributes)?,
                Part::Start("c", attributes) => written.clear(cell.begin(attributes)?),
                Part::End("row") => (cell.row, cell.column) = (cell.row + 1, 0),
                Part::End("c") => {
                    let value = cell.value(&written.text, &self.texts, &self.styles)?;
                    let more = value.map_or(Ok(true), |value| take(cell.row, cell.column, value));
                    cell.column += 1;
                    return more;
                }
                _ => {}
            }
            Ok(part != Part::End("sheetData"))
        })?;
        if found { Ok(()) } else { Err(damaged("no such sheet")) }
    }
}

/// Walks through a part of the archive until `take` has enough; says whether there is such a part.
fn walk(
    archive: &mut Archive,
    path: &str,
    take: &mut dyn FnMut(Part) -> Result<bool, ReadError>,
) -> Result<bool, ReadError> {
    // Some programs write capitals elsewhere, or the separators of their system.
    let same = |name: &str| name.replace('\\', "/").eq_ignore_ascii_case(path);
    let Some(at) = archive.find(same) else { return Ok(false) };
    xml::walk(&mut BufReader::new(archive.open(at)?), take)?;
    Ok(true)
}

/// The sheets that a workbook names, and where they are.
fn sheets(archive: &mut Archive) -> Result<Vec<(String, String)>, ReadError> {
    let mut parts: Vec<(String, String)> = Vec::new();
    walk(archive, "xl/_rels/workbook.xml.rels", &mut |part| {
        if let Part::Start("Relationship", attributes) = part {
            let (mut id, mut path) = Default::default();
            for (name, value) in attributes {
                match name {
                    "Id" => id = value.into_owned(),
                    "Target" => path = value.into_owned(),
                    _ => {}
                }
            }
            // From the root, or from where the workbook is.
            let path = path.strip_prefix('/').map_or_else(|| format!("xl/{path}"), str::to_owned);
            parts.push((id, path));
        }
        Ok(part != Part::End("Relationships"))
    })?;
    let mut sheets = Vec::new();
    walk(archive, "xl/workbook.xml", &mut |part| {
        if let Part::Start("sheet", attributes) = part {
            let (mut sheet, mut path) = Default::default();
            for (name, value) in attributes {
                match name {
                    "name" => sheet = value.into_owned(),
                    "id" => path = parts.iter().find(|part| part.0 == value).map(|part| &part.1),
                    _ => {}
                }
            }
            sheets.push((sheet, path.cloned().unwrap_or_default()));
        }
        Ok(part != Part::End("workbook"))
    })?;
    Ok(sheets)
}

/// The texts that cells share; a workbook may have none.
fn texts(archive: &mut Archive) -> Result<Texts, ReadError> {
    let mut texts = Texts::default();
    let mut written = Written::default();
    written.clear("t");
    walk(archive, "xl/sharedStrings.xml", &mut |part| {
        written.take(part);
        if part == Part::End("si") {
            texts.text.push_str(&written.text);
            texts.end()?;
            written.clear("t");
        }
        Ok(part != Part::End("sst"))
    })?;
    Ok(texts)
}

/// What the numbers of each style are shown as.
fn styles(archive: &mut Archive) -> Result<Vec<Format>, ReadError> {
    let (mut formats, mut styles) = (Formats::new(), Vec::new());
    // Elements of the same names stand elsewhere, too.
    let mut within = false;
    walk(archive, "xl/styles.xml", &mut |part| {
        match part {
            Part::Start("numFmts" | "cellXfs", _) => within = true,
            Part::End("numFmts" | "cellXfs") => within = false,
            Part::Start(element @ ("numFmt" | "xf"), attributes) if within => {
                let (mut id, mut written) = (0, Format::Number);
                for (name, value) in attributes {
                    match name {
                        "numFmtId" => id = value.parse().unwrap_or(0),
                        "formatCode" => written = Format::written(&value),
                        _ => {}
                    }
                }
                if element == "numFmt" {
                    formats.set(id, written);
                } else {
                    styles.push(formats.get(id));
                }
            }
            _ => {}
        }
        Ok(part != Part::End("styleSheet"))
    })?;
    Ok(styles)
}

/// What a cell is said to hold.
#[derive(Default, Clone, Copy, PartialEq)]
enum Kind {
    #[default]
    Number,
    Shared,
    Truth,
    Error,
    Text,
}

/// A cell while it is read, and its place from 0.
#[derive(Default)]
struct Cell {
    row: u32,
    column: u32,
    kind: Kind,
    style: usize,
}

impl Cell {
    /// A row begins: its number is given, or it is the one after the last.
    fn begin_row(&mut self, attributes: Attributes) -> Result<(), ReadError> {
        for (_, given) in attributes.filter(|attribute| attribute.0 == "r") {
            (self.row, _) = place(&given).ok_or_else(|| damaged("no such row"))?;
        }
        Ok(())
    }

    /// A cell begins, as a row does; says which element its content stands in.
    fn begin(&mut self, attributes: Attributes) -> Result<&'static str, ReadError> {
        let mut element = "v";
        (self.kind, self.style) = (Kind::Number, 0);
        for (name, value) in attributes {
            match (name, &*value) {
                ("r", given) => {
                    let place = place(given).and_then(|(row, column)| Some((row, column?)));
                    (self.row, self.column) = place.ok_or_else(|| damaged("no such cell"))?;
                }
                ("s", style) => self.style = style.parse().unwrap_or(0),
                ("t", "s") => self.kind = Kind::Shared,
                ("t", "b") => self.kind = Kind::Truth,
                ("t", "e") => self.kind = Kind::Error,
                ("t", "inlineStr") => (self.kind, element) = (Kind::Text, "t"),
                ("t", "str" | "d") => self.kind = Kind::Text,
                _ => {}
            }
        }
        Ok(element)
    }

    /// What it holds, if anything.
    fn value<'a>(
        &self,
        text: &'a str,
        texts: &'a Texts,
        styles: &[Format],
    ) -> Result<Option<Value<'a>>, ReadError> {
        let shared = || {
            let found = text.parse().ok().and_then(|at| texts.get(at));
            found.ok_or_else(|| damaged("no such shared text"))
        };
        Ok(Some(match self.kind {
            _ if text.is_empty() => return Ok(None),
            Kind::Text => Value::Text(text),
            Kind::Shared => Value::Text(shared()?),
            Kind::Truth => Value::Truth(matches!(text.trim(), "1" | "true")),
            Kind::Error => Value::Error,
            Kind::Number => match text.parse() {
                Ok(number) => styles.get(self.style).unwrap_or(&Format::Number).of(number),
                Err(_) => Value::Text(text),
            },
        }))
    }
}

/// Most rows and most columns: beyond what any program writes.
const MOST: u32 = 1 << 24;

/// Row and column of a place like `B12`, from 0; a row alone has no letters.
fn place(given: &str) -> Option<(u32, Option<u32>)> {
    let row = given.trim_start_matches(|sign: char| sign.is_ascii_alphabetic());
    let mut column: u32 = 0;
    for letter in given[..given.len() - row.len()].bytes() {
        column = 26 * column + u32::from(letter.to_ascii_uppercase() - b'A') + 1;
        if column > MOST {
            return None;
        }
    }
    let row = row.parse().ok().filter(|row| (1..=MOST).contains(row))?;
    Some((row - 1, column.checked_sub(1)))
}
