//! A canvas of braille characters: two by four dots in each cell of a terminal.

use crate::plot::{Dash, Role};

/// A cell: its dots, or a character of its own that lies above them, and whose colour it has.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Cell {
    dots: u8,
    above: Option<char>,
    pub role: Option<Role>,
}

impl Cell {
    /// What the terminal shows in this cell.
    pub fn character(self) -> char {
        let braille = char::from_u32(0x2800 + u32::from(self.dots)).unwrap_or(' ');
        self.above.unwrap_or(if self.dots == 0 { ' ' } else { braille })
    }
}

/// A grid of cells; dots are counted from the upper left corner.
pub(super) struct Canvas {
    pub columns: usize,
    pub rows: usize,
    cells: Vec<Cell>,
}

impl Canvas {
    pub fn new(columns: usize, rows: usize) -> Self {
        Self { columns, rows, cells: vec![Cell::default(); columns * rows] }
    }

    /// Number of dots across.
    pub fn width(&self) -> i64 {
        2 * self.columns as i64
    }

    /// Number of dots down.
    pub fn height(&self) -> i64 {
        4 * self.rows as i64
    }

    pub fn row(&self, row: usize) -> &[Cell] {
        &self.cells[row * self.columns..(row + 1) * self.columns]
    }

    /// Sets one dot; the cell takes the colour of the last dot in it.
    pub fn dot(&mut self, x: i64, y: i64, role: Option<Role>) {
        const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
        if let Some(cell) = self.cell(x, y) {
            cell.dots |= BITS[(y % 4) as usize][(x % 2) as usize];
            cell.role = role.or(cell.role);
        }
    }

    /// Puts a character over the cell that holds a dot.
    pub fn put(&mut self, x: i64, y: i64, character: char, role: Role) {
        if let Some(cell) = self.cell(x, y) {
            cell.above = Some(character);
            cell.role = Some(role);
        }
    }

    /// Whether a character has been put over the cell that holds a dot.
    pub fn has_sign(&mut self, x: i64, y: i64) -> bool {
        self.cell(x, y).is_some_and(|cell| cell.above.is_some())
    }

    /// A line between two dots.
    pub fn line(&mut self, from: (i64, i64), to: (i64, i64), dash: Dash, role: Role) {
        let steps = (to.0 - from.0).abs().max((to.1 - from.1).abs());
        for step in 0..=steps {
            let along = |from: i64, to: i64| {
                let fraction = if steps == 0 { 0.0 } else { step as f64 / steps as f64 };
                from + ((to - from) as f64 * fraction).round() as i64
            };
            let (x, y) = (along(from.0, to.0), along(from.1, to.1));
            let shown = match dash {
                Dash::Solid => true,
                Dash::Dashed => x.rem_euclid(6) < 3,
                Dash::LongDashed => x.rem_euclid(9) < 6,
                Dash::Dotted => x.rem_euclid(4) < 1,
            };
            if shown {
                self.dot(x, y, Some(role));
            }
        }
    }

    /// A line through `points` as a character in one of `every` so many cells that it meets: dots would
    /// be lost among those of a curve that it follows.
    pub fn beads(&mut self, points: &[(i64, i64)], character: char, every: usize, role: Role) {
        let mut met = Vec::new();
        for pair in points.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let steps = (to.0 - from.0).abs().max((to.1 - from.1).abs());
            for step in 0..=steps {
                let along = |from: i64, to: i64| from + (to - from) * step / steps.max(1);
                let dot = (along(from.0, to.0), along(from.1, to.1));
                let cell = (dot.0.div_euclid(2), dot.1.div_euclid(4));
                if met.last().is_none_or(|(last, _)| *last != cell) {
                    met.push((cell, dot));
                }
            }
        }
        for (_, dot) in met.iter().step_by(every) {
            self.put(dot.0, dot.1, character, role);
        }
    }

    fn cell(&mut self, x: i64, y: i64) -> Option<&mut Cell> {
        let inside = (0..self.width()).contains(&x) && (0..self.height()).contains(&y);
        inside.then(|| &mut self.cells[(y / 4) as usize * self.columns + (x / 2) as usize])
    }
}
