//! A document as the template sees it: figures and tables numbered, and every text turned into HTML.

use federpendel_text::Catalogue;
use minijinja::Value;
use serde::Serialize;

use super::PageError;
use super::drawing::{self, Palettes};
use super::math::{Html, Typesetter};
use super::words::{Mark, Words};
use crate::{Block, Claim, Document, Row, Section, Verdict};

/// A table of more rows than these may go on on the next sheet of paper.
const LONG: usize = 12;

/// A name of so many letters is not torn.
const SHORT: usize = 20;

/// The whole page.
#[derive(Serialize)]
pub struct View {
    language: &'static str,
    style: Html,
    palettes: Palettes,
    words: Words,
    verdicts: Vec<Mark>,
    /// Whether the reader has something to fill in.
    worksheet: bool,
    name: Html,
    title: Html,
    lead: Vec<Piece>,
    sections: Vec<Part>,
    colophon: Html,
}

/// A section.
#[derive(Serialize)]
struct Part {
    id: String,
    level: usize,
    heading: Html,
    blocks: Vec<Piece>,
    sections: Vec<Part>,
}

/// A block.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
enum Piece {
    Paragraph {
        text: Html,
    },
    List {
        points: Vec<Html>,
    },
    Notice {
        text: Html,
    },
    Formula {
        number: Option<String>,
        math: Html,
    },
    Figure {
        id: String,
        label: String,
        caption: Html,
        drawings: Vec<Html>,
        sketch: bool,
    },
    Table {
        id: String,
        label: String,
        caption: Html,
        head: Vec<Html>,
        rows: Vec<Line>,
        columns: usize,
        long: bool,
    },
    Claims {
        claims: Vec<Assertion>,
    },
}

/// A row of a table.
#[derive(Serialize)]
struct Line {
    target: Option<String>,
    marked: bool,
    cells: Vec<Html>,
    below: Html,
}

/// A claim.
#[derive(Serialize)]
struct Assertion {
    number: usize,
    id: String,
    equation: String,
    claim: Html,
    stated: bool,
    computed: Vec<Html>,
    expected: Vec<Html>,
    verdict: Option<Mark>,
    finding: Option<Html>,
}

impl View {
    pub fn of(document: &Document, catalogue: &Catalogue) -> Result<Self, PageError> {
        let mut writer = Writer { catalogue, set: Typesetter::new()?, figures: 0, tables: 0 };
        Ok(Self {
            language: catalogue.language().tag(),
            style: Value::from_safe_string(include_str!("../../templates/style.css").to_owned()),
            palettes: Palettes::new(),
            words: Words::of(catalogue),
            verdicts: Verdict::ALL.map(|verdict| Mark::of(verdict, catalogue)).into(),
            worksheet: has_blanks(&document.lead) || document.sections.iter().any(is_worksheet),
            name: writer.set.plain(&document.title)?,
            title: writer.set.text(&document.title)?,
            lead: writer.pieces(&document.lead)?,
            sections: writer.parts(&document.sections, 2)?,
            colophon: writer.set.text(&document.colophon)?,
        })
    }
}

fn is_worksheet(section: &Section) -> bool {
    has_blanks(&section.blocks) || section.sections.iter().any(is_worksheet)
}

fn has_blanks(blocks: &[Block]) -> bool {
    let blank = |claim: &Claim| claim.verdict.is_none();
    blocks.iter().any(|block| matches!(block, Block::Claims(claims) if claims.iter().any(blank)))
}

/// Goes through a document from top to bottom and counts.
struct Writer<'a> {
    catalogue: &'a Catalogue,
    set: Typesetter,
    figures: usize,
    tables: usize,
}

