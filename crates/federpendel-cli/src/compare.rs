//! `federpendel compare`: parse, validate, compute, export.

use federpendel::parameter::{TIME_STEP, TOLERANCE, WIDTH};
use federpendel::scheme::Setting;
use federpendel_text::Catalogue;

use crate::args::Compare;
use crate::comparison::{Candidate, Comparison};
use crate::failure::Failure;
use crate::load;
use crate::output::{self, ComparisonReport, Format, Targets};
use crate::progress::Progress;
use crate::quantity::Dimension;
use crate::record::{Method, Record};
use crate::words::{flag_value, nearest};

pub(crate) fn run(arguments: &Compare, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets =
        Targets::of(&arguments.subject, &arguments.results, &Format::IN_FILES, catalogue)?;
    let named = candidates(arguments, catalogue)?;
    let fineness = Fineness::parse(arguments, catalogue)?;
    let copies = named.as_ref().map_or(Candidate::all().len(), Vec::len);
    let experiment = load::experiment(&arguments.subject, copies, catalogue)?;
    let candidates = applicable(named, &experiment.oscillator, catalogue)?;
    let progress = Progress::computing(catalogue, candidates.len() as u64);
    let refused = |error| Failure::core(catalogue, &error);
    let record =
        Record::compute(experiment, Method::Exact, None, &Progress::silent()).map_err(refused)?;
    let setting = fineness.applied_to(Setting::of(&record.motion)).map_err(refused)?;
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
    let near = nearest(name, names.iter().copied());
    let variables = [
        ("name", name.into()),
        ("allowed", names.join(", ").into()),
        ("nearest", near.as_deref().unwrap_or_default().into()),
    ];
    let id = if near.is_some() { "compare-unknown-method-near" } else { "compare-unknown-method" };
    Failure::Input(catalogue.format(id, &variables))
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

/// How finely the methods integrate, as far as the user says.
struct Fineness {
    time_step: Option<f64>,
    tolerance: Option<f64>,
    width: Option<f64>,
}

impl Fineness {
    fn parse(arguments: &Compare, catalogue: &Catalogue) -> Result<Self, Failure> {
        let value = |written: &Option<String>, info, dimension| {
            let parse = |written| flag_value(catalogue, info, dimension, written);
            written.as_deref().map(parse).transpose().map_err(Failure::Input)
        };
        Ok(Fineness {
            time_step: value(&arguments.time_step, &TIME_STEP, Dimension::Time)?,
            tolerance: value(&arguments.tolerance, &TOLERANCE, Dimension::Number)?,
            width: value(&arguments.width, &WIDTH, Dimension::Velocity)?,
        })
    }

    fn applied_to(&self, mut setting: Setting) -> federpendel::Result<Setting> {
        if let Some(time_step) = self.time_step {
            setting = setting.with_time_step(time_step)?;
        }
        if let Some(tolerance) = self.tolerance {
            setting = setting.with_tolerance(tolerance)?;
        }
        if let Some(width) = self.width {
            setting = setting.with_width(width)?;
        }
        Ok(setting)
    }
}
