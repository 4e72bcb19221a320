//! `federpendel simulate`: parse, validate, compute, export.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use federpendel::Error;
use federpendel_text::Catalogue;
use sysinfo::{MemoryRefreshKind, RefreshKind, System};

use crate::args::Simulate;
use crate::experiment::{self, BUILT_IN, Experiment, LARGEST_FILE};
use crate::failure::{Failure, note};
use crate::output::{self, Targets};
use crate::progress::Progress;
use crate::record::{BYTES_PER_SAMPLE, Method, Record, TooLong};
use crate::words::{experiment_error, time_step_value, too_long_step};

/// Memory taken to be free on a system that does not say, bytes.
const UNKNOWN_MEMORY: u64 = 1 << 30;

pub(crate) fn run(arguments: &Simulate, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets = Targets::check(arguments, catalogue)?;
    let time_step = time_step(arguments, catalogue)?;
    let experiment = experiment(arguments, catalogue)?;
    let record = compute(experiment, arguments.method, time_step, catalogue)?;
    if let Some(problem) = record.too_long_step() {
        let label = console::style(catalogue.text("cli-warning")).for_stderr().yellow().bold();
        note(&format!("{label}: {}", too_long_step(catalogue, problem)));
    }
    output::write(&record, &targets, catalogue)
}

/// The experiment of the file, or the built-in one, with the overrides.
fn experiment(arguments: &Simulate, catalogue: &Catalogue) -> Result<Experiment, Failure> {
    let (name, bytes) = match &arguments.experiment {
        Some(path) => (Some(path.display().to_string()), read(path, catalogue)?),
        None => (None, BUILT_IN.as_bytes().to_vec()),
    };
    let overrides = arguments.overrides.iter().map(|(field, quantity)| (*field, quantity.as_str()));
    experiment::parse(&bytes)
        .and_then(|mut draft| {
            draft.override_with(overrides)?;
            draft.resolve(samples_that_fit())
        })
        .map_err(|error| Failure::Input(experiment_error(catalogue, &error, name.as_deref())))
}

/// The bytes of an experiment file, of `-` those of standard input; no more than decide its fate.
fn read(path: &Path, catalogue: &Catalogue) -> Result<Vec<u8>, Failure> {
    let limit = LARGEST_FILE as u64 + 1;
    let mut bytes = Vec::new();
    let done = if path == Path::new("-") {
        std::io::stdin().take(limit).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes))
    };
    done.map_err(|error| Failure::system(catalogue, &path.display().to_string(), &error))?;
    Ok(bytes)
}

/// Half of the memory that is free, in samples: the rest is for the system and for plots.
fn samples_that_fit() -> usize {
    let memory = RefreshKind::nothing().with_memory(MemoryRefreshKind::nothing().with_ram());
    let free = match System::new_with_specifics(memory) {
        Ok(system) => {
            let container = system.cgroup_limits().map_or(u64::MAX, |limits| limits.free_memory);
            system.available_memory().min(container)
        }
        Err(_) => UNKNOWN_MEMORY,
    };
    usize::try_from(free / 2 / BYTES_PER_SAMPLE).unwrap_or(usize::MAX)
}

/// The time step, if one is given; only the scheme takes steps.
fn time_step(arguments: &Simulate, catalogue: &Catalogue) -> Result<Option<f64>, Failure> {
    let Some(written) = &arguments.time_step else { return Ok(None) };
    if arguments.method != Method::ArticleScheme {
        let variables =
            [("value", written.as_str().into()), ("method", arguments.method.name().into())];
        return Err(Failure::Input(catalogue.format("cli-dt-without-scheme", &variables)));
    }
    time_step_value(catalogue, written).map(Some).map_err(Failure::Input)
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
