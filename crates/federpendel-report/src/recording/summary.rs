//! Many recordings in one table.

use std::f64::consts::PI;

use federpendel_fit::{Estimate, damping};
use federpendel_text::Catalogue;

use super::damping::range;
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
        let [ratio, quality] = ratio_and_quality(fit, catalogue);
        let cells = vec![literal(name), frequency(fit, catalogue), ratio, quality];
        let (target, below) = (Some(target.clone()), verdict(fit, catalogue));
        Row { target, below, ..Row::from(cells) }
    });
    let head = [
        "measured-head-recording",
        "fit-row-frequency",
        "fit-row-damping-ratio",
        "derived-quality-factor",
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

/// Damping ratio and quality factor: of Stokes friction alone with their errors, else equivalent ones by amplitude.
fn ratio_and_quality(fit: &Fitted, catalogue: &Catalogue) -> [String; 2] {
    let figures = damping(&fit.report).filter(|_| fit.report.adequacy.adequate);
    let Some(figures) = figures else { return [(); 2].map(|()| catalogue.text("measured-none")) };
    let alone = |figure: Option<Estimate>| Some(unbroken(&value(catalogue, &figure?)));
    let ratio =
        || range(&figures, |ratio| ratio, catalogue).or_else(|| alone(figures.damping_ratio));
    let quality = || range(&figures, |ratio| 0.5 / ratio, catalogue);
    let none = || catalogue.text("measured-none");
    [
        ratio().unwrap_or_else(none),
        alone(figures.quality_factor).or_else(quality).unwrap_or_else(none),
    ]
}

/// What acts and how strongly, or why no mix describes the motion.
fn verdict(fit: &Fitted, catalogue: &Catalogue) -> String {
    set(&sentences(fit, catalogue).swap_remove(0))
}
