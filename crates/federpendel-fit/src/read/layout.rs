//! How a table is laid out, told from its first lines: separator, decimal sign, header, where the numbers begin.

use memchr::memchr2_iter;

use super::MOST_COLUMNS;
use super::blocks::{Block, LONGEST_LINE};
use super::comma;
use super::error::{Found, ReadError};
use super::header::{Width, header_cells, headings, trimmed_width};
use super::heading::Heading;
use super::labview;
use super::line::{Cells, Line, Lines, Separator, decode, excerpt, line_end};
use super::number::{self, Cell, Decimal};
use super::text::Text;

/// Lines looked at, and bytes that they begin in.
const SAMPLE: (usize, usize) = (500, 1 << 20);

/// Bytes of a table that tell its layout: the last line that begins in the sample may be as long as any.
pub(super) const START: usize = SAMPLE.1 + LONGEST_LINE;

/// The layout of a table.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout {
    pub separator: Separator,
    pub decimal: Decimal,
    /// Byte that ends lines.
    pub end: u8,
    /// Headings, as many as there are columns.
    pub headings: Vec<Heading>,
    /// Fewest cells of a row; those that it lacks are the last, and empty.
    pub least: usize,
    /// Whether the file has a header.
    pub header: bool,
    /// Lines above the rows, the header among them.
    pub preamble: Vec<String>,
    /// First byte of the first row.
    pub start: usize,
    /// Line of the first row.
    pub line: usize,
}

/// How lines of a sample look when cells are split in one way.
struct Look {
    separator: Separator,
    decimal: Decimal,
    /// For each line: its cells, and whether at least half of those that hold something are numbers.
    lines: Vec<(usize, bool)>,
    /// Twice the cells that are numbers, less those that are text, from the first row.
    score: isize,
}

impl Look {
    fn new(sample: &[Line], separator: Separator, decimal: Decimal) -> Self {
        let mut look = Look { separator, decimal, lines: Vec::new(), score: 0 };
        let mut any = false;
        for line in sample {
            let (mut cells, mut numbers, mut texts) = (0, 0, 0);
            for cell in Cells::new(line.text, separator) {
                cells += 1;
                match number::read(cell, decimal) {
                    Cell::Number(_) => numbers += 1,
                    Cell::Text if number::clock(cell).is_some() => numbers += 1,
                    // A number to who wrote it: refused where it is read, with its separators, not split at them.
                    Cell::Text if number::is_grouped(cell, decimal) => numbers += 1,
                    Cell::Text => texts += 1,
                    Cell::Missing => {}
                }
            }
            let row = numbers > 0 && numbers >= texts;
            any |= row;
            if any {
                look.score += 2 * numbers - texts;
            }
            look.lines.push((cells, row));
        }
        look
    }

    /// Width of most rows.
    fn width(&self, sample: &[Line]) -> Width {
        let most = self.most_cells();
        let rows = self.lines.iter().zip(sample).filter(|(look, _)| **look == (most, true));
        let filled = rows.map(|(_, line)| trimmed_width(line, self.separator)).max();
        Width { most, least: filled.unwrap_or(most) }
    }

    /// Takes rows that end before their last cells, which are empty, to be as wide as the widest; returns the fewest
    /// cells of a row. In a sheet (`aligned`) every cell stands in its column. In text most rows decide, unless some row
    /// is wider, and as wide as the header.
    fn fill_up(&mut self, aligned: bool) -> usize {
        let (usual, rows) = (self.most_cells(), self.lines.iter().position(|(_, row)| *row));
        let (header, rows) = self.lines.split_at(rows.unwrap_or(0));
        let widest = rows.iter().filter(|(_, row)| *row).map(|(cells, _)| *cells).max();
        let (widest, least) = match (header.last(), widest) {
            _ if aligned => (self.lines.iter().map(|(cells, _)| *cells).max().unwrap_or(0), 1),
            // A time and a value at least; what precedes a single column is no row.
            (Some((header, _)), Some(widest))
                if *header == widest && widest > usual && usual > 1 =>
            {
                (widest, usual)
            }
            _ => return usual,
        };
        for (cells, row) in &mut self.lines {
            if aligned || *row && *cells >= least {
                *cells = widest;
            }
        }
        least
    }

    /// Cells of most rows.
    fn most_cells(&self) -> usize {
        let mut widths: Vec<usize> =
            self.lines.iter().filter(|(_, row)| *row).map(|(cells, _)| *cells).collect();
        widths.sort_unstable();
        let groups = widths.chunk_by(|a, b| a == b);
        groups.max_by_key(|group| group.len()).map_or(0, |group| group[0])
    }

    /// The first row: a broken row directly below a header of the right width is one, too.
    fn first(&self, sample: &[Line]) -> Option<usize> {
        let width = self.width(sample);
        let first = self.lines.iter().position(|line| *line == (width.most, true))?;
        let above = self.lines[..first].iter().rposition(|(_, row)| !row);
        let below = above.map_or(0, |at| at + 1);
        let broken = below < first
            && above.is_none_or(|at| header_cells(&sample[at], self.separator, width).is_some());
        Some(if broken { below } else { first })
    }
}

