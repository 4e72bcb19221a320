//! From numbers to what a person reads of them.

use std::cell::Cell;

use federpendel_text::{Catalogue, Value};

use super::check::{Check, Figure};
use crate::document::{Block, Claim, Section, Verdict};

/// Digits of a number beside which another one stands to be compared.
const DIGITS: usize = 5;

/// Digits of what should be zero.
const DIGITS_OF_NOTHING: usize = 2;

/// Writes the blocks of a report in one language, and numbers its claims.
pub struct Writer<'a> {
    /// Where the sentences come from.
    pub catalogue: &'a Catalogue,
    /// Whether verdicts are left blank.
    blank: bool,
    claims: Cell<usize>,
}

impl<'a> Writer<'a> {
    /// A writer whose first claim has the number 1.
    pub fn new(catalogue: &'a Catalogue, blank: bool) -> Self {
        Writer { catalogue, blank, claims: Cell::new(0) }
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

    /// The claims of a section.
    pub fn claims(&self, checks: &[Check]) -> Block {
        Block::Claims(checks.iter().map(|check| self.claim(check)).collect())
    }

    fn claim(&self, check: &Check) -> Claim {
        let number = self.claims.get() + 1;
        self.claims.set(number);
        let id = format!("check-{}", check.id);
        let finding = format!("{id}.{}", check.verdict.name());
        let finding = self.catalogue.contains(&finding).then(|| self.catalogue.text(&finding));
        let nothing = !check.expected.is_empty() && check.expected.iter().all(|figure| figure.symbol == "0");
        Claim {
            number,
            id: check.id.to_owned(),
            equation: equation(check),
            claim: self.catalogue.text(&id),
            computed: check.computed.iter().map(|figure| self.figure(figure, nothing)).collect(),
            expected: check.expected.iter().map(|figure| self.expected(figure)).collect(),
            verdict: (!self.blank).then_some(check.verdict),
            finding: finding.filter(|_| !self.blank),
        }
    }

    /// `v_A = 19.749 mm/s`; of what should be zero fewer digits.
    fn figure(&self, figure: &Figure, nothing: bool) -> String {
        let digits = if nothing { DIGITS_OF_NOTHING } else { DIGITS };
        let value = self.catalogue.quantity(figure.value, figure.unit, digits);
        match figure.time {
            None => format!("{} = {value}", figure.symbol),
            Some(time) => format!("{} = {value} (t = {})", figure.symbol, self.catalogue.quantity(time, "s", DIGITS)),
        }
    }

    /// As [`Writer::figure`], but a bare number or bound stands for itself.
    fn expected(&self, figure: &Figure) -> String {
        let bare = figure.symbol.starts_with(['<', '>']) || figure.symbol.parse::<f64>().is_ok();
        if bare { figure.symbol.to_owned() } else { self.figure(figure, false) }
    }

    /// A verdict in words.
    pub fn verdict(&self, verdict: Verdict) -> String {
        self.catalogue.text(&format!("report-verdict-{}", verdict.name()))
    }
}

/// “(68)”; a section as it is; nothing for the introduction.
pub fn equation(check: &Check) -> String {
    match check.equation {
        "" => String::new(),
        section if section.starts_with('§') => section.to_owned(),
        numbers => format!("({numbers})"),
    }
}
