//! The recordings of `examples/recordings`: still what the laboratory makes, and their truth found.

mod laboratory;
mod synthetic;

use std::path::PathBuf;

use federpendel_fit::read::{Choice, Read, recordings};
use federpendel_fit::{Options, fit};
use laboratory::{EXPERIMENTS, Experiment, files};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples/recordings")
}

fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).expect(name)
}

#[test]
fn they_are_what_the_laboratory_makes() {
    for (name, made) in files().expect("recordings") {
        assert!(bytes(name) == made, "{name} is another: run the example recordings");
    }
}

/// The coefficients of the verdict, and the truth of each, in standard errors.
fn check(experiment: &Experiment) {
    let name = experiment.name;
    let reads = recordings(&bytes(experiment.file()), &Choice::default()).expect(name);
    let wanted =
        |read: &Read| name.split_once('#').is_none_or(|(_, run)| read.run.as_deref() == Some(run));
    let read = reads.into_iter().find(wanted).expect(name);
    assert_eq!(read.recording.quantity, experiment.quantity, "{name}");
    let report = fit(&read.recording, &Options::default()).expect(name);
    assert!(report.adequacy.adequate, "{name}");
    let mix = report.verdict.mix;
    let [_, gamma, dry, kappa] = experiment.truth();
    let acts = [gamma, dry, kappa].map(|coefficient| coefficient > 0.0);
    assert_eq!([mix.stokes, mix.coulomb, mix.newton], acts, "{name}");
    let best = report.best().expect(name);
    let names = ["angular_frequency", "damping_rate", "coulomb_acceleration", "newton_rate"];
    for (parameter, truth) in names.into_iter().zip(experiment.truth()) {
        let Some(found) = best.parameter(parameter) else { continue };
        let (value, stderr) = (found.value.expect(name), found.stderr.expect(name));
        assert!(
            (value - truth).abs() < 3.5 * stderr,
            "{name}: {parameter} {value} ± {stderr}, not {truth}"
        );
    }
}

#[test]
fn their_truth_is_found() {
    EXPERIMENTS.iter().for_each(check);
}