impl Writer<'_> {
    /// Sections whose headings are of `level`.
    fn parts(&mut self, sections: &[Section], level: usize) -> Result<Vec<Part>, PageError> {
        let mut parts = Vec::new();
        for section in sections {
            parts.push(Part {
                id: section.id.clone(),
                // HTML knows six levels.
                level: level.min(6),
                heading: self.set.text(&section.heading)?,
                blocks: self.pieces(&section.blocks)?,
                sections: self.parts(&section.sections, level + 1)?,
            });
        }
        Ok(parts)
    }

    fn pieces(&mut self, blocks: &[Block]) -> Result<Vec<Piece>, PageError> {
        blocks.iter().map(|block| self.piece(block)).collect()
    }

    fn piece(&mut self, block: &Block) -> Result<Piece, PageError> {
        Ok(match block {
            Block::Paragraph(text) => Piece::Paragraph { text: self.set.text(text)? },
            Block::Notice(text) => Piece::Notice { text: self.set.text(text)? },
            Block::List(points) => Piece::List { points: self.texts(points)? },
            Block::Formula { number, tex } => {
                Piece::Formula { number: number.clone(), math: self.set.formula(tex)? }
            }
            Block::Figure { id, plots, caption } => {
                let numbered = plots.iter().enumerate();
                let drawings =
                    numbered.map(|(place, plot)| drawing::plot(plot, &format!("{id}-{place}")));
                self.figure(id, drawings.collect(), caption, false)?
            }
            Block::Sketch { id, svg, caption } => {
                self.figure(id, vec![Value::from_safe_string(svg.clone())], caption, true)?
            }
            Block::Table { caption, head, rows } => Piece::Table {
                label: count("report-table", &mut self.tables, self.catalogue),
                id: format!("table-{}", self.tables),
                caption: self.set.text(caption)?,
                columns: head.len(),
                long: rows.len() > LONG,
                head: self.texts(head)?,
                rows: rows.iter().map(|row| self.line(row)).collect::<Result<_, _>>()?,
            },
            Block::Claims(claims) => Piece::Claims {
                claims: claims.iter().map(|claim| self.claim(claim)).collect::<Result<_, _>>()?,
            },
        })
    }

    fn figure(
        &mut self,
        id: &str,
        drawings: Vec<Html>,
        caption: &str,
        sketch: bool,
    ) -> Result<Piece, PageError> {
        let label = count("report-figure", &mut self.figures, self.catalogue);
        let caption = self.set.text(caption)?;
        Ok(Piece::Figure { id: id.to_owned(), label, caption, drawings, sketch })
    }

    fn line(&self, row: &Row) -> Result<Line, PageError> {
        let (target, marked) = (row.target.clone(), row.marked);
        let mut cells = self.texts(&row.cells)?;
        // Names of files may be longer than any column.
        if let Some(name) = cells.first_mut().filter(|_| target.is_some()) {
            *name = Value::from_safe_string(breakable(&name.to_string()));
        }
        Ok(Line { target, marked, cells, below: self.set.text(&row.below)? })
    }

    fn claim(&self, claim: &Claim) -> Result<Assertion, PageError> {
        Ok(Assertion {
            number: claim.number,
            id: claim.id.clone(),
            equation: claim.equation.clone(),
            claim: self.set.text(&claim.claim)?,
            stated: claim.stated,
            computed: self.texts(&claim.computed)?,
            expected: self.texts(&claim.expected)?,
            verdict: claim.verdict.map(|verdict| Mark::of(verdict, self.catalogue)),
            finding: claim.finding.as_ref().map(|finding| self.set.text(finding)).transpose()?,
        })
    }

    fn texts(&self, texts: &[String]) -> Result<Vec<Html>, PageError> {
        texts.iter().map(|text| self.set.text(text)).collect()
    }
}

/// A name in HTML without tags; a long one may go on in the next line behind each of its parts.
fn breakable(name: &str) -> String {
    // A slash needs no other spelling in a text.
    let name = name.replace("&#x2f;", "/");
    if name.chars().count() <= SHORT {
        return name;
    }
    let mut parts = name.split_inclusive(['_', '-', '/']);
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |name, part| name + "<wbr/>" + part)
}

/// The next of what is counted: “Figure 3”.
fn count(id: &str, last: &mut usize, catalogue: &Catalogue) -> String {
    *last += 1;
    catalogue.format(id, &[("number", (*last).into())])
}
