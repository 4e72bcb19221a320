//! What was found: the recording with the fit, and the values.

use std::f64::consts::PI;

use federpendel_fit::Parameter;

use super::writer::{Writer, parameter_name, set, unbroken};
use crate::document::{Block, Row, Section, literal};

/// The figure and the table of values.
pub fn section(writer: &Writer<'_>) -> Section {
    writer.section("result", "measured-result", blocks(writer))
}

/// What stands in it.
pub fn blocks(writer: &Writer<'_>) -> Vec<Block> {
    let mut blocks = vec![figure(writer)];
    if !writer.fit.report.adequacy.adequate {
        let variables = [("mix", writer.mix().into())];
        blocks.push(Block::Notice(writer.catalogue.format("measured-closest", &variables)));
    }
    blocks.push(values(writer));
    blocks
}

fn figure(writer: &Writer<'_>) -> Block {
    let variables = [("name", literal(writer.name).into()), ("mix", writer.mix().into())];
    Block::Figure {
        id: writer.id("figure-fit"),
        // Who cannot draw them draws their own.
        plots: if cfg!(feature = "pages") {
            writer.fit.plots(writer.catalogue).into()
        } else {
            vec![]
        },
        caption: writer.catalogue.format("measured-fit-caption", &variables),
    }
}

fn values(writer: &Writer<'_>) -> Block {
    let mut rows = Vec::new();
    for parameter in writer.fit.report.best().into_iter().flat_map(|model| &model.parameters) {
        let unit = writer.fit.report.unit_of(parameter.name);
        if parameter.name == "angular_frequency" {
            let name = writer.text("fit-row-frequency");
            rows.push(row(writer, name, &over(parameter, 2.0 * PI), "Hz"));
        }
        let name = set(&writer.text(parameter_name(parameter)));
        rows.push(row(writer, name, parameter, &unit));
    }
    let head = [
        "measured-head-parameter",
        "measured-head-value",
        "measured-head-interval",
        "measured-head-unit",
    ];
    writer.table(writer.text("measured-values-caption"), &head, rows)
}

/// The parameter in a unit that is `size` times as large.
fn over(parameter: &Parameter, size: f64) -> Parameter {
    let over = |value: Option<f64>| value.map(|value| value / size);
    let (low, high) = parameter.interval95;
    let interval95 = (over(low), over(high));
    let (value, stderr) = (over(parameter.value), over(parameter.stderr));
    Parameter { value, stderr, interval95, ..*parameter }
}

fn row(writer: &Writer<'_>, name: String, parameter: &Parameter, unit: &str) -> Row {
    let error = parameter.stderr.unwrap_or(f64::NAN);
    let value = match parameter.value {
        Some(value) => writer.catalogue.measured(value, error, "1"),
        None => writer.none(),
    };
    let middle = parameter.value.unwrap_or(f64::NAN);
    let interval = writer.catalogue.interval(parameter.interval95, middle, error, "1");
    let unit = if unit.is_empty() || unit == "1" { writer.none() } else { literal(&typeset(unit)) };
    Row::from(vec![name, unbroken(&value), unbroken(&interval), unit])
}

/// A unit as it is printed.
fn typeset(unit: &str) -> String {
    unit.replace("^2", "²").replace("^3", "³")
}
