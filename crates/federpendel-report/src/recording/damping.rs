//! Engineers' figures of a fit, as rows.

use federpendel_fit::damping;
use federpendel_text::Catalogue;

use super::Fitted;
use super::physical::value;

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
