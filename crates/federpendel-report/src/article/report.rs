//! The whole report, put together.

use federpendel::Result;
use federpendel_text::Catalogue;
use federpendel_text::plot::Plot;

use super::check::Check;
use super::section::{coulomb, experiment, newton, scheme, stokes, undamped, which};
use super::writer::{Writer, check_claim};
use super::{Checks, Laboratory};
use crate::document::{Block, Document, Row, Verdict};

/// For whom the report is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edition {
    /// A reader who wants to know.
    Report,
    /// A class that has to find out: the verdicts are left blank.
    Worksheet,
    /// The class's teacher: the worksheet filled in.
    Solutions,
}

/// The report on the article for one experiment.
///
/// # Errors
/// What the core refuses.
pub fn document(
    laboratory: &Laboratory,
    checks: &Checks,
    edition: Edition,
    catalogue: &Catalogue,
) -> Result<Document> {
    let blank = edition == Edition::Worksheet;
    let writer = Writer::new(catalogue, edition);
    let mut sections = vec![
        experiment::section(&writer, laboratory)?,
        undamped::section(&writer, laboratory, checks)?,
        stokes::section(&writer, laboratory, checks)?,
        coulomb::section(&writer, laboratory, checks)?,
        newton::section(&writer, laboratory, checks)?,
        which::section(&writer, laboratory, checks)?,
        scheme::section(&writer, laboratory)?,
    ];
    let about = if blank { "article-lead-worksheet" } else { "article-lead-report" };
    let lead = [catalogue.text("article-lead"), catalogue.text(about)].join(" ");
    let mut lead = vec![Block::Paragraph(lead), writer.say("article-own-values")];
    if blank {
        lead.push(writer.say("article-task"));
    } else {
        lead.push(Block::Paragraph(result(checks, catalogue)));
        sections.push(writer.section(
            "errata",
            vec![writer.say("article-errata-text"), wrong(checks, &writer)],
            vec![],
        ));
    }
    let title = match edition {
        Edition::Report => "article-title",
        Edition::Worksheet => "article-title-worksheet",
        Edition::Solutions => "article-title-solutions",
    };
    let version = [("version", env!("CARGO_PKG_VERSION").into())];
    let colophon = catalogue.format("article-colophon", &version);
    Ok(Document { title: catalogue.text(title), lead, sections, colophon })
}

/// How many claims hold, in a sentence or two.
pub fn result(checks: &Checks, catalogue: &Catalogue) -> String {
    let count = |verdict: Verdict| checks.all().filter(|check| check.verdict == verdict).count();
    let counts = [
        ("checks", checks.all().count().into()),
        ("holds", count(Verdict::Holds).into()),
        ("fails", count(Verdict::Fails).into()),
    ];
    let mut sentences = vec![catalogue.format("article-result", &counts)];
    let readings =
        checks.all().filter(|check| check.verdict == Verdict::Fails && !check.stated).count();
    if readings > 0 {
        sentences.push(catalogue.format("article-result-readings", &[("claims", readings.into())]));
    }
    for (verdict, id) in [
        (Verdict::HoldsHere, "article-result-here"),
        (Verdict::NotApplicable, "article-result-open"),
    ] {
        if count(verdict) > 0 {
            sentences.push(catalogue.format(id, &[("claims", count(verdict).into())]));
        }
    }
    sentences.join(" ")
}

/// The claims that do not hold, in a table.
fn wrong(checks: &Checks, writer: &Writer<'_>) -> Block {
    let text = |id: &str| writer.catalogue.text(id);
    let stands_out = |check: &&Check| matches!(check.verdict, Verdict::Fails | Verdict::HoldsHere);
    let rows = checks.all().filter(stands_out).map(|check| {
        let claim = check_claim(check, writer.catalogue);
        let right = claim.finding.unwrap_or_default();
        let cells = vec![claim.number.to_string(), claim.equation, claim.claim, right];
        Row { target: Some(claim.id), ..Row::from(cells) }
    });
    Block::Table {
        caption: text("article-see-claims"),
        head: ["number", "equation", "claim", "right"]
            .map(|head| text(&format!("article-head-{head}")))
            .to_vec(),
        rows: rows.collect(),
    }
}

/// The picture that says most: the printed formula for a release from rest with Coulomb friction, beside the motion.
///
/// # Errors
/// What the core refuses.
pub fn picture(laboratory: &Laboratory, catalogue: &Catalogue) -> Result<Plot> {
    let writer = Writer::new(catalogue, Edition::Report);
    let mut plots = coulomb::plots_from_rest(&writer, &laboratory.coulomb)?;
    Ok(plots.swap_remove(0))
}
