//! How much each column oscillates, from rows spread over the whole file.

use super::blocks::{Block, Blocks};
use super::error::ReadError;
use super::layout::Layout;
use super::line::{Cells, Line, Lines};
use super::number::{self, Cell};
use super::text::Text;

/// Bytes that are looked at as a whole; of larger tables [`BLOCKS`] are, of [`BLOCK`] bytes each.
const WHOLE: u64 = 1 << 21;
const BLOCKS: u64 = 128;
const BLOCK: u64 = 1 << 14;

/// What a sample says of a column: running sums for a straight line through it, since what drifts does not oscillate.
#[derive(Debug, Clone, Default)]
pub(super) struct Size {
    numbers: usize,
    texts: usize,
    /// Numbers with their digits in groups, which are refused where they are read.
    grouped: usize,
    /// Texts that are times of day.
    clocks: usize,
    falls: usize,
    last: Option<f64>,
    mean_at: f64,
    mean: f64,
    square_at: f64,
    product: f64,
    square: f64,
}

impl Size {
    fn add(&mut self, at: f64, value: f64) {
        self.numbers += 1;
        self.falls += usize::from(self.last.is_some_and(|last| value < last));
        self.last = Some(value);
        let share = 1.0 / self.numbers as f64;
        let (from_at, from) = (at - self.mean_at, value - self.mean);
        self.mean_at += from_at * share;
        self.mean += from * share;
        self.square_at += from_at * (at - self.mean_at);
        self.product += from_at * (value - self.mean);
        self.square += from * (value - self.mean);
    }

    /// Whether the column holds numbers rather than words.
    pub fn is_numeric(&self) -> bool {
        let numbers = self.numbers + self.grouped;
        numbers > 0 && numbers >= self.texts
    }

    /// Whether the column holds any words.
    pub fn has_texts(&self) -> bool {
        self.texts > 0
    }

    /// Whether the column holds times of day.
    pub fn is_clock(&self) -> bool {
        !self.is_numeric() && self.clocks * 2 > self.texts
    }

    /// Whether it rises as times do: hardly ever back, and from somewhere to elsewhere.
    pub fn rises(&self) -> bool {
        self.is_numeric()
            && self.falls * 100 <= self.numbers
            && self.square > 0.0
            && self.product > 0.0
    }

    /// Root mean square about a straight line.
    pub fn oscillation(&self) -> f64 {
        let drift =
            if self.square_at > 0.0 { self.product * self.product / self.square_at } else { 0.0 };
        let square = (self.square - drift) / self.numbers.max(1) as f64;
        if square > 0.0 { square.sqrt() } else { 0.0 }
    }
}

/// The sizes of all columns.
pub(super) fn sizes(text: &mut Text, layout: &Layout) -> Result<Vec<Size>, ReadError> {
    let start = layout.start as u64;
    let rows = text.length()?.saturating_sub(start);
    let mut lines = text.lines(layout.end, start)?;
    let mut sizes = vec![Size::default(); layout.headings.len()];
    if rows <= WHOLE {
        look(&mut lines, layout, WHOLE, &mut sizes)?;
        return Ok(sizes);
    }
    for block in 0..BLOCKS {
        let from = start + rows / BLOCKS * block;
        if from > lines.at() {
            lines.skip_to(from)?;
            lines.skip_line()?;
        }
        look(&mut lines, layout, BLOCK, &mut sizes)?;
    }
    Ok(sizes)
}

/// Looks at the lines that begin within so many bytes; a line too long to be read ends them.
fn look(
    lines: &mut Blocks,
    layout: &Layout,
    bytes: u64,
    sizes: &mut [Size],
) -> Result<(), ReadError> {
    let end = lines.at() + bytes;
    while lines.at() < end {
        let at = lines.at();
        let Block::Lines(block) = lines.next()? else { break };
        let mut seen = block.len();
        for line in Lines::new(block, layout.end, 0, 1) {
            let start = at + line.start as u64;
            if start >= end {
                seen = line.start;
                break;
            }
            if !line.is_comment() {
                add(&line, start as f64, layout, sizes);
            }
        }
        lines.consume(seen);
    }
    Ok(())
}

fn add(line: &Line, at: f64, layout: &Layout, sizes: &mut [Size]) {
    for (size, cell) in sizes.iter_mut().zip(Cells::new(line.text, layout.separator)) {
        match number::read(cell, layout.decimal) {
            Cell::Number(value) if value.is_finite() => size.add(at, value),
            Cell::Text if number::is_grouped(cell, layout.decimal) => size.grouped += 1,
            Cell::Text => {
                size.texts += 1;
                size.clocks += usize::from(number::clock(cell).is_some());
            }
            _ => {}
        }
    }
}
