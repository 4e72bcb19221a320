//! The tables of a Markdown file.

/// Heading of the first column in the tables of equations.
const EQUATION: &str = "equation";

/// Heading of the column that says where something is.
const CODE: &str = "in the code";

pub struct Table {
    pub rows: Vec<Row>,
    headings: Vec<String>,
}

pub struct Row {
    /// Its line in the file.
    pub line: usize,
    cells: Vec<String>,
    /// Which of the cells says where it is in the code.
    code: usize,
}

/// All tables, with a panic that names the line of one that is not understood.
pub fn read(text: &str) -> Vec<Table> {
    let mut tables: Vec<Table> = Vec::new();
    let mut within = false;
    for (line, content) in (1..).zip(text.lines()) {
        if !content.starts_with('|') {
            within = false;
            continue;
        }
        let cells: Vec<String> =
            content.trim().trim_matches('|').split('|').map(|cell| cell.trim().into()).collect();
        match tables.last_mut().filter(|_| within) {
            None => tables.push(Table { rows: Vec::new(), headings: cells }),
            Some(_) if cells.iter().all(|cell| cell.starts_with("---")) => {}
            Some(table) => table.add(line, cells),
        }
        within = true;
    }
    tables
}

impl Table {
    pub fn is_of_equations(&self) -> bool {
        self.headings[0] == EQUATION
    }

    fn add(&mut self, line: usize, cells: Vec<String>) {
        let code = self.headings.iter().position(|heading| heading == CODE);
        let code = code.unwrap_or_else(|| panic!("line {line}: no column “{CODE}”"));
        let (found, expected) = (cells.len(), self.headings.len());
        assert_eq!(found, expected, "line {line}: cells in the row, and in its headings");
        self.rows.push(Row { line, cells, code });
    }
}

impl Row {
    /// The numbers in the first column: “(1), (2)” and “(4)–(7)”.
    pub fn equations(&self) -> Vec<u32> {
        let number = |text: &str| -> u32 {
            let inner = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
            let number = inner.and_then(|inner| inner.parse().ok());
            number.unwrap_or_else(|| panic!("line {}: {text:?} is no equation", self.line))
        };
        let range = |part: &str| match part.split_once('–') {
            Some((first, last)) => number(first)..=number(last),
            None => number(part)..=number(part),
        };
        self.cells[0].split(", ").flat_map(range).collect()
    }

    /// What stands between backticks in the whole row.
    pub fn names(&self) -> Vec<&str> {
        self.cells.iter().flat_map(|cell| quoted(cell)).collect()
    }

    /// What stands between backticks in the column of the code.
    pub fn code_names(&self) -> Vec<&str> {
        quoted(&self.cells[self.code]).collect()
    }
}

fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}
