//! What was fitted and found, as names and values.

use federpendel_fit::{Parameter, damping};
use federpendel_text::{Catalogue, excerpt};

use super::damping::{equivalent_row, ratio_name};
use super::{Fitted, parameter_name};

/// What was fitted, and what an engineer asks first.
pub fn about_rows(fit: &Fitted, catalogue: &Catalogue) -> Vec<(String, String)> {
    let report = &fit.report;
    let window = [
        ("from", catalogue.quantity(report.window.from, "s", 5).into()),
        ("to", catalogue.quantity(report.window.to, "s", 5).into()),
        ("samples", report.samples.into()),
    ];
    let mut rows = vec![
        (catalogue.text("fit-row-column"), excerpt(&fit.read.value.label)),
        (catalogue.text("fit-row-window"), catalogue.format("fit-window-value", &window)),
    ];
    if fit.read.recording.unit.is_empty() {
        rows.push((catalogue.text("fit-row-unit"), catalogue.text("fit-unit-nameless")));
    }
    let figures = damping(report);
    let frequency = figures.as_ref().map(|figures| figures.natural_frequency);
    let adequate = report.adequacy.adequate;
    let ratio = figures.filter(|_| adequate).and_then(|figures| figures.damping_ratio);
    let names = [catalogue.text("fit-row-frequency"), ratio_name(fit, catalogue)];
    for (name, figure) in names.into_iter().zip([frequency, ratio]) {
        if let Some((value, error)) = figure.and_then(|one| one.value.zip(one.stderr)) {
            let unit = figure.map_or("1", |one| one.unit);
            rows.push((name, catalogue.measured(value, error, unit)));
        }
    }
    rows.extend(equivalent_row(fit, catalogue).filter(|_| adequate));
    rows
}

/// The parameters of the verdict's mix with their errors.
pub fn parameter_rows(fit: &Fitted, catalogue: &Catalogue) -> Vec<(String, String)> {
    let parameters = fit.report.best().map_or(&[][..], |model| &model.parameters);
    let row = |parameter: &Parameter| {
        (catalogue.text(parameter_name(parameter)), parameter_value(fit, parameter, catalogue))
    };
    parameters.iter().map(row).collect()
}

/// A value with its error, or the interval that is all that is known.
pub fn parameter_value(fit: &Fitted, parameter: &Parameter, catalogue: &Catalogue) -> String {
    let unit = fit.report.unit_of(parameter.name);
    let error = parameter.stderr.unwrap_or(f64::NAN);
    match parameter.value {
        Some(value) => catalogue.measured(value, error, &unit),
        None => catalogue.interval(parameter.interval95, f64::NAN, error, &unit),
    }
}

/// What the fit leaves, root mean square.
pub fn residual_row(fit: &Fitted, catalogue: &Catalogue) -> Option<(String, String)> {
    let rms = catalogue.quantity(fit.report.best()?.rms, &fit.report.unit, 3);
    Some((catalogue.text("fit-row-residual"), rms))
}
