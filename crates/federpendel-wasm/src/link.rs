//! An experiment as the end of an address, `1;mass=0.5;stiffness=20;…;laws=stokes+coulomb;hanging=no;duration=5.5`.
//!
//! The number in front is the version. What a version has once meant it means for ever: a link in a worksheet is older
//! than the page that it opens. Every value is written, so that no later default changes an old link.

use federpendel::Mix;
use federpendel::parameter::{self, ParameterInfo};

use crate::experiment::{Experiment, Laws};
use crate::parameters::CONTROLS;

/// The version that is written.
const VERSION: &str = "1";

/// The experiment as text; it gives back the same numbers, bit for bit.
pub fn encode(experiment: &Experiment) -> String {
    let mut parts = vec![VERSION.to_owned()];
    for (info, _, default) in &CONTROLS {
        let value = experiment.values.get(info.name).unwrap_or(default);
        parts.push(format!("{}={value:?}", info.name));
    }
    parts.push(format!("laws={}", Mix::from(experiment.laws)));
    parts.push(format!("hanging={}", if experiment.hanging { "yes" } else { "no" }));
    parts.push(format!("duration={:?}", experiment.duration));
    parts.join(";")
}

/// The experiment of a text; none if its version is not known, or a value cannot be read or is not allowed: another
/// experiment than the one that was meant looks like that one. Names that are not known are passed over, and what is
/// missing has its value to begin with.
pub fn decode(text: &str) -> Option<Experiment> {
    let rest = text.trim_start_matches('#').strip_prefix(VERSION)?;
    let rest = if rest.is_empty() { rest } else { rest.strip_prefix(';')? };
    let mut experiment = Experiment::default();
    for (name, value) in rest.split(';').filter_map(|part| part.split_once('=')) {
        match name {
            "laws" => experiment.laws = laws(value)?,
            "hanging" => experiment.hanging = value == "yes",
            "duration" => experiment.duration = read(&parameter::DURATION, value)?,
            _ => {
                if let Some((info, _, _)) = CONTROLS.iter().find(|(info, _, _)| info.name == name) {
                    experiment.values.insert(name.to_owned(), read(info, value)?);
                }
            }
        }
    }
    Some(experiment)
}

/// The laws of "stokes+coulomb"; some programs that pass links on make a space of the plus.
fn laws(text: &str) -> Option<Laws> {
    let mut laws = Laws::default();
    for name in text.split(['+', ' ']) {
        match name {
            "stokes" => laws.stokes = true,
            "coulomb" => laws.coulomb = true,
            "newton" => laws.newton = true,
            "none" => {}
            _ => return None,
        }
    }
    Some(laws)
}

/// A number that is allowed.
fn read(info: &ParameterInfo, text: &str) -> Option<f64> {
    text.parse().ok().filter(|value| info.range.contains(*value))
}
