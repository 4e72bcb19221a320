//! Engineers' figures of a fit, as rows.

use federpendel_fit::{Damping, damping};
use federpendel_text::Catalogue;

use super::Fitted;
use super::physical::value;

/// Digits of an equivalent figure.
const DIGITS: usize = 2;

/// What the row of the damping ratio is called: where other laws act too it is of the viscous part only.
pub(super) fn ratio_name(fit: &Fitted, catalogue: &Catalogue) -> String {
    let mix = fit.report.verdict.mix;
    let alone = !(mix.coulomb || mix.newton);
    catalogue.text(if alone { "fit-row-damping-ratio" } else { "fit-row-damping-ratio.viscous" })
}

/// A figure of the equivalent damping ratio from the first amplitude to the last: “0.022 to 0.33”. None where viscous
/// friction acts alone, or nothing.
pub(super) fn range(
    figures: &Damping,
    of_ratio: fn(f64) -> f64,
    catalogue: &Catalogue,
) -> Option<String> {
    let (first, last) = (figures.equivalent.first()?, figures.equivalent.last()?);
    if figures.quality_factor.is_some() {
        return None;
    }
    let said = |ratio: f64| catalogue.number(of_ratio(ratio), DIGITS);
    let [first, last] = [said(first.damping_ratio), said(last.damping_ratio)];
    if first == last {
        return Some(first);
    }
    Some(catalogue.format("fit-range", &[("first", first.into()), ("last", last.into())]))
}

/// The equivalent damping ratio where viscous friction does not act alone: “0.022 to 0.33 (30.5 mm to 1.5 mm)”.
pub(super) fn equivalent_row(fit: &Fitted, catalogue: &Catalogue) -> Option<(String, String)> {
    let figures = damping(&fit.report)?;
    let values = range(&figures, |ratio| ratio, catalogue)?;
    let (first, last) = (figures.equivalent.first()?, figures.equivalent.last()?);
    let unit = fit.report.length_unit();
    let [from, to] = [first, last].map(|at| catalogue.quantity(at.amplitude, &unit, 3));
    let variables = [("values", values.into()), ("from", from.into()), ("to", to.into())];
    Some((catalogue.text("fit-row-equivalent"), catalogue.format("fit-range-at", &variables)))
}

/// Names and values of the figures beside natural frequency and damping ratio: decrement and quality factor of Stokes
/// friction alone, else the equivalent damping ratio by amplitude.
pub fn damping_rows(fit: &Fitted, catalogue: &Catalogue) -> Vec<(String, String)> {
    let Some(figures) = damping(&fit.report) else { return vec![] };
    let single = [
        ("derived-logarithmic-decrement", "Λ", figures.logarithmic_decrement),
        ("derived-quality-factor", "Q", figures.quality_factor),
    ];
    let named = single.into_iter().filter_map(|(id, symbol, figure)| {
        Some((format!("{} {symbol}", catalogue.text(id)), value(catalogue, &figure?)))
    });
    let mut rows: Vec<(String, String)> = named.collect();
    if rows.is_empty() {
        let unit = fit.report.length_unit();
        rows.extend(figures.equivalent.iter().map(|one| {
            let amplitude = catalogue.quantity(one.amplitude, &unit, 3);
            let name =
                catalogue.format("physical-row-equivalent", &[("amplitude", amplitude.into())]);
            let error = one.stderr.unwrap_or(f64::NAN);
            (name, catalogue.measured(one.damping_ratio, error, "1"))
        }));
    }
    rows
}
