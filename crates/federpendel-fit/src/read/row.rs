//! The rows of a table: numbers of the columns that are kept, and of no others.

use super::blocks::{Block, LONGEST_LINE};
use super::column::Run;
use super::error::ReadError;
use super::layout::Layout;
use super::line::{Cells, Line, Lines, excerpt};
use super::number::{self, Cell};
use super::text::Text;
use super::times::Times;
use super::unit::Unit;
use super::{LARGEST_NUMBER, Rows};

/// The rows of a run, as they stand in the file.
#[derive(Debug)]
pub(super) struct Kept {
    pub run: Run,
    /// s.
    pub times: Vec<f64>,
    pub values: Vec<f64>,
    pub lines: LineNumbers,
    /// Rows that lack the time or the value, before the last that has both.
    pub missing: Option<Rows>,
    /// The last line, if it ends before its cells do.
    pub cut_off: Option<usize>,
    /// The first time of day, and the last; s.
    clock: Option<(f64, f64)>,
    /// Rows met, for times at a rate.
    rows: usize,
    /// Rows that lack something, since the last that does not.
    pending: Option<Rows>,
}

/// The lines of rows: only where they do not follow each other is anything kept.
#[derive(Debug, Default)]
pub(super) struct LineNumbers {
    /// A row and its line, where the line before belongs to no row.
    breaks: Vec<(usize, usize)>,
}

impl LineNumbers {
    fn push(&mut self, row: usize, line: usize) {
        let follows = self.breaks.last().is_some_and(|(r, l)| row - r == line - l);
        if !follows {
            self.breaks.push((row, line));
        }
    }

    /// Takes away what is said of rows from this one on.
    fn split_off(&mut self, row: usize) -> Self {
        let mut rest = LineNumbers { breaks: vec![(0, self.of(row))] };
        let at = self.breaks.partition_point(|(first, _)| *first <= row);
        rest.breaks.extend(self.breaks.drain(at..).map(|(first, line)| (first - row, line)));
        rest
    }

    /// The line of a row.
    pub fn of(&self, row: usize) -> usize {
        let at = self.breaks.partition_point(|(first, _)| *first <= row);
        at.checked_sub(1).map_or(0, |at| self.breaks[at].1 + row - self.breaks[at].0)
    }
}

/// Reads all rows.
pub(super) fn read(
    text: &mut Text,
    layout: &Layout,
    runs: Vec<Run>,
) -> Result<Vec<Kept>, ReadError> {
    let mut kept: Vec<Kept> = runs.into_iter().map(Kept::new).collect();
    let reader = Reader { layout, several: kept.len() > 1 };
    let mut lines = text.lines(layout.end, layout.start as u64)?;
    let mut number = layout.line;
    loop {
        let block = match lines.next()? {
            Block::Lines(block) => block,
            Block::LongLine => {
                return Err(ReadError::LongLine { line: number, most: LONGEST_LINE });
            }
            Block::End => return Ok(kept),
        };
        number = reader.rows(block, number, &mut kept)?;
        let read = block.len();
        lines.consume(read);
    }
}

struct Reader<'a> {
    layout: &'a Layout,
    several: bool,
}

enum Row {
    /// A comment, or blank.
    None,
    /// Too few cells, and the file ends there.
    CutOff,
    Whole,
}

