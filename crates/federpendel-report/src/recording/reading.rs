//! What was read, which part of it was fitted, and whether the model suits it.

use federpendel_fit::read::Clock;
use federpendel_fit::{Fault, Finding, Quantity, Window};
use federpendel_text::excerpt;

use super::note::{edge, read_note};
use super::writer::Writer;
use crate::document::{Block, Row, Section, literal};

/// Digits of a time.
const DIGITS: usize = 5;

/// The recording, the notes of its reader, what the residuals say.
pub fn section(writer: &Writer<'_>) -> Section {
    let mut blocks = vec![table(writer)];
    blocks.extend(notes(writer));
    blocks.extend(findings(writer));
    writer.section("reading", "measured-reading", blocks)
}

/// The same in a few points.
pub fn brief(writer: &Writer<'_>) -> Vec<String> {
    let report = &writer.fit.report;
    let Window { from, to, begins, ends, .. } = report.window;
    let time = |value: f64| writer.catalogue.quantity(value, "s", DIGITS).into();
    let part = [
        ("from", time(from)),
        ("to", time(to)),
        ("samples", report.samples.into()),
        ("effective", writer.catalogue.number(report.effective_samples.round(), 4).into()),
        ("column", literal(&excerpt(&writer.fit.read.value.label)).into()),
        ("rms", writer.recorded(report.best().map_or(f64::NAN, |model| model.rms), 3).into()),
    ];
    let edges = [
        ("begins", edge(writer.catalogue, begins).into()),
        ("ends", edge(writer.catalogue, ends).into()),
    ];
    let mut points = vec![
        writer.catalogue.format("measured-brief-part", &part),
        writer.catalogue.format("measured-brief-edges", &edges),
    ];
    let read = &writer.fit.read.notes;
    points.extend(read.iter().map(|note| literal(&read_note(writer.catalogue, note))));
    points.extend(report.adequacy.findings.iter().map(|finding| said(writer, finding)));
    points
}

fn table(writer: &Writer<'_>) -> Block {
    let (fit, catalogue) = (writer.fit, writer.catalogue);
    let (report, read) = (&fit.report, &fit.read);
    let mut rows = Vec::new();
    let mut row = |id: &str, value: String| {
        rows.push(Row::from(vec![catalogue.text(id), literal(&value)]));
    };
    row("measured-file", fit.name.clone());
    if let Some(run) = &read.run {
        row("measured-run", run.clone());
    }
    row("measured-values-column", excerpt(&read.value.label));
    match &read.clock {
        Clock::Column(column) => row("measured-times-column", excerpt(&column.label)),
        Clock::Rate(rate) => row("measured-rate", catalogue.quantity(*rate, "Hz", DIGITS)),
    }
    row("measured-quantity", catalogue.text(quantity(report.quantity)));
    row(
        "measured-unit",
        match report.unit.as_str() {
            "" => catalogue.text("measured-unit-none"),
            unit => unit.replace("^2", "²"),
        },
    );
    let times = &read.recording.times;
    let span = |from: f64, to: f64, samples: usize| {
        let time = |value: f64| catalogue.quantity(value, "s", DIGITS).into();
        let variables = [("from", time(from)), ("to", time(to)), ("samples", samples.into())];
        catalogue.format("measured-length-value", &variables)
    };
    row("measured-length", span(times[0], times[times.len() - 1], times.len()));
    let Window { from, to, begins, ends, .. } = report.window;
    row("fit-row-window", span(from, to, report.samples));
    row("fit-row-begins", edge(catalogue, begins));
    row("fit-row-ends", edge(catalogue, ends));
    if let Some(rest) = report.best().and_then(|model| model.rest) {
        let variables = [
            ("time", catalogue.quantity(rest.time, "s", DIGITS).into()),
            ("position", catalogue.quantity(rest.position, &report.length_unit(), 3).into()),
            ("turns", rest.turning_points.into()),
        ];
        row("measured-rest", catalogue.format("measured-rest-value", &variables));
    }
    let head = ["measured-head-what", "measured-head-said"];
    writer.table(catalogue.text("measured-reading-caption"), &head, rows)
}

/// What is recorded, in a word.
fn quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Position => "fit-quantity-position",
        Quantity::Velocity => "fit-quantity-velocity",
        Quantity::Acceleration => "fit-quantity-acceleration",
    }
}

fn notes(writer: &Writer<'_>) -> Vec<Block> {
    let notes = &writer.fit.read.notes;
    if notes.is_empty() {
        return vec![];
    }
    let notes = notes.iter().map(|note| literal(&read_note(writer.catalogue, note)));
    vec![writer.say("measured-notes", &[]), Block::List(notes.collect())]
}

fn findings(writer: &Writer<'_>) -> Vec<Block> {
    let findings = &writer.fit.report.adequacy.findings;
    if findings.is_empty() {
        return vec![writer.say("measured-findings-none", &[])];
    }
    let said = findings.iter().map(|finding| said(writer, finding)).collect();
    vec![writer.say("measured-findings", &[]), Block::List(said)]
}

/// A pattern in the residuals, in words.
fn said(writer: &Writer<'_>, finding: &Finding) -> String {
    let effect = format!("{} %", writer.catalogue.number(100.0 * finding.effect, 2));
    let id = match finding.fault {
        Fault::Softening => "measured-finding-softening",
        Fault::Hardening => "measured-finding-hardening",
        Fault::PeriodDrift => "measured-finding-period-drift",
        Fault::Losses if writer.fit.grows() => "measured-finding-growing",
        Fault::Losses => "measured-finding-losses",
        Fault::ZeroDrift => "measured-finding-zero-drift",
        Fault::Shape => "measured-finding-shape",
        Fault::Residual => "measured-finding-residual",
    };
    let said = writer.catalogue.format(id, &[("effect", effect.into())]);
    let weight = if finding.grave { "measured-grave" } else { "measured-slight" };
    writer.catalogue.format(weight, &[("finding", said.into())])
}
