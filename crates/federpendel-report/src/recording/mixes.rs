//! How the mixes stand beside each other.

use federpendel::Mix;
use federpendel_fit::Model;

use super::writer::{Writer, unbroken};
use crate::document::{Row, Section};

/// Below this a probability is as good as none.
const LEAST: f64 = 1e-4;

/// The ranking in a table.
pub fn section(writer: &Writer<'_>) -> Section {
    let models = &writer.fit.report.models;
    let head = [
        "measured-head-mix",
        "measured-head-aicc",
        "measured-head-bic",
        "measured-head-rms",
        "measured-head-p",
    ];
    let rows = models.iter().map(|model| row(writer, model)).collect();
    let table = writer.table(writer.text("measured-mixes-caption"), &head, rows);
    let text = writer.say("measured-mixes-text", &[("count", models.len().into())]);
    writer.section("mixes", "measured-mixes", vec![text, table])
}

/// The ranking in a sentence.
pub fn brief(writer: &Writer<'_>) -> String {
    let mix = |model: &Model| {
        let variables = [
            ("mix", writer.catalogue.mix(model.mix).into()),
            ("difference", difference(writer, model, |model| model.criteria.aicc).into()),
        ];
        writer.catalogue.format("measured-brief-mix", &variables)
    };
    let mixes: Vec<_> = writer.fit.report.models.iter().map(mix).collect();
    writer.catalogue.format("measured-brief-mixes", &[("mixes", mixes.join("; ").into())])
}

fn row(writer: &Writer<'_>, model: &Model) -> Row {
    let report = &writer.fit.report;
    let chosen = model.mix == report.verdict.mix;
    let cells = vec![
        name(writer, model.mix),
        difference(writer, model, |model| model.criteria.aicc),
        difference(writer, model, |model| model.criteria.bic),
        writer.recorded(model.rms, 4),
        report.rejection(model.mix).map_or(writer.none(), |p| probability(writer, p)),
    ];
    Row { marked: chosen, ..Row::from(cells) }
}

/// The mix in words, and whether it is the verdict's.
fn name(writer: &Writer<'_>, mix: Mix) -> String {
    let report = &writer.fit.report;
    let name = writer.catalogue.mix(mix);
    let id = match (mix == report.verdict.mix, report.adequacy.adequate) {
        (false, _) => return name,
        (true, true) => "measured-verdict",
        (true, false) => "measured-nearest",
    };
    writer.catalogue.format(id, &[("mix", name.into())])
}

/// By how much a criterion exceeds the best, to a tenth.
fn difference(writer: &Writer<'_>, model: &Model, of: fn(&Model) -> f64) -> String {
    let best = writer.fit.report.models.iter().map(of).fold(f64::INFINITY, f64::min);
    writer.catalogue.fixed(of(model) - best, 1)
}

fn probability(writer: &Writer<'_>, p: f64) -> String {
    if p >= LEAST {
        return writer.catalogue.number(p, 2);
    }
    let least = writer.catalogue.number(LEAST, 1);
    unbroken(&writer.catalogue.format("measured-below", &[("value", least.into())]))
}
