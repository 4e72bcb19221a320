//! Everything as JSON, with the fields of the schemas in `schemas/`.

mod article;
mod comparison;
mod document;
mod fit;
mod physical;
mod plan;
mod score;
mod tidy;

use std::io::{self, Write};

use federpendel_fit::plan::Plan;
use federpendel_report::article::Checks;
use federpendel_text::Catalogue;
use serde::Serialize;
use serde_json::Serializer;

use crate::comparison::Comparison;
use crate::fit::Fits;
use crate::record::Record;
use crate::score::Score;
use article::ArticleDocument;
use comparison::ComparisonDocument;
use document::Document;
use fit::{FitDocument, FitsDocument};
use plan::PlanDocument;
use score::ScoreDocument;
use tidy::Tidy;

pub(super) fn write(record: &Record, out: &mut dyn Write) -> io::Result<()> {
    write_document(&Document::new(record, "federpendel-simulation").map_err(io::Error::other)?, out)
}

pub(super) fn write_comparison(comparison: &Comparison, out: &mut dyn Write) -> io::Result<()> {
    write_document(&ComparisonDocument::new(comparison).map_err(io::Error::other)?, out)
}

pub(super) fn write_score(score: &Score<'_>, out: &mut dyn Write) -> io::Result<()> {
    write_document(&ScoreDocument::new(score), out)
}

pub(super) fn write_article(
    checks: &Checks,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    write_document(&ArticleDocument::new(checks, catalogue), out)
}

pub(super) fn write_fits(
    fits: &Fits,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    match (&fits.fitted[..], &fits.failed[..]) {
        ([fit], []) => write_document(&FitDocument::new(fit, catalogue), out),
        _ => write_document(&FitsDocument::new(fits, catalogue), out),
    }
}

pub(super) fn write_plan(
    plan: &Plan,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    write_document(&PlanDocument::new(plan, catalogue), out)
}

fn write_document(document: &impl Serialize, out: &mut dyn Write) -> io::Result<()> {
    document.serialize(&mut Serializer::with_formatter(&mut *out, Tidy::default()))?;
    out.write_all(b"\n")
}
