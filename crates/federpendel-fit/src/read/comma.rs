//! Whether commas between integers separate columns or are decimal signs: "12,03" alone could be either of two.

use super::error::ReadError;
use super::heading::Heading;
use super::line::{Cells, Line, Separator, decode, excerpt};

/// Whether commas are decimal signs, given the line above the rows. One heading over two integers says so, and so do
/// decimals that begin with a zero.
///
/// # Errors
/// What may be either: without headings, numbers that are no times in the first of two columns; or decimals that begin
/// with a zero where commas must separate, too.
pub(super) fn are_decimal(above: Option<&Line>, rows: &[Line]) -> Result<bool, ReadError> {
    let Some(table) = rows.iter().map(integers).collect::<Option<Vec<_>>>() else {
        return Ok(false);
    };
    let widest = table.iter().map(Vec::len).max().unwrap_or(0);
    let headings: Vec<Heading> = above
        .into_iter()
        .flat_map(|line| Cells::new(line.text, Separator::Comma))
        .map(|cell| Heading::parse(&decode(cell)))
        .collect();
    let measures =
        |heading: &Heading| heading.known_unit().is_some() || heading.quantity().is_some();
    match headings.as_slice() {
        [only] if widest == 2 && measures(only) => return Ok(true),
        [_, _, ..] => return Ok(false),
        _ => {}
    }
    let decimals = |row: &Vec<&[u8]>| row.iter().skip(1).step_by(2).any(|cell| has_zero(cell));
    if let Some(at) = table.iter().position(decimals) {
        return if widest == 2 { Ok(true) } else { Err(either(&rows[at])) };
    }
    let first: Vec<i64> = table.iter().filter_map(|row| decode(row[0]).parse().ok()).collect();
    let falls = first.windows(2).filter(|pair| pair[1] < pair[0]).count();
    if widest == 2 && falls * 100 > table.len() { Err(either(&rows[0])) } else { Ok(false) }
}

/// The integers between the commas of a row, the first of each two with a sign or without; `None` if there is anything
/// else, or one without a second, but for an integer alone.
fn integers<'a>(row: &Line<'a>) -> Option<Vec<&'a [u8]>> {
    let cells: Vec<&[u8]> = Cells::new(row.text, Separator::Comma).collect();
    let whole = |cell: &[u8]| !cell.is_empty() && cell.iter().all(u8::is_ascii_digit);
    let fits = cells.iter().enumerate().all(|(at, cell)| match cell {
        [b'-' | b'+', digits @ ..] if at % 2 == 0 => whole(digits),
        digits => whole(digits),
    });
    (fits && (cells.len() == 1 || cells.len().is_multiple_of(2))).then_some(cells)
}

/// Whether digits begin with a zero, as no integer does.
fn has_zero(digits: &[u8]) -> bool {
    matches!(digits, [b'0', _, ..])
}

fn either(row: &Line) -> ReadError {
    ReadError::Commas { line: row.number, text: excerpt(row.text) }
}
