//! From what a fit found to the blocks of its report.

use federpendel_fit::Parameter;
use federpendel_text::{Catalogue, Value};

use super::Fitted;
use crate::document::{Block, Row, Section, literal};

/// Writes the report of one recording in one language.
pub struct Writer<'a> {
    /// Where the sentences come from.
    pub catalogue: &'a Catalogue,
    /// The recording and its fit.
    pub fit: &'a Fitted,
    /// What the recording is called on the page.
    pub name: &'a str,
    /// What its links begin with, so that several recordings can stand on one page.
    pub prefix: String,
}

impl Writer<'_> {
    /// A name to link to.
    pub fn id(&self, id: &str) -> String {
        format!("{}{id}", self.prefix)
    }

    /// A sentence.
    pub fn text(&self, id: &str) -> String {
        self.catalogue.text(id)
    }

    /// A paragraph.
    pub fn say(&self, id: &str, variables: &[(&str, Value<'_>)]) -> Block {
        Block::Paragraph(self.catalogue.format(id, variables))
    }

    /// A section without subsections.
    pub fn section(&self, id: &str, heading: &str, blocks: Vec<Block>) -> Section {
        Section { id: self.id(id), heading: self.text(heading), blocks, sections: vec![] }
    }

    /// A table of rows with these headings.
    pub fn table(&self, caption: String, head: &[&str], rows: Vec<Row>) -> Block {
        Block::Table { caption, head: head.iter().map(|head| self.text(head)).collect(), rows }
    }

    /// A value of the recorded quantity.
    pub fn recorded(&self, value: f64, digits: usize) -> String {
        let unit = &self.fit.report.unit;
        let unit = if unit.is_empty() { "1" } else { unit };
        literal(&self.catalogue.quantity(value, unit, digits))
    }

    /// The verdict's mix in words.
    pub fn mix(&self) -> String {
        self.catalogue.mix(self.fit.report.verdict.mix)
    }

    /// What is not there.
    pub fn none(&self) -> String {
        self.text("measured-none")
    }
}

/// `text` on one line.
pub fn unbroken(text: &str) -> String {
    text.replace(' ', "\u{a0}")
}

/// `text` of the catalogue, written for terminals too, as a page has it: its letters with an index set as formulas, all else
/// literally.
pub fn set(text: &str) -> String {
    let set = |text: String, (letters, tex): &(&str, &str)| text.replace(letters, tex);
    INDEXED.iter().fold(literal(text), set)
}

/// Letters with an index, and how they are set.
const INDEXED: [(&str, &str); 5] =
    [("a_c", "$a_c$"), ("F_c", "$F_c$"), ("m_s", "$m_s$"), ("μ_s", r"$\mu_s$"), ("c_w", "$c_w$")];

/// The sentence that names a parameter.
pub fn parameter_name(parameter: &Parameter) -> &'static str {
    match parameter.name {
        "angular_frequency" => "fit-parameter-angular-frequency",
        "damping_rate" => "fit-parameter-damping-rate",
        "coulomb_acceleration" => "fit-parameter-coulomb-acceleration",
        "newton_rate" => "fit-parameter-newton-rate",
        "position0" => "fit-parameter-position0",
        "velocity0" => "fit-parameter-velocity0",
        "static_acceleration" => "fit-parameter-static-acceleration",
        _ => "fit-parameter-equilibrium",
    }
}
