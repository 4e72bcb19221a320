//! First values that do not belong to the motion, motions that no cut makes fit, mixes asked for that do not fit, and rests that
//! come too soon to tell much.

use federpendel::Mix;
use federpendel_fit::{Edge, Fault, Laws, Options, Parameters, Quantity, Recording, fit};

mod synthetic;
use synthetic::Random;

/// 15 s, 50 values a second, of a decay by Stokes friction on a spring that is stiffer by `harder` at 10 cm, by RK4.
fn hardening(harder: f64, seed: u64) -> Recording {
    let (mut random, mut state, step) = (Random(seed), (0.1, 0.0), 0.002);
    let force = |(x, v): (f64, f64)| {
        let stiffer = 1.0 + harder * (x / 0.1_f64).powi(2);
        (v, -39.5 * stiffer * x - 0.2 * v)
    };
    let add = |a: (f64, f64), h: f64, b: (f64, f64)| (a.0 + h * b.0, a.1 + h * b.1);
    let (mut times, mut values) = (Vec::new(), Vec::new());
    for i in 0..7500 {
        if i % 10 == 0 {
            times.push(step * f64::from(i));
            values.push(state.0 + 5e-4 * random.normal());
        }
        let one = force(state);
        let two = force(add(state, step / 2.0, one));
        let three = force(add(state, step / 2.0, two));
        let four = force(add(state, step, three));
        let sum = add(add(add(one, 2.0, two), 2.0, three), 1.0, four);
        state = add(state, step / 6.0, sum);
    }
    Recording { times, values, quantity: Quantity::Position, unit: "m".to_owned() }
}

#[test]
fn no_cut_makes_a_hardening_spring_fit() {
    for seed in 1..=3 {
        let report = fit(&hardening(0.08, seed), &Options::default()).expect("fits");
        assert!(!report.adequacy.adequate, "{seed}: {}", report.verdict.mix);
        assert_ne!(report.window.begins, Edge::Misfit, "{seed}: {:?}", report.window);
    }
}

#[test]
fn first_values_of_a_hand_are_left_out() {
    let mut held = hardening(0.0, 5);
    // The hand lets go late: it takes the mass along for the first tenth of a second.
    held.values[..5].iter_mut().enumerate().for_each(|(i, value)| *value += 0.01 * (5 - i) as f64);
    let report = fit(&held, &Options::default()).expect("fits");
    assert!(report.adequacy.adequate, "{:?}", report.adequacy);
    assert_eq!(report.window.begins, Edge::Misfit);
    assert!(report.window.from < 1.0, "{:?}", report.window);
}

/// A decay by Stokes friction as [`hardening`] without hardening, fitted with this mix.
fn asked(mix: Mix) -> federpendel_fit::FitReport {
    let options = Options { laws: Laws::Exactly(mix), ..Options::default() };
    fit(&hardening(0.0, 7), &options).expect("fits")
}

#[test]
fn a_mix_asked_for_that_others_beat_is_known_to_be_rejected() {
    let (stokes, newton) =
        (Mix { stokes: true, ..Mix::default() }, Mix { newton: true, ..Mix::default() });
    assert!(asked(stokes).asked_rejection.is_some_and(|p| p > 0.01));
    let wrong = asked(newton);
    assert!(wrong.asked_rejection.is_some_and(|p| p < 1e-6), "{:?}", wrong.asked_rejection);
    // All laws say that it begins there.
    assert_eq!(wrong.window.begins, Edge::Recording);
    let every = Mix { stokes: true, coulomb: true, newton: true };
    assert_eq!(asked(every).asked_rejection, None);
    let auto = fit(&hardening(0.0, 7), &Options::default()).expect("fits");
    assert_eq!(auto.asked_rejection, None);
}

/// Released at rest at 10 cm under dry friction of this a_c, ω0 = 6.3 1/s, 3 s.
fn dry(coulomb_acceleration: f64, seed: u64) -> Recording {
    let truth = Parameters {
        angular_frequency: 6.3,
        damping_rate: 0.0,
        coulomb_acceleration,
        newton_rate: 0.0,
        position0: 0.1,
        velocity0: 0.0,
        equilibrium: 0.0,
    };
    let motion = truth.motion(coulomb_acceleration).expect("in range");
    let times: Vec<f64> = (0..300).map(|i| 0.01 * f64::from(i)).collect();
    let mut random = Random(seed);
    let samples = motion.samples(&times).expect("in range");
    let values = samples.iter().map(|sample| sample.position + 5e-4 * random.normal()).collect();
    Recording { times, values, quantity: Quantity::Position, unit: "m".to_owned() }
}

#[test]
fn one_swing_before_the_rest_bounds_dry_friction_from_below_only() {
    for (truth, seed) in [(1.5, 1), (2.0, 2), (2.5, 3), (3.2, 4), (2.5, 5)] {
        let report = fit(&dry(truth, seed), &Options::default()).expect("fits");
        let model = report.best().expect("a verdict");
        let found = model.parameter("coulomb_acceleration").expect("dry friction acts");
        assert_eq!((found.value, found.stderr), (None, None), "{truth} {seed}");
        let (Some(least), None) = found.interval95 else { panic!("{:?}", found.interval95) };
        // It rests at x0 − 2f, half of whose distance from x0 − f is the least offset.
        let expected = (0.1 * 6.3 * 6.3 - truth) / 2.0;
        assert!(
            (0.93 * expected..=truth.min(1.03 * expected)).contains(&least),
            "{truth}: {least}"
        );
        let rest = model.rest.expect("it rests");
        assert!((rest.time - 0.5).abs() < 0.02, "{truth}: {}", rest.time);
        let fixed = model.parameter("static_acceleration").expect("it rests").interval95;
        assert!(fixed.0.is_some_and(|low| low <= truth) && fixed.1.is_none(), "{fixed:?}");
    }
    // Two swings tell.
    let report = fit(&dry(1.1, 6), &Options::default()).expect("fits");
    let found =
        *report.best().and_then(|best| best.parameter("coulomb_acceleration")).expect("acts");
    let (value, stderr) = (found.value.expect("a value"), found.stderr.expect("an error"));
    assert!((value - 1.1).abs() < 4.0 * stderr && stderr < 0.05, "{value} ± {stderr}");
}

#[test]
fn what_swings_is_not_described_by_what_creeps() {
    // The zero of the sensor runs by far more than the mass swings.
    let mut drifting = hardening(0.0, 8);
    let times = drifting.times.clone();
    drifting.values.iter_mut().zip(&times).for_each(|(value, time)| *value += 0.05 * time);
    let report = fit(&drifting, &Options::default()).expect("fits");
    assert!(!report.adequacy.adequate, "{:?}", report.best());
    let creeping = Recording {
        values: drifting.times.iter().map(|t| 0.1 * (1.0 + 5.0 * t) * (-5.0 * t).exp()).collect(),
        ..drifting
    };
    let mut random = Random(9);
    let noisy = Recording {
        values: creeping.values.iter().map(|value| value + 5e-4 * random.normal()).collect(),
        ..creeping
    };
    let report = fit(&noisy, &Options::default()).expect("fits");
    assert!(report.adequacy.findings.iter().all(|finding| finding.fault != Fault::Residual));
}
