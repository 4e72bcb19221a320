//! What makes a verdict less sure than its numbers say.

use std::f64::consts::PI;

use federpendel_fit::{Edge, Loss, Model};
use federpendel_text::Catalogue;

use super::verdict::STRONG;
use super::{Fitted, edge};

/// Verdicts of fewer swings than these often err.
const FEW_SWINGS: f64 = 5.0;

/// Fewer values in a swing leave its shape open.
const FEW_VALUES: f64 = 4.0;

/// A fitted part shorter than this share of the recording is said.
const SMALL_PART: f64 = 0.5;

/// Sentences of caution.
pub fn cautions(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> Vec<String> {
    [
        part(fit, catalogue),
        swings(fit, model, catalogue),
        values(fit, model, catalogue),
        outliers(fit, catalogue),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// That only a small part was fitted, where the rest is something else than a hand before or a rest after.
fn part(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let (window, times) = (&fit.report.window, &fit.read.recording.times);
    let whole = times.last()? - times.first()?;
    let strange = [window.begins, window.ends].into_iter().find(|edge| {
        matches!(edge, Edge::Driven | Edge::Misfit | Edge::Disturbed | Edge::Unrest)
    })?;
    (window.to - window.from < SMALL_PART * whole).then(|| {
        let variables = [
            ("from", catalogue.quantity(window.from, "s", 4).into()),
            ("to", catalogue.quantity(window.to, "s", 4).into()),
            ("why", edge(catalogue, strange).into()),
        ];
        catalogue.format("fit-caution-part", &variables)
    })
}

/// Half periods of the undamped motion in the fitted part.
fn half_periods(fit: &Fitted, model: &Model) -> f64 {
    let window = &fit.report.window;
    model.value("angular_frequency") * (window.to - window.from) / PI
}

fn swings(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> Option<String> {
    let strong = model.value("damping_rate") > STRONG * model.value("angular_frequency");
    let swings = half_periods(fit, model);
    (swings < FEW_SWINGS && !strong).then(|| {
        let number = ("number", catalogue.number(swings, 2).into());
        catalogue.format("fit-caution-swings", &[number])
    })
}

fn values(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> Option<String> {
    let values = fit.report.samples as f64 / half_periods(fit, model);
    (values < FEW_VALUES).then(|| {
        let number = ("number", catalogue.number(values, 2).into());
        catalogue.format("fit-caution-values", &[number])
    })
}

/// Values far off all others, which sway least squares.
fn outliers(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let report = &fit.report;
    (report.outliers > 0 && report.loss == Loss::Squares)
        .then(|| catalogue.format("fit-caution-outliers", &[("count", report.outliers.into())]))
}
