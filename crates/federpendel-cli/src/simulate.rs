//! `federpendel simulate`: parse, validate, compute, export.

use federpendel::{Error, parameter};
use federpendel_text::Catalogue;

use crate::args::Simulate;
use crate::experiment::Experiment;
use crate::failure::{Failure, note};
use crate::load;
use crate::output::{self, Format, MotionReport, Targets};
use crate::progress::Progress;
use crate::quantity::Dimension;
use crate::record::{Method, Record, TooLong};
use crate::sensor::Sensor;
use crate::words::{flag_value, too_long_step};

pub(crate) fn run(arguments: &Simulate, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets =
        Targets::of(&arguments.subject, &arguments.results, &Format::IN_FILES, catalogue)?;
    let time_step = time_step(arguments, catalogue)?;
    let sensor = sensor(arguments, &targets, catalogue)?;
    let experiment = load::experiment(&arguments.subject, 0, catalogue)?;
    let record = compute(experiment, arguments.method, time_step, catalogue)?;
    if let Some(problem) = record.too_long_step() {
        let label = console::style(catalogue.text("cli-warning")).for_stderr().yellow().bold();
        note(&format!("{label}: {}", too_long_step(catalogue, problem)));
    }
    let report = MotionReport { record: &record, picture: arguments.picture, sensor };
    output::write(&report, &targets, catalogue)
}

/// The sensor, if there is noise; it records tables.
fn sensor(
    arguments: &Simulate,
    targets: &Targets,
    catalogue: &Catalogue,
) -> Result<Option<Sensor>, Failure> {
    let refuse = |id: &str| Err(Failure::Input(catalogue.text(id)));
    let Some(written) = &arguments.noise else {
        return if arguments.seed.is_some() { refuse("cli-seed-without-noise") } else { Ok(None) };
    };
    if !targets.has(Format::Csv) {
        return refuse("cli-noise-without-csv");
    }
    Sensor::named(written, arguments.seed.unwrap_or(0), catalogue).map(Some)
}

/// The time step, if one is given; only the scheme takes steps.
fn time_step(arguments: &Simulate, catalogue: &Catalogue) -> Result<Option<f64>, Failure> {
    let Some(written) = &arguments.time_step else { return Ok(None) };
    if arguments.method != Method::ArticleScheme {
        let variables =
            [("value", written.as_str().into()), ("method", arguments.method.name().into())];
        return Err(Failure::Input(catalogue.format("cli-dt-without-scheme", &variables)));
    }
    flag_value(catalogue, &parameter::TIME_STEP, Dimension::Time, written)
        .map(Some)
        .map_err(Failure::Input)
}

fn compute(
    experiment: Experiment,
    method: Method,
    time_step: Option<f64>,
    catalogue: &Catalogue,
) -> Result<Record, Failure> {
    // A method other than the exact one goes through the samples once more.
    let passes = if method == Method::Exact { 1 } else { 2 };
    let steps = passes * experiment.samples as u64;
    let progress = Progress::computing(catalogue, steps);
    let (oscillator, release) = (experiment.oscillator, experiment.release);
    Record::compute(experiment, method, time_step, &progress).map_err(|error| {
        let unstable = match error {
            Error::Diverged { time_step, .. } => TooLong::unstable(&oscillator, release, time_step),
            _ => None,
        };
        match unstable {
            Some(problem) => Failure::Input(too_long_step(catalogue, problem)),
            None => Failure::core(catalogue, &error),
        }
    })
}
