//! A program's samples: a table of times, positions and perhaps velocities.

/// Most bytes of a table that are read.
pub(crate) const LARGEST_FILE: usize = 1 << 28;

/// Numbers beyond this, either way, are a solver's explosion, and their squares would overflow.
pub(crate) const LARGEST_NUMBER: f64 = 1e100;

/// What a table is read for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Column {
    /// Time, s.
    Time,
    /// Position, m.
    Position,
    /// Velocity, m/s.
    Velocity,
}

impl Column {
    /// The name of this column, its short name, and its unit.
    fn words(self) -> [&'static str; 3] {
        match self {
            Column::Time => ["time", "t", "s"],
            Column::Position => ["position", "x", "m"],
            Column::Velocity => ["velocity", "v", "m/s"],
        }
    }

    /// Its name, and the other one it may have.
    pub(crate) fn names(self) -> (&'static str, &'static str) {
        let [name, short, _] = self.words();
        (name, short)
    }

    /// The unit of its numbers.
    pub(crate) fn unit(self) -> &'static str {
        self.words()[2]
    }
}

/// Why a table is refused. Lines count from 1.
#[derive(Debug, PartialEq)]
pub(crate) enum Fault {
    /// More than [`LARGEST_FILE`] bytes.
    TooLarge,
    /// Something that is not UTF-8 in this line.
    NotUtf8 { line: usize },
    /// Nothing at all.
    Empty,
    /// A header and nothing below it.
    NoRows,
    /// The header lacks a column that must be there.
    Missing { line: usize, header: String, column: Column },
    /// The header has a column twice.
    Twice { line: usize, column: Column },
    /// The header gives a column another unit.
    Unit { line: usize, column: Column, unit: String },
    /// A row with more or fewer cells than the header.
    Cells { line: usize, found: usize, expected: usize },
    /// A cell that is no number.
    NoNumber { line: usize, column: Column, value: String },
    /// NaN, infinite or beyond [`LARGEST_NUMBER`].
    NotFinite { line: usize, column: Column, value: String },
    /// A time before the release.
    Negative { line: usize, value: String },
}

/// The samples of a program, as they stand in its file.
#[derive(Debug, PartialEq)]
pub(crate) struct Samples {
    /// Times, s, in any order.
    pub times: Vec<f64>,
    /// Positions, m.
    pub positions: Vec<f64>,
    /// Velocities, m/s, if there is a column of them.
    pub velocities: Option<Vec<f64>>,
}

/// How cells stand in the lines of a table.
#[derive(Clone, Copy)]
struct Cells {
    separator: char,
}

impl Cells {
    /// Semicolons if the header has any: then numbers may have decimal commas.
    fn of(header: &str) -> Self {
        Cells { separator: if header.contains(';') { ';' } else { ',' } }
    }

    fn split(self, line: &str) -> impl Iterator<Item = &str> {
        line.split(self.separator).map(|cell| cell.trim().trim_matches('"').trim())
    }

    fn number(self, cell: &str) -> Option<f64> {
        let plain = cell.replace('\u{2212}', "-");
        if self.separator == ';' && !plain.contains('.') {
            return plain.replace(',', ".").parse().ok();
        }
        plain.parse().ok()
    }
}

impl Samples {
    /// Reads a table.
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, Fault> {
        if bytes.len() > LARGEST_FILE {
            return Err(Fault::TooLarge);
        }
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let newlines = bytes[..error.valid_up_to()].iter().filter(|byte| **byte == b'\n');
            Fault::NotUtf8 { line: 1 + newlines.count() }
        })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut lines = text.lines().enumerate().map(|(at, line)| (at + 1, line));
        let mut filled = lines.by_ref().filter(|(_, line)| !line.trim().is_empty());
        let (line, header) = filled.next().ok_or(Fault::Empty)?;
        let layout = Layout::of(line, header)?;
        let velocities = layout.velocity.is_some().then(Vec::new);
        let mut samples = Samples { times: Vec::new(), positions: Vec::new(), velocities };
        for (line, row) in filled {
            layout.read(line, row, &mut samples)?;
        }
        if samples.times.is_empty() { Err(Fault::NoRows) } else { Ok(samples) }
    }
}

/// Where the columns are.
struct Layout {
    cells: Cells,
    width: usize,
    time: usize,
    position: usize,
    velocity: Option<usize>,
}

impl Layout {
    fn of(line: usize, header: &str) -> Result<Self, Fault> {
        // NumPy begins a header with the sign of a comment.
        let header = header.trim().trim_start_matches('#').trim();
        let cells = Cells::of(header);
        let names: Vec<(String, Option<String>)> = cells.split(header).map(name_and_unit).collect();
        let place = |column: Column| {
            let (name, short) = column.names();
            let mut places = names.iter().enumerate().filter(|(_, (n, _))| n == name || n == short);
            let found = places.next();
            if places.next().is_some() {
                return Err(Fault::Twice { line, column });
            }
            match found {
                Some((_, (_, Some(unit)))) if unit != column.unit() => {
                    Err(Fault::Unit { line, column, unit: unit.clone() })
                }
                found => Ok(found.map(|(at, _)| at)),
            }
        };
        let missing = |column| Fault::Missing { line, header: header.to_owned(), column };
        Ok(Layout {
            cells,
            width: names.len(),
            time: place(Column::Time)?.ok_or_else(|| missing(Column::Time))?,
            position: place(Column::Position)?.ok_or_else(|| missing(Column::Position))?,
            velocity: place(Column::Velocity)?,
        })
    }

    /// Reads a row into `samples`.
    fn read(&self, line: usize, row: &str, samples: &mut Samples) -> Result<(), Fault> {
        let cells: Vec<&str> = self.cells.split(row).collect();
        if cells.len() != self.width {
            return Err(Fault::Cells { line, found: cells.len(), expected: self.width });
        }
        let number = |at: usize, column| {
            let value = || cells[at].to_owned();
            match self.cells.number(cells[at]) {
                None => Err(Fault::NoNumber { line, column, value: value() }),
                // Adding zero turns −0 into 0.
                Some(number) if number.abs() <= LARGEST_NUMBER => Ok(number + 0.0),
                Some(_) => Err(Fault::NotFinite { line, column, value: value() }),
            }
        };
        let time = number(self.time, Column::Time)?;
        if time < 0.0 {
            return Err(Fault::Negative { line, value: cells[self.time].to_owned() });
        }
        samples.times.push(time);
        samples.positions.push(number(self.position, Column::Position)?);
        if let (Some(at), Some(velocities)) = (self.velocity, &mut samples.velocities) {
            velocities.push(number(at, Column::Velocity)?);
        }
        Ok(())
    }
}

/// `Velocity (m/s)` as `velocity` and `m/s`.
fn name_and_unit(cell: &str) -> (String, Option<String>) {
    let lower = |text: &str| text.trim().to_lowercase();
    match cell.strip_suffix(')').and_then(|cell| cell.split_once('(')) {
        Some((name, unit)) => (lower(name), Some(unit.trim().to_owned())),
        None => (lower(cell), None),
    }
}
