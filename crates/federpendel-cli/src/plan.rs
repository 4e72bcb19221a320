//! `federpendel plan`: parse, validate, compute, export.

use federpendel::parameter::{ParameterInfo, Range};
use federpendel_fit::Quantity;
use federpendel_fit::plan::{Setup, plan};
use federpendel_report::plan::plan_error;
use federpendel_text::Catalogue;

use crate::args::Plan;
use crate::experiment::{Experiment, Field};
use crate::failure::Failure;
use crate::fit::laws;
use crate::load;
use crate::output::{self, Format, Targets};
use crate::quantity::Dimension;
use crate::sensor::{self, NOISE};
use crate::words::flag_value;

/// Values per second.
const RATE: ParameterInfo = positive("rate", "Hz", Some(50.0));
/// The range of amplitudes.
const MIN: ParameterInfo = positive("min_amplitude", "m", None);
const MAX: ParameterInfo = positive("max_amplitude", "m", None);

const fn positive(name: &'static str, unit: &'static str, default: Option<f64>) -> ParameterInfo {
    ParameterInfo { name, symbol: "", unit, range: Range::Positive, default }
}

pub(crate) fn run(arguments: &Plan, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets =
        Targets::of(&arguments.subject, &arguments.results, &Format::IN_FILES, catalogue)?;
    let (quantity, noise) = noise(arguments, catalogue)?;
    let value = |written: &Option<String>, info, dimension| {
        let parse = |written: &String| flag_value(catalogue, info, dimension, written);
        written.as_ref().map(parse).transpose().map_err(Failure::Input)
    };
    let rate = value(&arguments.rate, &RATE, Dimension::Frequency)?.or(RATE.default);
    let min_amplitude = value(&arguments.min_amplitude, &MIN, Dimension::Length)?;
    let max_amplitude = value(&arguments.max_amplitude, &MAX, Dimension::Length)?;
    let also = laws(Some(arguments.laws.as_deref().unwrap_or("none")), catalogue)?.mix();
    if arguments.subject.overrides.iter().any(|(field, _)| *field == Field::Samples) {
        return Err(Failure::Input(catalogue.text("plan-no-samples")));
    }
    let experiment = load::experiment(&arguments.subject, 0, catalogue)?;
    let setup = Setup {
        oscillator: experiment.oscillator,
        also,
        quantity,
        noise,
        rate: rate.unwrap_or_default(),
        min_amplitude,
        max_amplitude: max_amplitude.map_or_else(|| release(&experiment, catalogue), Ok)?,
        longest: experiment.duration,
    };
    let plan = plan(&setup).map_err(|error| Failure::Input(plan_error(catalogue, &error)))?;
    output::write_plan(&plan, &targets, catalogue)
}

/// What is recorded, and how noisily.
fn noise(arguments: &Plan, catalogue: &Catalogue) -> Result<(Quantity, f64), Failure> {
    let Some(written) = &arguments.noise else {
        return Err(Failure::Input(catalogue.text("plan-no-noise")));
    };
    let info = ParameterInfo { range: Range::Positive, ..NOISE };
    sensor::noise(written, arguments.quantity, &info, catalogue)
}

/// The amplitude of the experiment's own release.
fn release(experiment: &Experiment, catalogue: &Catalogue) -> Result<f64, Failure> {
    let (release, omega) = (experiment.release, experiment.oscillator.angular_frequency());
    match release.position.hypot(release.velocity / omega) {
        0.0 => Err(Failure::Input(catalogue.text("plan-no-release"))),
        amplitude => Ok(amplitude),
    }
}
