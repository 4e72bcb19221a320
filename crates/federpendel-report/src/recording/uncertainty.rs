//! How sure the values are, and how good the fit is.

use federpendel_fit::{Model, StopReason};
use federpendel_text::Catalogue;

use super::writer::Writer;
use crate::document::{Block, Row, Section};

/// Symbols of the parameters, by their names; the zero of the sensor has none. A heading needs a word, not only a formula,
/// for who hears it read.
const SYMBOLS: [(&str, &str); 6] = [
    ("angular_frequency", "ω₀"),
    ("damping_rate", "γ (Stokes)"),
    ("coulomb_acceleration", "$a_c$ (Coulomb)"),
    ("newton_rate", "κ (Newton)"),
    ("position0", "x₀"),
    ("velocity0", "v₀"),
];

/// A correlation that needs as many digits to be told from ±1 is one.
const MOST_DIGITS: usize = 8;

/// Correlations and statistics.
pub fn section(writer: &Writer<'_>) -> Section {
    let report = &writer.fit.report;
    let mut text = writer.text("measured-uncertainty-text");
    if report.effective_samples < report.samples as f64 {
        let variables = [
            ("samples", report.samples.into()),
            ("effective", writer.catalogue.number(report.effective_samples.round(), 4).into()),
        ];
        text += " ";
        text += &writer.catalogue.format("measured-uncertainty-effective", &variables);
    }
    let mut blocks = vec![Block::Paragraph(text)];
    if let Some(model) = report.best() {
        blocks.extend([correlations(writer, model), statistics(writer, model)]);
    }
    writer.section("uncertainty", "measured-uncertainty", blocks)
}

fn symbol(writer: &Writer<'_>, name: &str) -> String {
    let known = SYMBOLS.iter().find(|(parameter, _)| *parameter == name);
    known.map_or_else(|| writer.text("measured-symbol-zero"), |(_, symbol)| (*symbol).to_owned())
}

fn correlations(writer: &Writer<'_>, model: &Model) -> Block {
    let symbols: Vec<_> = model.parameters[..model.correlations.len()]
        .iter()
        .map(|parameter| symbol(writer, parameter.name))
        .collect();
    let cell = |value: f64| {
        if value.is_finite() { correlation(writer.catalogue, value) } else { writer.none() }
    };
    let rows = model.correlations.iter().zip(&symbols).enumerate().map(|(i, (row, symbol))| {
        let cells = row[..=i].iter().map(|value| cell(*value));
        let empty = std::iter::repeat_n(String::new(), row.len() - i - 1);
        let cells: Vec<_> = [symbol.clone()].into_iter().chain(cells).chain(empty).collect();
        Row::from(cells)
    });
    let mut caption = writer.text("measured-correlations-caption");
    if let Some((i, j, value)) = largest(&model.correlations) {
        let variables = [
            ("value", correlation(writer.catalogue, value).into()),
            ("one", symbols[i].as_str().into()),
            ("other", symbols[j].as_str().into()),
        ];
        let sentence = writer.catalogue.format("measured-correlations-largest", &variables);
        caption = [caption, sentence].join(" ");
    }
    let rows = rows.collect();
    let head = [writer.text("measured-head-parameter")].into_iter().chain(symbols).collect();
    Block::Table { caption, head, rows }
}

/// A correlation with two digits, or with as many as tell it from ±1.
pub fn correlation(catalogue: &Catalogue, value: f64) -> String {
    let distance = 1.0 - value.abs();
    let tells = |digits: &usize| distance >= 0.5 * 10f64.powi(-(*digits as i32));
    catalogue.fixed(value, (2..MOST_DIGITS).find(tells).unwrap_or(2))
}

/// The largest correlation of two parameters, and whose.
fn largest(correlations: &[Vec<f64>]) -> Option<(usize, usize, f64)> {
    let rows = correlations.iter().enumerate();
    let pairs = rows.flat_map(|(i, row)| (0..i).map(move |j| (j, i, row[j])));
    pairs.filter(|pair| pair.2.is_finite()).max_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))
}

fn statistics(writer: &Writer<'_>, model: &Model) -> Block {
    let report = &writer.fit.report;
    let number = |value: f64| writer.catalogue.number(value, 6);
    let stop = match model.stop_reason {
        StopReason::Converged => "measured-stop-converged",
        StopReason::NoProgress => "measured-stop-no-progress",
        StopReason::StepLimit => "measured-stop-step-limit",
    };
    let words = |id: &str| writer.text(id);
    let mut rows = vec![
        (words("measured-samples"), report.samples.to_string()),
        (words("measured-effective"), number(report.effective_samples.round())),
        (words("measured-fitted"), model.correlations.len().to_string()),
        (words("fit-row-residual"), writer.recorded(model.rms, 4)),
    ];
    // Without the noise of a value χ² is in its unit, and says nothing of how good a fit is.
    if report.sigma.is_some() {
        rows.extend([
            (words("fit-row-chi"), number(model.chi_square)),
            (words("fit-row-reduced"), number(model.reduced)),
        ]);
    }
    rows.extend([
        ("AIC".to_owned(), number(model.criteria.aic)),
        ("AICc".to_owned(), number(model.criteria.aicc)),
        ("BIC".to_owned(), number(model.criteria.bic)),
        (words("measured-evaluations"), report.evaluations.to_string()),
        (words("measured-stop"), words(stop)),
    ]);
    let rows = rows.into_iter().map(|(name, value)| Row::from(vec![name, value])).collect();
    let head = ["measured-head-statistic", "measured-head-number"];
    writer.table(writer.text("measured-statistics-caption"), &head, rows)
}

#[cfg(test)]
mod tests {
    use federpendel_text::Language;

    use super::*;

    #[test]
    fn a_correlation_is_told_from_one() {
        let catalogue = Catalogue::new(Language::German);
        for (value, said) in [
            (0.984, "0,98"),
            (0.9949, "0,99"),
            (-0.9951, "−0,995"),
            (-0.9987, "−0,999"),
            (-0.99962, "−0,9996"),
            (1.0, "1,00"),
        ] {
            assert_eq!(correlation(&catalogue, value), said);
        }
    }
}
