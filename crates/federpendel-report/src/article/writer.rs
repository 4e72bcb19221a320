//! From numbers to what a person reads of them.

use federpendel_text::{Catalogue, Value};

use federpendel::State;

use super::Case;
use super::check::{Check, Figure};
use super::report::Edition;
use crate::document::{Block, Claim, Section, Verdict};

/// Digits of a number beside which another one stands to be compared.
const DIGITS: usize = 5;

/// Digits of what should be zero.
const DIGITS_OF_NOTHING: usize = 2;

/// Writes the blocks of a report in one language.
pub struct Writer<'a> {
    /// Where the sentences come from.
    pub catalogue: &'a Catalogue,
    /// Whether verdicts are left blank.
    blank: bool,
    /// Whether every claim gets a finding.
    full: bool,
}

impl<'a> Writer<'a> {
    /// A writer for one edition.
    pub fn new(catalogue: &'a Catalogue, edition: Edition) -> Self {
        let (blank, full) = (edition == Edition::Worksheet, edition == Edition::Solutions);
        Writer { catalogue, blank, full }
    }

    /// A section whose heading is `article-{id}`.
    pub fn section(&self, id: &str, blocks: Vec<Block>, sections: Vec<Section>) -> Section {
        let heading = self.catalogue.text(&format!("article-{id}"));
        Section { id: id.to_owned(), heading, blocks, sections }
    }

    /// A paragraph.
    pub fn say(&self, id: &str) -> Block {
        Block::Paragraph(self.catalogue.text(id))
    }

    /// What the reader should not overlook.
    pub fn notice(&self, id: &str, variables: &[(&str, Value<'_>)]) -> Block {
        Block::Notice(self.catalogue.format(id, variables))
    }

    /// A length of time.
    pub fn time(&self, value: f64) -> Value<'static> {
        self.catalogue.quantity(value, "s", 4).into()
    }

    /// A position.
    pub fn length(&self, value: f64) -> Value<'static> {
        self.catalogue.quantity(value, "m", 4).into()
    }

    /// A velocity.
    pub fn velocity(&self, value: f64) -> Value<'static> {
        self.catalogue.quantity(value, "m/s", 4).into()
    }

    /// Where and how a motion is released, for a caption.
    pub fn release(&self, case: &Case) -> [(&'static str, Value<'static>); 2] {
        let State { position, velocity } = case.release();
        [("position", self.length(position)), ("velocity", self.velocity(velocity))]
    }

    /// A paragraph that gives answers away, with what belongs to it: nothing in a worksheet.
    pub fn explain(&self, id: &str, more: impl FnOnce() -> Vec<Block>) -> Vec<Block> {
        let mut blocks = Vec::new();
        if !self.blank {
            blocks.push(self.say(id));
            blocks.extend(more());
        }
        blocks
    }

    /// A block that gives answers away.
    pub fn unless_blank(&self, block: impl FnOnce() -> Block) -> Option<Block> {
        (!self.blank).then(block)
    }

    /// The first name, or in a worksheet the second.
    pub fn either(&self, full: &'static str, blank: &'static str) -> &'static str {
        if self.blank { blank } else { full }
    }

    /// The claims of a section.
    pub fn claims(&self, checks: &[Check]) -> Block {
        Block::Claims(checks.iter().map(|check| self.claim(check)).collect())
    }

    fn claim(&self, check: &Check) -> Claim {
        let claim = check_claim(check, self.catalogue);
        if self.blank {
            return Claim { verdict: None, finding: None, ..claim };
        }
        let agrees = check.verdict == Verdict::Holds && !check.expected.iter().any(is_bound);
        let plain = (self.full && agrees).then(|| self.catalogue.text("report-agrees"));
        Claim { finding: claim.finding.or(plain), ..claim }
    }
}

/// A check in words.
pub fn check_claim(check: &Check, catalogue: &Catalogue) -> Claim {
    let id = format!("check-{}", check.id);
    let finding = format!("{id}.{}", check.verdict.name());
    let finding = catalogue.contains(&finding).then(|| catalogue.text(&finding));
    let nothing =
        !check.expected.is_empty() && check.expected.iter().all(|figure| figure.symbol == "0");
    Claim {
        number: check.number,
        id: check.id.to_owned(),
        equation: check.place(),
        claim: catalogue.text(&id),
        computed: check
            .computed
            .iter()
            .map(|figure| computed(figure, nothing, catalogue))
            .collect(),
        expected: check.expected.iter().map(|figure| expected(figure, catalogue)).collect(),
        stated: check.stated,
        verdict: Some(check.verdict),
        finding,
    }
}

/// `$v_{A}$ = 19.749 mm/s`; of what should be `nothing` fewer digits.
fn computed(figure: &Figure, nothing: bool, catalogue: &Catalogue) -> String {
    let symbol = lowered(figure.symbol);
    let digits = if nothing { DIGITS_OF_NOTHING } else { DIGITS };
    let value = if figure.value.is_nan() {
        catalogue.text("report-undefined")
    } else {
        catalogue.quantity(figure.value, figure.unit, digits)
    };
    match figure.time {
        None => format!("{symbol} = {value}"),
        Some(time) => {
            format!("{symbol} = {value} (t = {})", catalogue.quantity(time, "s", DIGITS))
        }
    }
}

/// As [`computed`], but a bare number or bound stands for itself.
fn expected(figure: &Figure, catalogue: &Catalogue) -> String {
    let bare = is_bound(figure) || figure.symbol.parse::<f64>().is_ok();
    if bare { figure.symbol.to_owned() } else { computed(figure, false, catalogue) }
}

/// Whether it stands for a relation rather than for a number: `< 0`.
fn is_bound(figure: &Figure) -> bool {
    figure.symbol.starts_with(['<', '>', '≠'])
}

/// A symbol in which `v_A` is a formula, `$v_{A}$`, so that its index is set as one.
fn lowered(symbol: &str) -> String {
    let mut pieces = symbol.split('_');
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find(|sign: char| !sign.is_alphanumeric()).unwrap_or(piece.len());
        let (index, rest) = piece.split_at(end);
        let letter = text.pop().unwrap_or_default();
        text = format!("{text}${letter}_{{{index}}}${rest}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_are_set_as_such() {
        assert_eq!(lowered("x₀"), "x₀");
        assert_eq!(lowered("2μF_N/C"), "2μ$F_{N}$/C");
        assert_eq!(lowered("max|Δx(t_n)|, v_A"), "max|Δx($t_{n}$)|, $v_{A}$");
    }
}
