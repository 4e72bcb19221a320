//! Many recordings in one table.

use std::f64::consts::PI;

use federpendel_fit::{Estimate, damping};
use federpendel_text::Catalogue;

use super::physical::value;
use super::writer::{set, unbroken};
use super::{Fitted, sentences};
use crate::document::{Block, Row, Section, literal};

/// A row for each of `fits`, which lead to the sections `targets`.
pub fn section(
    fits: &[Fitted],
    names: &[String],
    targets: &[String],
    catalogue: &Catalogue,
) -> Section {
    let rows = fits.iter().zip(names).zip(targets).map(|((fit, name), target)| {
        let figures = damping(&fit.report).filter(|_| fit.report.adequacy.adequate);
        let [ratio, quality] = match figures {
            Some(figures) => [figures.damping_ratio, figures.quality_factor],
            None => [None; 2],
        };
        let cells = vec![
            literal(name),
            frequency(fit, catalogue),
            figure(ratio, catalogue),
            figure(quality, catalogue),
            verdict(fit, catalogue),
        ];
        Row { cells, target: Some(target.clone()), marked: false }
    });
    let head = [
        "measured-head-recording",
        "fit-row-frequency",
        "fit-row-damping-ratio",
        "derived-quality-factor",
        "measured-head-verdict",
    ];
    let table = Block::Table {
        caption: catalogue.text("measured-summary-caption"),
        head: head.map(|head| catalogue.text(head)).into(),
        rows: rows.collect(),
    };
    Section {
        id: "summary".to_owned(),
        heading: catalogue.text("measured-summary"),
        blocks: vec![table],
        sections: vec![],
    }
}

fn frequency(fit: &Fitted, catalogue: &Catalogue) -> String {
    let omega = fit.report.best().and_then(|model| model.parameter("angular_frequency"));
    let known = omega.and_then(|omega| Some((omega.value?, omega.stderr.unwrap_or(f64::NAN))));
    known.map_or_else(
        || catalogue.text("measured-none"),
        |(value, error)| {
            unbroken(&catalogue.measured(value / (2.0 * PI), error / (2.0 * PI), "Hz"))
        },
    )
}

/// A figure of Stokes friction with its error, where that acts.
fn figure(figure: Option<Estimate>, catalogue: &Catalogue) -> String {
    figure.map_or_else(
        || catalogue.text("measured-none"),
        |figure| unbroken(&value(catalogue, &figure)),
    )
}

/// What acts and how strongly, or why no mix describes the motion.
fn verdict(fit: &Fitted, catalogue: &Catalogue) -> String {
    set(&sentences(fit, catalogue).swap_remove(0))
}
