//! Recordings that tell less than they seem to, and motions that are none of a mass on a spring.

use federpendel::{Coulomb, Friction, Motion, NormalForce, Oscillator, Sample, State};
use federpendel_fit::{
    Fault, Finding, FitError, FitReport, Loss, Options, Quantity, Recording, Standing, fit,
};

mod synthetic;
use synthetic::Random;

const OMEGA: f64 = 6.0;

fn recording(times: Vec<f64>, mut value: impl FnMut(f64) -> f64) -> Recording {
    let values = times.iter().map(|&t| value(t)).collect();
    Recording { times, values, quantity: Quantity::Position, unit: "m".to_owned() }
}

/// 20 s, 50 values a second.
fn times() -> Vec<f64> {
    (0..1000).map(|i| 0.02 * f64::from(i)).collect()
}

/// A decay by Stokes friction, γ = 0.1 1/s, from 10 cm.
fn decay(t: f64) -> f64 {
    0.1 * (-0.1 * t).exp() * (OMEGA * t).cos()
}

fn report(recording: &Recording) -> FitReport {
    fit(recording, &Options::default()).expect("fits")
}

/// Whether a fit says that there is nothing to be told.
fn is_refused(result: &Result<FitReport, FitError>) -> bool {
    match result {
        Ok(report) => !report.adequacy.adequate,
        Err(error) => matches!(error, FitError::NoOscillation { .. }),
    }
}

#[test]
fn noise_and_ramps_are_no_motion() {
    let mut random = Random(4);
    for count in [100, 300, 1000] {
        for quantity in [Quantity::Position, Quantity::Velocity, Quantity::Acceleration] {
            let times: Vec<f64> = times().into_iter().take(count).collect();
            let noise = Recording { quantity, ..recording(times.clone(), |_| random.normal()) };
            let result = fit(&noise, &Options::default());
            assert!(is_refused(&result), "{count} {quantity:?}: {result:?}");
            let ramp = Recording { quantity, ..recording(times.clone(), |t| 0.01 * t) };
            let result = fit(&ramp, &Options::default());
            assert!(is_refused(&result), "{count} {quantity:?}: {result:?}");
        }
    }
}

#[test]
fn few_values_make_no_panic() {
    let mut random = Random(4);
    for count in 12..24 {
        let times: Vec<f64> = times().into_iter().take(count).collect();
        if let Ok(report) = fit(&recording(times, |_| random.normal()), &Options::default()) {
            assert!(report.effective_samples <= count as f64);
        }
    }
}

#[test]
fn what_no_spring_does_is_not_described() {
    let mut random = Random(2);
    let mut noise = || 1e-3 * random.normal();
    let square =
        recording(times(), |t| 0.1 * (-0.1 * t).exp() * (OMEGA * t).cos().signum() + noise());
    let chirp = recording(times(), |t| 0.1 * (OMEGA * t + 0.2 * t * t).cos() + noise());
    let drift = recording(times(), |t| decay(t) + 0.01 * t + noise());
    for (name, recording) in [("square", square), ("chirp", chirp), ("drift", drift)] {
        assert!(!report(&recording).adequacy.adequate, "{name}");
    }
    let drift = recording(times(), |t| decay(t) + 0.01 * t);
    let findings = report(&drift).adequacy.findings;
    assert_eq!(findings.first().map(|finding| finding.fault), Some(Fault::ZeroDrift));
}

#[test]
fn a_robust_loss_leaves_outliers_aside() {
    let mut random = Random(3);
    let mut spoilt = recording(times(), |t| decay(t) + 1e-4 * random.normal());
    spoilt.values.iter_mut().skip(50).step_by(97).for_each(|value| *value += 0.5);
    let least_squares = report(&spoilt);
    assert_eq!(least_squares.outliers, 10);
    let options = Options { loss: Loss::Tukey, ..Options::default() };
    let robust = fit(&spoilt, &options).expect("fits");
    assert!(robust.adequacy.adequate && !least_squares.adequacy.adequate);
    let rate = robust.best().expect("a verdict").value("damping_rate");
    assert!((rate - 0.1).abs() < 1e-3, "{rate}");
}

/// Half a kilogram on 20 N/m under dry friction, released at rest at 10 cm.
fn block(kinetic: f64) -> Motion {
    let coulomb = Coulomb::new(kinetic, kinetic, NormalForce::Weight(9.81)).expect("in range");
    let friction = Friction { coulomb: Some(coulomb), ..Friction::default() };
    let oscillator = Oscillator::new(0.5, 20.0, friction).expect("in range");
    Motion::new(oscillator, State::new(0.1, 0.0).expect("in range")).expect("in range")
}

