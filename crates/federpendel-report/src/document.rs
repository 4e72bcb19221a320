//! A report as a person reads it from top to bottom, without a word of how it is laid out.
//!
//! Texts may hold formulas between dollar signs, in the notation of TeX: `the offset $f$`. A dollar sign that is none
//! has a backslash before it, as [`literal`] puts it.

use std::collections::BTreeSet;

use federpendel_text::plot::Plot;

/// What somebody else wrote, a file's name or a heading of its columns, as a text that means just that.
pub fn literal(text: &str) -> String {
    text.replace('$', r"\$")
}

/// A report.
#[derive(Debug, Clone)]
pub struct Document {
    /// Its title.
    pub title: String,
    /// What it is about, in a sentence or a few, below the title.
    pub lead: Vec<Block>,
    /// Its sections in order.
    pub sections: Vec<Section>,
    /// What made it, and of what; the last line.
    pub colophon: String,
}

impl Document {
    /// Keeps of all claims those with these numbers, and of all sections those that hold one; the first section, which
    /// says what the report is about, stays.
    pub fn keep_claims(&mut self, numbers: &BTreeSet<usize>) {
        let about = self.sections.first().map(|section| section.id.clone());
        self.sections.retain_mut(|section| {
            section.keep_claims(numbers) || Some(&section.id) == about.as_ref()
        });
    }
}

impl Section {
    /// Whether there is anything left.
    fn keep_claims(&mut self, numbers: &BTreeSet<usize>) -> bool {
        for block in &mut self.blocks {
            if let Block::Claims(claims) = block {
                claims.retain(|claim| numbers.contains(&claim.number));
            }
        }
        self.blocks.retain(|block| !matches!(block, Block::Claims(claims) if claims.is_empty()));
        self.sections.retain_mut(|section| section.keep_claims(numbers));
        let holds_one = self.blocks.iter().any(|block| matches!(block, Block::Claims(_)));
        holds_one || !self.sections.is_empty()
    }
}

/// A section with what it says and its subsections.
#[derive(Debug, Clone)]
pub struct Section {
    /// Name by which it is linked; letters, digits and hyphens.
    pub id: String,
    /// Its heading.
    pub heading: String,
    /// What stands in it before its subsections.
    pub blocks: Vec<Block>,
    /// Its subsections.
    pub sections: Vec<Section>,
}

/// A piece of a section.
#[derive(Debug, Clone)]
pub enum Block {
    /// A paragraph.
    Paragraph(String),
    /// Points, one below the other.
    List(Vec<String>),
    /// What the reader should not overlook, set apart.
    Notice(String),
    /// A formula on a line of its own, in the notation of TeX.
    Formula {
        /// Its number in the article, with brackets: “(68)”.
        number: Option<String>,
        /// The formula.
        tex: String,
    },
    /// Plots one below the other, with one caption.
    Figure {
        /// Name by which it is linked.
        id: String,
        /// What is drawn.
        plots: Vec<Plot>,
        /// What it shows.
        caption: String,
    },
    /// A drawing that is no plot.
    Sketch {
        /// Name by which it is linked.
        id: String,
        /// An SVG element with its title and description.
        svg: String,
        /// What it shows.
        caption: String,
    },
    /// A table.
    Table {
        /// What it holds.
        caption: String,
        /// Headings of the columns.
        head: Vec<String>,
        /// Its rows.
        rows: Vec<Row>,
    },
    /// Claims with what was found of them.
    Claims(Vec<Claim>),
}

/// A row of a table.
#[derive(Debug, Clone)]
pub struct Row {
    /// Its cells; the first one names the row.
    pub cells: Vec<String>,
    /// Name of what the first cell leads to, if it leads anywhere.
    pub target: Option<String>,
    /// Whether it stands out among the others.
    pub marked: bool,
    /// What is said of the row below its cells, over the whole width; empty if nothing.
    pub below: String,
}

impl From<Vec<String>> for Row {
    fn from(cells: Vec<String>) -> Self {
        Row { cells, target: None, marked: false, below: String::new() }
    }
}

/// A claim, what was computed, and what that says of it.
#[derive(Debug, Clone)]
pub struct Claim {
    /// Its number in the report.
    pub number: usize,
    /// Name by which it is linked, and which files use.
    pub id: String,
    /// The equation of the article it belongs to, with brackets: “(68)”.
    pub equation: String,
    /// What is claimed.
    pub claim: String,
    /// Whether it is said in so many words.
    pub stated: bool,
    /// What was computed, a value a line.
    pub computed: Vec<String>,
    /// What should have come out if the claim were right, a value a line.
    pub expected: Vec<String>,
    /// The verdict; a worksheet leaves it blank.
    pub verdict: Option<Verdict>,
    /// What was found, in a sentence or two; a worksheet leaves it blank.
    pub finding: Option<String>,
}

/// What a computation says of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// It is right.
    Holds,
    /// It is wrong.
    Fails,
    /// It is wrong in general, but right in number for this experiment.
    HoldsHere,
    /// This experiment cannot tell.
    NotApplicable,
}

impl Verdict {
    /// All of them.
    pub const ALL: [Verdict; 4] =
        [Verdict::Holds, Verdict::Fails, Verdict::HoldsHere, Verdict::NotApplicable];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Fails => "fails",
            Verdict::HoldsHere => "holds-here",
            Verdict::NotApplicable => "not-applicable",
        }
    }
}
