//! The report of fits, put together: one recording on a page, or many with a summary before them.

use std::path::Path;

use federpendel_text::Catalogue;

use super::writer::{Writer, set};
use super::{
    Fitted, decrement, figures, method, mixes, reading, result, sentences, summary, uncertainty,
};
use crate::document::{Block, Document, Section, literal};

/// Of more recordings than these, ranking, uncertainty and reading stand in a few lines, not in tables.
const MOST_IN_FULL: usize = 4;

/// The report of fits in the language of `catalogue`, and of recordings that could not be fitted, `failed`: of each why,
/// in a sentence with its name.
pub fn document(fits: &[Fitted], failed: &[String], catalogue: &Catalogue) -> Document {
    let names = names(fits);
    let version = [("version", env!("CARGO_PKG_VERSION").into())];
    let colophon = catalogue.format("measured-colophon", &version);
    let (title, lead, sections) = match (fits, names.as_slice(), failed) {
        ([fit], [name], []) => one(fit, name, catalogue),
        _ => many(fits, &names, failed, catalogue),
    };
    Document { title, lead, sections, colophon }
}

fn one(fit: &Fitted, name: &str, catalogue: &Catalogue) -> (String, Vec<Block>, Vec<Section>) {
    let writer = Writer { catalogue, fit, name, prefix: String::new() };
    let title = catalogue.format("measured-title", &[("name", literal(name).into())]);
    (title, vec![verdict(&writer)], with_method(&writer))
}

/// The sections on a single recording, in the language of `catalogue`.
pub fn sections(fit: &Fitted, catalogue: &Catalogue) -> Vec<Section> {
    with_method(&Writer { catalogue, fit, name: &fit.name, prefix: String::new() })
}

fn with_method(writer: &Writer<'_>) -> Vec<Section> {
    let mut sections = full(writer);
    sections.push(method::section(writer.catalogue));
    sections
}

fn many(
    fits: &[Fitted],
    names: &[String],
    failed: &[String],
    catalogue: &Catalogue,
) -> (String, Vec<Block>, Vec<Section>) {
    let targets: Vec<_> = (1..=fits.len()).map(|number| format!("recording-{number}")).collect();
    let mut sections = vec![summary::section(fits, names, &targets, catalogue)];
    sections.extend(not_fitted(failed, catalogue));
    for ((fit, name), id) in fits.iter().zip(names).zip(&targets) {
        let writer = Writer { catalogue, fit, name, prefix: format!("{id}-") };
        let mut blocks = vec![verdict(&writer)];
        let in_full = fits.len() <= MOST_IN_FULL;
        let sections_of_it = if in_full { full(&writer) } else { vec![] };
        if !in_full {
            blocks.extend(brief(&writer));
        }
        let heading = literal(name);
        sections.push(Section { id: id.clone(), heading, blocks, sections: sections_of_it });
    }
    sections.push(method::section(catalogue));
    let (title, lead) = title_and_lead(fits, failed, catalogue);
    (title, lead, sections)
}

/// How many recordings there are, how many were fitted, and how many of these a mix describes.
fn title_and_lead(
    fits: &[Fitted],
    failed: &[String],
    catalogue: &Catalogue,
) -> (String, Vec<Block>) {
    let count = ("count", fits.len().into());
    let all = ("all", (fits.len() + failed.len()).into());
    let adequate = fits.iter().filter(|fit| fit.report.adequacy.adequate).count();
    let id = if fits.len() == 1 { "measured-lead-one" } else { "measured-lead-many" };
    let lead = catalogue.format(id, &[("adequate", adequate.into()), count.clone()]);
    if failed.is_empty() {
        let title = catalogue.format("measured-title-many", &[count]);
        return (title, vec![Block::Paragraph(lead)]);
    }
    let missing =
        catalogue.format("fit-some-failed", &[("failed", failed.len().into()), all.clone()]);
    let title = catalogue.format("measured-title-some", &[count, all]);
    (title, vec![Block::Paragraph(format!("{lead} {missing}."))])
}

/// Why recordings were not fitted.
fn not_fitted(failed: &[String], catalogue: &Catalogue) -> Option<Section> {
    (!failed.is_empty()).then(|| Section {
        id: "not-fitted".to_owned(),
        heading: catalogue.text("measured-not-fitted"),
        blocks: vec![Block::List(failed.iter().map(|why| literal(why)).collect())],
        sections: vec![],
    })
}

/// The verdict in sentences.
fn verdict(writer: &Writer<'_>) -> Block {
    Block::Paragraph(set(&sentences(writer.fit, writer.catalogue).join(" ")))
}

/// All that is told of one recording, in order.
fn full(writer: &Writer<'_>) -> Vec<Section> {
    let mut sections = vec![result::section(writer)];
    sections.extend(figures::section(writer));
    sections.extend([
        decrement::section(writer),
        mixes::section(writer),
        uncertainty::section(writer),
        reading::section(writer),
    ]);
    sections
}

/// What is told of one recording among many.
fn brief(writer: &Writer<'_>) -> Vec<Block> {
    let mut blocks = result::blocks(writer);
    blocks.extend(decrement::figure(writer));
    let mut points = vec![mixes::brief(writer)];
    points.extend(reading::brief(writer));
    blocks.push(Block::List(points));
    blocks
}

/// What the recordings are called on a page: without their folders, unless only these tell them apart.
fn names(fits: &[Fitted]) -> Vec<String> {
    let short: Vec<_> = fits.iter().map(short).collect();
    let unique = |name: &String| short.iter().filter(|other| *other == name).count() == 1;
    let all = short.iter().all(unique);
    fits.iter()
        .zip(&short)
        .map(|(fit, short)| if all { short } else { &fit.name }.clone())
        .collect()
}

fn short(fit: &Fitted) -> String {
    let run = fit.read.run.as_ref().map(|run| format!(" ({run})")).unwrap_or_default();
    let file = fit.name.strip_suffix(&run).unwrap_or(&fit.name);
    let file = Path::new(file).file_name().map_or(file.into(), |name| name.to_string_lossy());
    format!("{file}{run}")
}