impl Layout {
    /// Looks at the first lines of a table; in one that is `aligned`, as a sheet is, rows may lack their last cells.
    pub fn of(text: &mut Text, aligned: bool) -> Result<Self, ReadError> {
        let mut layout = Self::told_by(&text.start()?, aligned)?;
        layout.settle_decimal(text)?;
        Ok(layout)
    }

    fn told_by(start: &[u8], aligned: bool) -> Result<Self, ReadError> {
        let end = line_end(start);
        let filled = |line: &Line| !line.is_blank();
        let all: Vec<Line> = Lines::new(start, end, 0, 1)
            .take_while(|line| line.start < SAMPLE.1)
            .filter(filled)
            .take(SAMPLE.0)
            .collect();
        let Some(top) = all.first() else { return Err(ReadError::Empty) };
        let labview = labview::Header::split(&all);
        let table = labview.as_ref().map_or(&all[..], |(_, table)| table);
        // There, too, every cell stands in its column.
        let aligned = aligned || labview.is_some();
        let sample: Vec<Line> = table.iter().filter(|line| !line.is_comment()).copied().collect();
        let separator = labview.as_ref().and_then(|(said, _)| said.separator());
        let mut look = best_look(&sample, separator);
        let (over, rows) = sample.split_at(look.lines.iter().position(|line| line.1).unwrap_or(0));
        if look.separator == Separator::Comma && comma::are_decimal(over.last(), rows)? {
            look = Look::new(&sample, Separator::Tab, Decimal::Comma);
        }
        let least = look.fill_up(aligned);
        let Some(first) = look.first(&sample) else { return Err(without_rows(top, &sample)) };
        let row = sample[first];
        let above: Vec<Line> =
            table.iter().take_while(|line| line.number < row.number).copied().collect();
        let width = look.width(&sample);
        if width.most > MOST_COLUMNS {
            return Err(ReadError::TooManyColumns { found: width.most, most: MOST_COLUMNS });
        }
        let named = headings(&above, look.separator, width)?;
        let header = named.is_some();
        let mut headings: Vec<Heading> =
            named.unwrap_or_else(|| (0..width.least).map(Heading::numbered).collect());
        let mut preamble: Vec<String> = above.iter().map(|line| decode(line.text)).collect();
        if let Some((said, _)) = labview {
            said.name_units(&mut headings);
            preamble.extend(said.step());
        }
        Ok(Layout {
            separator: look.separator,
            decimal: look.decimal,
            end,
            least: least.min(headings.len()),
            headings,
            header,
            preamble,
            start: row.start,
            line: row.number,
        })
    }

    /// Where the first lines hold integers only, the first decimal sign below them decides.
    fn settle_decimal(&mut self, text: &mut Text) -> Result<(), ReadError> {
        if matches!(self.separator, Separator::Comma) || self.decimal == Decimal::Comma {
            return Ok(());
        }
        let mut lines = text.lines(self.end, self.start as u64)?;
        // A line too long to be read is refused when the rows are.
        while let Block::Lines(block) = lines.next()? {
            match decimal_sign(block) {
                Some(b',') => self.decimal = Decimal::Comma,
                Some(_) => {}
                None => {
                    let read = block.len();
                    lines.consume(read);
                    continue;
                }
            }
            break;
        }
        Ok(())
    }
}

/// The first sign within a number: a digit before it and behind it.
fn decimal_sign(rows: &[u8]) -> Option<u8> {
    let within = |at: &usize| {
        let digit =
            |at: Option<usize>| at.and_then(|at| rows.get(at)).is_some_and(u8::is_ascii_digit);
        digit(at.checked_sub(1)) && digit(at.checked_add(1))
    };
    memchr2_iter(b'.', b',', rows).find(within).map(|at| rows[at])
}

/// The look with most numbers, of those with this separator if it is known.
fn best_look(sample: &[Line], known: Option<Separator>) -> Look {
    let mut best = Look::new(sample, known.unwrap_or(Separator::Tab), Decimal::Point);
    for separator in
        Separator::ALL.into_iter().filter(|one| known.is_none_or(|known| known == *one))
    {
        for decimal in [Decimal::Point, Decimal::Comma] {
            let look = Look::new(sample, separator, decimal);
            if look.score > best.score {
                best = look;
            }
        }
    }
    best
}

/// Text without rows of numbers: a header alone, or prose.
fn without_rows(top: &Line, sample: &[Line]) -> ReadError {
    for line in sample {
        for separator in Separator::ALL {
            let cells: Vec<String> = Cells::new(line.text, separator).map(decode).collect();
            if cells.len() > 1
                && cells.iter().any(|cell| Heading::parse(cell).is_time())
                && sample.len() == 1
            {
                return ReadError::NoRows { line: line.number, header: excerpt(line.text) };
            }
        }
    }
    ReadError::NoTable { found: Found::Prose, line: top.number, text: excerpt(top.text) }
}
