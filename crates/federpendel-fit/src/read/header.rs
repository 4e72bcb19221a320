//! The header above the rows: which line it is, and its cells.

use super::error::ReadError;
use super::heading::{Heading, is_run};
use super::line::{Cells, Line, Separator, decode};
use super::number::{self, Cell, Decimal};
use super::unit;

/// How wide rows are: with the empty cells at their ends, and without those that all of them have.
#[derive(Debug, Clone, Copy)]
pub(super) struct Width {
    pub most: usize,
    pub least: usize,
}

/// The cells of a header above rows of this width. It may be separated in another way than they are.
pub(super) fn header_cells(line: &Line, separator: Separator, width: Width) -> Option<Vec<String>> {
    let text = if line.is_comment() { uncommented(line.text) } else { line.text };
    let split = |separator| {
        let mut cells: Vec<String> = Cells::new(text, separator).map(decode).collect();
        while cells.last().is_some_and(String::is_empty) {
            cells.pop();
        }
        cells
    };
    let spaced = split(Separator::Space);
    let own = if separator == Separator::Space { glued(&spaced) } else { split(separator) };
    let [tabs, semicolons, commas] =
        [Separator::Tab, Separator::Semicolon, Separator::Comma].map(split);
    let wide = words(&decode(text), "  ");
    let readings = [own, tabs, semicolons, commas, wide, glued(&spaced), spaced];
    // A single column has no separator that a line could lack.
    let some = if width.most == 1 { 1 } else { readings.len() };
    readings
        .into_iter()
        .take(some)
        .find(|cells| (width.least..=width.most).contains(&cells.len()) && are_names(cells))
}

/// Whether at least half of the cells that hold something are text.
fn are_names(cells: &[String]) -> bool {
    let is_text = |cell: &&String| {
        [Decimal::Point, Decimal::Comma]
            .iter()
            .all(|decimal| number::read(cell.as_bytes(), *decimal) == Cell::Text)
    };
    let texts = cells.iter().filter(is_text).count();
    texts > 0 && texts * 2 >= cells.iter().filter(|cell| !cell.is_empty()).count()
}

/// A line without its sign of a comment.
fn uncommented(text: &[u8]) -> &[u8] {
    let is_sign = |byte: &&u8| matches!(byte, b'#' | b'%' | b'/') || byte.is_ascii_whitespace();
    &text[text.iter().take_while(is_sign).count()..]
}

/// Parts between runs of blanks.
fn words(text: &str, gap: &str) -> Vec<String> {
    text.split(gap).map(str::trim).filter(|part| !part.is_empty()).map(str::to_owned).collect()
}

/// Words up to the brackets of a unit: "Time", "(s)", "Angular", "velocity", "(rad/s)".
fn glued(words: &[String]) -> Vec<String> {
    let mut cells: Vec<String> = Vec::new();
    let mut open = false;
    for word in words {
        match cells.last_mut() {
            Some(last) if open || word.starts_with(['(', '[', '{']) => {
                last.push(' ');
                last.push_str(word);
            }
            _ => cells.push(word.clone()),
        }
        open = !word.ends_with([')', ']', '}']);
    }
    cells
}

/// The headings above rows of this width, if there are any.
pub(super) fn headings(
    above: &[Line],
    separator: Separator,
    width: Width,
) -> Result<Option<Vec<Heading>>, ReadError> {
    let (rest, cells) = match header_line(above, separator, width)? {
        Some((at, cells)) => (&above[..at], cells),
        None => return Ok(None),
    };
    let mut headings: Vec<Heading> = cells.iter().map(|cell| Heading::parse(cell)).collect();
    let Some(over) = rest.last() else { return Ok(Some(headings)) };
    let names = header_cells(over, separator, width).filter(|names| names.len() == cells.len());
    if let Some(names) = names.filter(|names| is_units(&cells) && !is_units(names)) {
        for (heading, (name, unit)) in headings.iter_mut().zip(names.iter().zip(&cells)) {
            *heading = Heading::parse(name);
            if heading.unit.is_empty() {
                heading.unit = bare(unit);
            }
        }
    }
    let runs: Vec<String> = Cells::new(over.text, separator).map(decode).collect();
    let mut current = None;
    for (heading, run) in headings.iter_mut().zip(runs) {
        current = is_run(&run).then_some(run).or(current);
        heading.run = heading.run.take().or_else(|| current.clone());
    }
    Ok(Some(headings))
}

/// A unit without brackets.
fn bare(unit: &str) -> String {
    unit.trim_matches(['(', ')', '[', ']', ' ']).to_owned()
}

/// Whether at least half of the cells are units, and none is the name of a time.
fn is_units(cells: &[String]) -> bool {
    let known = |cell: &&String| unit::parse(&bare(cell)).is_some();
    let (units, others): (Vec<&String>, Vec<&String>) = cells.iter().partition(known);
    units.len() >= others.len() && !others.iter().any(|cell| Heading::parse(cell).is_time())
}

/// The line of the header, and its cells: above the rows with nothing but comments between, or a comment itself. One
/// that names a time is preferred.
fn header_line(
    above: &[Line],
    separator: Separator,
    width: Width,
) -> Result<Option<(usize, Vec<String>)>, ReadError> {
    let first = above.iter().rposition(|line| !line.is_comment());
    let fits: Vec<(usize, Vec<String>)> = (first.unwrap_or(0)..above.len())
        .rev()
        .filter_map(|at| Some((at, header_cells(&above[at], separator, width)?)))
        .collect();
    let names_time = |cells: &[String]| cells.iter().any(|cell| Heading::parse(cell).is_time());
    let found = fits.iter().find(|(_, cells)| names_time(cells)).or(fits.first());
    match (found, first) {
        (Some(found), _) => Ok(Some(found.clone())),
        (None, Some(first)) => misfit(&above[first], separator, width).map(|()| None),
        (None, None) => Ok(None),
    }
}

/// The line above the rows is not as wide as they are. It belongs to a preamble, unless all its cells are text or one
/// names a time.
fn misfit(line: &Line, separator: Separator, width: Width) -> Result<(), ReadError> {
    let found = trimmed_width(line, separator);
    if found < 2 || separator == Separator::Space {
        return Ok(());
    }
    let cells: Vec<String> = Cells::new(line.text, separator).take(found).map(decode).collect();
    let is_text = |cell: &String| are_names(std::slice::from_ref(cell));
    if cells.iter().any(|cell| Heading::parse(cell).is_time()) || cells.iter().all(is_text) {
        return Err(ReadError::HeaderCells { line: line.number, found, expected: width.most });
    }
    Ok(())
}

/// Cells of a line without the empty ones at its end.
pub(super) fn trimmed_width(line: &Line, separator: Separator) -> usize {
    let cells = Cells::new(line.text, separator).enumerate();
    cells.filter(|(_, cell)| !cell.is_empty()).last().map_or(0, |(at, _)| at + 1)
}
