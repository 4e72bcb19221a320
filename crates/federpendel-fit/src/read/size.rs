//! How much each column oscillates, from rows spread over the whole file.

use super::layout::Layout;
use super::line::{Cells, Lines};
use super::number::{self, Cell};

/// Bytes that are looked at as a whole; of larger tables [`BLOCKS`] are, of [`BLOCK`] bytes each.
const WHOLE: usize = 1 << 21;
const BLOCKS: usize = 128;
const BLOCK: usize = 1 << 14;

/// What a sample says of a column: running sums for a straight line through it, since what drifts does not oscillate.
#[derive(Debug, Clone, Default)]
pub(super) struct Size {
    numbers: usize,
    texts: usize,
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
        self.numbers > 0 && self.numbers >= self.texts
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
pub(super) fn sizes(text: &[u8], layout: &Layout) -> Vec<Size> {
    let mut sizes = vec![Size::default(); layout.headings.len()];
    let rows = text.len() - layout.start;
    if rows <= WHOLE {
        look(text, layout, layout.start..text.len(), &mut sizes);
        return sizes;
    }
    for block in 0..BLOCKS {
        let from = layout.start + rows / BLOCKS * block;
        // On to the next line.
        let from = match memchr::memchr(layout.end, &text[from..]) {
            Some(at) if block > 0 => from + at + 1,
            _ => from,
        };
        look(text, layout, from..(from + BLOCK).min(text.len()), &mut sizes);
    }
    sizes
}

fn look(text: &[u8], layout: &Layout, range: std::ops::Range<usize>, sizes: &mut [Size]) {
    let lines = Lines::new(text, layout.end, range.start, 1);
    for line in lines.take_while(|line| line.start < range.end).filter(|line| !line.is_comment()) {
        for (size, cell) in sizes.iter_mut().zip(Cells::new(line.text, layout.separator)) {
            match number::read(cell, layout.decimal) {
                Cell::Number(value) if value.is_finite() => size.add(line.start as f64, value),
                Cell::Text => {
                    size.texts += 1;
                    size.clocks += usize::from(number::clock(cell).is_some());
                }
                _ => {}
            }
        }
    }
}
