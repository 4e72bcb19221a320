//! Engineers' figures, and physical numbers where a mass or the like was measured beside the recording.

use super::writer::{Writer, set, unbroken};
use super::{damping_rows, physical_rows, physical_sentences};
use crate::document::{Block, Row, Section};

/// Damping by amplitude, masses, forces and coefficients of friction; none of a motion that no mix describes.
pub fn section(writer: &Writer<'_>) -> Option<Section> {
    let (fit, catalogue) = (writer.fit, writer.catalogue);
    let damping = damping_rows(fit, catalogue);
    let physical = physical_rows(fit, catalogue);
    let said = physical_sentences(fit, catalogue);
    if !fit.report.adequacy.adequate || damping.len() + physical.len() + said.len() == 0 {
        return None;
    }
    let head = ["measured-head-quantity", "measured-head-value"];
    let mut blocks = Vec::new();
    if !damping.is_empty() {
        blocks.push(writer.say("measured-damping-text", &[]));
        let caption = writer.text("measured-damping-caption");
        blocks.push(writer.table(caption, &head, rows(damping)));
    }
    if !physical.is_empty() {
        let caption = writer.text("measured-physical-caption");
        blocks.push(writer.table(caption, &head, rows(physical)));
    }
    if !said.is_empty() {
        blocks.push(Block::List(said.iter().map(|sentence| set(sentence)).collect()));
    }
    Some(writer.section("figures", "measured-figures", blocks))
}

fn rows(named: Vec<(String, String)>) -> Vec<Row> {
    named
        .into_iter()
        .map(|(name, value)| Row::from(vec![set(&name), unbroken(&set(&value))]))
        .collect()
}
