//! What the page says around its content.

use federpendel_text::Catalogue;
use serde::Serialize;

use crate::Verdict;

/// Words that stand on every page.
#[derive(Serialize)]
pub struct Words {
    contents: String,
    skip: String,
    notice: String,
    claim: String,
    reading: String,
    computed: String,
    expected: String,
    verdict: String,
    finding: String,
    name: String,
    class: String,
    date: String,
}

impl Words {
    pub fn of(catalogue: &Catalogue) -> Self {
        Self {
            contents: catalogue.text("report-contents"),
            skip: catalogue.text("report-skip"),
            notice: catalogue.text("report-notice"),
            claim: catalogue.text("report-claim"),
            reading: catalogue.text("report-reading"),
            computed: catalogue.text("report-computed"),
            expected: catalogue.text("report-expected"),
            verdict: catalogue.text("report-verdict"),
            finding: catalogue.text("report-finding"),
            name: catalogue.text("report-name"),
            class: catalogue.text("report-class"),
            date: catalogue.text("report-date"),
        }
    }
}

/// A verdict as the page shows it: by a mark, a word and a colour.
#[derive(Serialize)]
pub struct Mark {
    name: &'static str,
    sign: char,
    word: String,
}

impl Mark {
    pub fn of(verdict: Verdict, catalogue: &Catalogue) -> Self {
        let (sign, id) = match verdict {
            Verdict::Holds => ('✓', "report-verdict-holds"),
            Verdict::Fails => ('✗', "report-verdict-fails"),
            Verdict::HoldsHere => ('≈', "report-verdict-holds-here"),
            Verdict::NotApplicable => ('–', "report-verdict-not-applicable"),
        };
        Self { name: verdict.name(), sign, word: catalogue.text(id) }
    }
}