impl Reader<'_> {
    /// Reads some lines, of which the first has this number; returns that of the line behind them.
    fn rows(&self, block: &[u8], number: usize, kept: &mut [Kept]) -> Result<usize, ReadError> {
        let mut cells = Vec::with_capacity(self.layout.headings.len() + 1);
        let mut next = number;
        for line in Lines::new(block, self.layout.end, 0, number) {
            next = line.number + 1;
            cells.clear();
            cells.extend(Cells::new(line.text, self.layout.separator));
            match self.fit(&line, &mut cells)? {
                Row::None => continue,
                Row::CutOff => kept.iter_mut().for_each(|kept| kept.cut_off = Some(line.number)),
                Row::Whole => {
                    for kept in &mut *kept {
                        kept.take(self, line.number, &cells)?;
                    }
                }
            }
        }
        Ok(next)
    }

    /// Holds the cells of a line against the columns. Empty cells may follow; of runs side by side the shorter may end.
    #[inline]
    fn fit(&self, line: &Line, cells: &mut Vec<&[u8]>) -> Result<Row, ReadError> {
        let width = self.layout.headings.len();
        let begins_like_comment =
            matches!(line.text.trim_ascii_start(), [b'#' | b'%' | b'/', ..] | []);
        if cells.len() == width && !begins_like_comment {
            return Ok(Row::Whole);
        }
        if line.is_blank() || line.is_comment() {
            return Ok(Row::None);
        }
        let found = cells.len();
        if found > width && cells[width..].iter().all(|cell| cell.is_empty()) {
            cells.truncate(width);
        } else if found < self.layout.least && !line.ended {
            return Ok(Row::CutOff);
        } else if found < width && (self.several || found >= self.layout.least) {
            cells.resize(width, b"");
        } else if found != width {
            return Err(ReadError::Cells { line: line.number, found, expected: width });
        }
        Ok(Row::Whole)
    }

    #[inline]
    fn number(&self, line: usize, cells: &[&[u8]], at: usize) -> Result<Option<f64>, ReadError> {
        let cell = cells.get(at).copied().unwrap_or_default();
        match number::read(cell, self.layout.decimal) {
            Cell::Number(number) if number.abs() <= LARGEST_NUMBER => Ok(Some(number)),
            Cell::Missing => Ok(None),
            other => Err(self.refuse(line, cell, at, other)),
        }
    }

    fn clock(&self, line: usize, cells: &[&[u8]], at: usize) -> Result<Option<f64>, ReadError> {
        let cell = cells.get(at).copied().unwrap_or_default();
        match (number::clock(cell), number::read(cell, self.layout.decimal)) {
            (Some(time), _) => Ok(Some(time)),
            (None, Cell::Missing) => Ok(None),
            (None, _) => Err(self.refuse(line, cell, at, Cell::Text)),
        }
    }

    #[cold]
    fn refuse(&self, line: usize, cell: &[u8], at: usize, read: Cell) -> ReadError {
        let (column, value) = (self.layout.headings[at].label.clone(), excerpt(cell));
        match read {
            Cell::Number(_) => ReadError::OutOfRange { line, column, value, most: LARGEST_NUMBER },
            _ => {
                let decimal = self.layout.decimal;
                ReadError::NoNumber { line, column, value, decimal }
            }
        }
    }
}

impl Kept {
    fn new(run: Run) -> Self {
        Kept {
            run,
            times: Vec::new(),
            values: Vec::new(),
            lines: LineNumbers::default(),
            missing: None,
            cut_off: None,
            clock: None,
            rows: 0,
            pending: None,
        }
    }

    /// The time since the first time of day: of the days that it may be of, the one next to the last.
    fn elapsed(&mut self, time: f64) -> f64 {
        const DAY: f64 = 86_400.0;
        let (first, last) = self.clock.unwrap_or((time, time));
        let time = time + DAY * ((last - time) / DAY).round();
        self.clock = Some((first, time));
        time - first
    }

    /// Takes away the rows from this one on, a run of their own.
    pub fn split_off(&mut self, row: usize) -> Self {
        let lines = self.lines.split_off(row);
        let below = |rows: &mut Rows| rows.first_line >= lines.of(0);
        let (times, values) = (self.times.split_off(row), self.values.split_off(row));
        // Their room is given back, else every run would hold that of all behind it.
        self.times.shrink_to_fit();
        self.values.shrink_to_fit();
        Kept {
            run: self.run.clone(),
            times,
            values,
            missing: self.missing.take_if(below),
            lines,
            cut_off: self.cut_off.take(),
            clock: None,
            rows: self.rows,
            pending: None,
        }
    }

    #[inline]
    fn take(&mut self, reader: &Reader, line: usize, cells: &[&[u8]]) -> Result<(), ReadError> {
        let time = match self.run.times {
            Times::Column(at, unit) => reader.number(line, cells, at)?.map(|time| unit.to_si(time)),
            Times::Clock(at) => reader.clock(line, cells, at)?.map(|time| self.elapsed(time)),
            Times::Rate(rate) => Some(self.rows as f64 / rate),
        };
        self.rows += 1;
        let value = reader.number(line, cells, self.run.value)?;
        let (Some(time), Some(value)) = (time, value) else {
            Rows::count(&mut self.pending, line, 1);
            return Ok(());
        };
        if let Some(pending) = self.pending.take() {
            Rows::count(&mut self.missing, pending.first_line, pending.count);
        }
        self.lines.push(self.times.len(), line);
        self.times.push(time);
        self.values.push(self.run.unit.map_or(value, |unit: Unit| unit.to_si(value)));
        Ok(())
    }
}
