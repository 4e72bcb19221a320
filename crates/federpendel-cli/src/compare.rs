//! `federpendel compare`: parse, validate, compute, export.

use federpendel::parameter::{TIME_STEP, TOLERANCE, WIDTH};
use federpendel::scheme::Setting;
use federpendel_text::Catalogue;

use crate::args::Compare;
use crate::comparison::{Candidate, Comparison};
use crate::failure::Failure;
use crate::load;
use crate::output::{self, ComparisonReport, Targets};
use crate::progress::Progress;
use crate::quantity::Dimension;
use crate::record::{Method, Record};
use crate::words::flag_value;

pub(crate) fn run(arguments: &Compare, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets = Targets::check(&arguments.subject, &arguments.results, catalogue)?;
    let named = candidates(arguments, catalogue)?;
    let experiment = load::experiment(&arguments.subject, Candidate::all().len(), catalogue)?;
    let candidates = applicable(named, &experiment.oscillator, catalogue)?;
    let progress = Progress::computing(catalogue, candidates.len() as u64);
    let record = Record::compute(experiment, Method::Exact, None, &Progress::silent())
        .map_err(|error| Failure::core(catalogue, &error))?;
    let setting = setting(arguments, &record, catalogue)?;
    let comparison = Comparison::compute(record, candidates, &setting, &progress);
    drop(progress);
    let report = ComparisonReport { comparison: &comparison, picture: arguments.picture };
    output::write(&report, &targets, catalogue)
}

/// The methods named, if any are.
fn candidates(
    arguments: &Compare,
    catalogue: &Catalogue,
) -> Result<Option<Vec<Candidate>>, Failure> {
    let Some(against) = &arguments.against else { return Ok(None) };
    let mut named: Vec<Candidate> = Vec::new();
    for name in against.split(',').map(str::trim) {
        let candidate = Candidate::named(name).ok_or_else(|| unknown(name, catalogue))?;
        if named.iter().all(|other| other.name() != candidate.name()) {
            named.push(candidate);
        }
    }
    Ok(Some(named))
}

fn unknown(name: &str, catalogue: &Catalogue) -> Failure {
    let names: Vec<_> = Candidate::all().into_iter().map(Candidate::name).collect();
    Failure::Input(catalogue.format(
        "compare-unknown-method",
        &[("name", name.into()), ("allowed", names.join(", ").into())],
    ))
}

/// The methods named, each of which must apply; or else all that do.
fn applicable(
    named: Option<Vec<Candidate>>,
    oscillator: &federpendel::Oscillator,
    catalogue: &Catalogue,
) -> Result<Vec<Candidate>, Failure> {
    let Some(named) = named else {
        let mut all = Candidate::all();
        all.retain(|candidate| candidate.applies(oscillator).is_ok());
        return Ok(all);
    };
    for candidate in &named {
        candidate.applies(oscillator).map_err(|error| {
            let variables =
                [("name", candidate.name().into()), ("reason", catalogue.error(&error).into())];
            Failure::Input(catalogue.format("compare-does-not-apply", &variables))
        })?;
    }
    Ok(named)
}

/// How finely the methods integrate.
fn setting(
    arguments: &Compare,
    record: &Record,
    catalogue: &Catalogue,
) -> Result<Setting, Failure> {
    let mut setting = Setting::of(&record.motion);
    let value = |written: &Option<String>, info, dimension| {
        let value = written.as_ref().map(|written| flag_value(catalogue, info, dimension, written));
        value.transpose().map_err(Failure::Input)
    };
    let refused = |error| Failure::core(catalogue, &error);
    if let Some(step) = value(&arguments.time_step, &TIME_STEP, Dimension::Time)? {
        setting = setting.with_time_step(step).map_err(refused)?;
    }
    if let Some(tolerance) = value(&arguments.tolerance, &TOLERANCE, Dimension::Number)? {
        setting = setting.with_tolerance(tolerance).map_err(refused)?;
    }
    if let Some(width) = value(&arguments.width, &WIDTH, Dimension::Velocity)? {
        setting = setting.with_width(width).map_err(refused)?;
    }
    Ok(setting)
}
