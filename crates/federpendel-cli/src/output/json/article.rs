//! The checks of the article's claims, with the fields of `schemas/article.schema.json`.

use federpendel_report::article::{Check, Checks, Figure, check_claim};
use federpendel_report::plain;
use federpendel_text::Catalogue;
use serde::Serialize;

use super::document::Schema;

#[derive(Serialize)]
pub(super) struct ArticleDocument {
    schema: Schema,
    checks: Vec<CheckFields>,
}

#[derive(Serialize)]
struct CheckFields {
    number: usize,
    id: &'static str,
    equation: &'static str,
    claim: String,
    stated: bool,
    computed: Vec<FigureFields>,
    expected: Vec<FigureFields>,
    verdict: &'static str,
    finding: Option<String>,
}

#[derive(Serialize)]
struct FigureFields {
    symbol: &'static str,
    time: Option<f64>,
    value: Option<f64>,
    unit: &'static str,
}

impl From<&Figure> for FigureFields {
    fn from(figure: &Figure) -> Self {
        FigureFields {
            symbol: figure.symbol,
            time: figure.time,
            // JSON has neither NaN nor infinity. Adding zero turns −0 into 0.
            value: Some(figure.value + 0.0).filter(|value| value.is_finite()),
            unit: figure.unit,
        }
    }
}

impl ArticleDocument {
    pub(super) fn new(checks: &Checks, catalogue: &Catalogue) -> Self {
        let fields = |check: &Check| {
            let claim = check_claim(check, catalogue);
            CheckFields {
                number: check.number,
                id: check.id,
                equation: check.equation,
                claim: plain::text(&claim.claim),
                stated: check.stated,
                computed: check.computed.iter().map(FigureFields::from).collect(),
                expected: check.expected.iter().map(FigureFields::from).collect(),
                verdict: check.verdict.name(),
                finding: claim.finding.as_deref().map(plain::text),
            }
        };
        ArticleDocument {
            schema: Schema { name: "federpendel-article", version: 1 },
            checks: checks.all().map(fields).collect(),
        }
    }
}