/// So many even values of a block over `duration`, with noise.
fn recorded(
    (kinetic, quantity): (f64, Quantity),
    (duration, count): (f64, u32),
    sigma: f64,
    seed: u64,
) -> Recording {
    let (motion, mut random) = (block(kinetic), Random(seed));
    let of = |sample: Sample| match quantity {
        Quantity::Position => sample.position,
        Quantity::Velocity => sample.velocity,
        Quantity::Acceleration => sample.acceleration,
    };
    let times = (0..count).map(|i| duration * f64::from(i) / f64::from(count - 1)).collect();
    let value = |t| of(motion.at(t).expect("in range")) + sigma * random.normal();
    Recording { quantity, ..recording(times, value) }
}

#[test]
fn an_acceleration_released_at_rest_has_its_true_minimum() {
    for seed in 1..=20 {
        let recording = recorded((0.05, Quantity::Acceleration), (1.8, 100), 5e-3, seed);
        let report = report(&recording);
        let best = report.best().expect("a verdict");
        let found = best.parameter("coulomb_acceleration").expect("dry friction acts");
        let (value, stderr) = (found.value.expect("a value"), found.stderr.expect("an error"));
        assert!(best.rms < 1.3 * 5e-3, "{seed}: {}", best.rms);
        assert!((value - 0.05 * 9.81).abs() < 5.0 * stderr, "{seed}: {value} ± {stderr}");
    }
}

#[test]
fn noise_feigns_no_rest() {
    // At nearly its full amplitude the mass cannot come to rest.
    for seed in 1..=30 {
        let recording = recorded((3e-4, Quantity::Position), (8.0, 500), 3e-3, seed);
        let report = report(&recording);
        let best = report.best().expect("a verdict");
        assert!(best.rest.is_none(), "{seed}: {:?}", best.rest);
    }
}

#[test]
fn no_law_acts_that_came_out_as_none() {
    // A zero that drifts by little looks like a law that it is not.
    for seed in 1..=20 {
        let mut random = Random(seed);
        let drift = |t: f64| decay(t) + 2e-4 * t + 5e-4 * random.normal();
        let report = report(&recording(times(), drift));
        let best = report.best().expect("a verdict");
        assert!(
            best.parameters.iter().all(|parameter| !parameter.at_bound),
            "{seed}: {}",
            best.mix
        );
        assert!(report.effective_samples <= report.samples as f64);
    }
}

#[test]
fn a_gap_does_not_end_the_recording() {
    // From a third of a period to more than one.
    for lost in 4..=12 {
        for begin in 4..=12 {
            let mut random = Random(lost * 100 + begin);
            let begin = 0.25 * begin as f64;
            let gap = begin..begin + 0.1 * lost as f64;
            let kept = times().into_iter().filter(|t| !gap.contains(t)).collect();
            let report = report(&recording(kept, |t| decay(t) + 1e-3 * random.normal()));
            assert!(
                report.window.from < 2.0 && report.window.to > 19.0,
                "{gap:?}: {:?}",
                report.window
            );
            assert_eq!(report.verdict.laws[0], Standing::Acts, "{gap:?}");
        }
    }
}

#[test]
fn a_period_that_changes_a_little_makes_a_verdict_doubtful() {
    // The phase of a frequency that is higher by `by` A² than at small amplitudes: a weakly cubic spring.
    let decay = |by: f64, t: f64| {
        let ahead = by * OMEGA * (1.0 - (-0.2 * t).exp()) / 0.2;
        0.1 * (-0.1 * t).exp() * (OMEGA * t + ahead).cos()
    };
    for (by, fault) in
        [(6e-3, Some(Fault::Hardening)), (-6e-3, Some(Fault::Softening)), (0.0, None)]
    {
        let mut random = Random(3);
        let adequacy =
            report(&recording(times(), |t| decay(by, t) + 5e-4 * random.normal())).adequacy;
        assert!(adequacy.adequate, "{adequacy:?}");
        assert_eq!(adequacy.slight().map(|finding| finding.fault), fault, "{adequacy:?}");
        let close = |finding: &Finding| (0.5..1.5).contains(&(finding.effect / by.abs()));
        assert!(adequacy.slight().is_none_or(close), "{adequacy:?}");
    }
}
