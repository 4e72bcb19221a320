//! Decays that a hand breaks off, and sensors that clip.

use std::f64::consts::PI;

use federpendel::Mix;
use federpendel_fit::clipping::clipping;
use federpendel_fit::window::find;
use federpendel_fit::{Edge, Options, Parameters, Quantity, Recording, fit};

mod synthetic;
use synthetic::{Random, known};

const OMEGA: f64 = 6.5;

/// A phone on a spring: Stokes and Newton friction.
fn truth() -> Parameters {
    Parameters {
        angular_frequency: OMEGA,
        damping_rate: 0.006,
        coulomb_acceleration: 0.0,
        newton_rate: 0.036,
        position0: 0.06,
        velocity0: 0.0,
        equilibrium: 0.0,
    }
}

/// What `truth` does at 100 values a second for so many seconds.
fn recorded(
    truth: &Parameters,
    held: f64,
    duration: f64,
    quantity: Quantity,
) -> (Vec<f64>, Vec<f64>) {
    let times: Vec<f64> = (0..(100.0 * duration) as usize).map(|i| 0.01 * i as f64).collect();
    let motion = truth.motion(held).expect("a motion");
    let samples = motion.samples(&times).expect("it moves");
    let value = |sample: federpendel::Sample| match quantity {
        Quantity::Position => sample.position,
        Quantity::Velocity => sample.velocity,
        Quantity::Acceleration => sample.acceleration,
    };
    (times, samples.into_iter().map(value).collect())
}

fn recording(times: Vec<f64>, values: Vec<f64>, quantity: Quantity) -> Recording {
    Recording { times, values, quantity, unit: String::new() }
}

/// An acceleration until a hand pushes with `pulse` m/s² for `lasts` s at `stop`, and then holds the mass.
fn grabbed(stop: f64, pulse: f64, lasts: f64, random: &mut Random) -> Recording {
    let (times, mut values) = recorded(&truth(), 0.0, stop + 4.0, Quantity::Acceleration);
    for (&time, value) in times.iter().zip(&mut values) {
        let since = time - stop;
        if since > 0.0 {
            let push = if since < lasts { pulse * (PI * since / lasts).sin() } else { 0.0 };
            *value = push + 0.1 * random.normal() * (-since).exp() * (40.0 * since).sin();
        }
        *value += 0.015 * random.normal();
    }
    recording(times, values, Quantity::Acceleration)
}

#[test]
fn a_hand_ends_the_decay() {
    let mut random = Random(11);
    for pulse in [0.0, 1.0, 2.0, 4.0, 8.0, 16.0] {
        for lasts in [0.05, 0.15, 0.4] {
            let stop = random.between(15.0, 30.0);
            let window = find(&grabbed(stop, pulse, lasts, &mut random), None, None).window;
            assert_eq!(window.ends, Edge::Stopped, "{pulse} {lasts} {stop}: {window:?}");
            let lost = stop - window.to;
            assert!((0.0..3.5 * PI / OMEGA).contains(&lost), "{pulse} {lasts} {lost}");
            assert!(window.from < 1.0, "{window:?}");
        }
    }
    let report = fit(&grabbed(40.0, 5.0, 0.15, &mut random), &Options::default()).expect("fits");
    assert_eq!(report.window.ends, Edge::Stopped);
    let truth = Mix { stokes: true, coulomb: false, newton: true };
    let mut mixes = report.verdict.alternatives.iter().chain([&report.verdict.mix]);
    assert!(report.adequacy.adequate && mixes.any(|mix| *mix == truth), "{:?}", report.verdict);
    let model = report.model(truth).expect("all mixes are fitted");
    for (name, value) in [("damping_rate", 0.006), ("newton_rate", 0.036)] {
        let found = model.parameter(name).expect("it is fitted");
        let off = (found.value.unwrap_or(f64::NAN) - value) / found.stderr.unwrap_or(f64::NAN);
        assert!(off.abs() < 3.0, "{found:?}");
    }
}

#[test]
fn a_hand_that_holds_the_mass_aside_ends_the_decay() {
    let mut random = Random(3);
    for aside in [-0.05, -0.02, 0.0, 0.03, 0.05] {
        let (times, mut values) = recorded(&truth(), 0.0, 26.0, Quantity::Position);
        let stop = random.between(18.0, 20.0);
        let at = values[(100.0 * stop) as usize];
        for (&time, value) in times.iter().zip(&mut values) {
            let since = (time - stop).max(0.0) / 0.08;
            if since > 0.0 {
                *value = aside + (at - aside) * (1.0 + since) * (-since).exp();
            }
            *value += 4e-4 * random.normal();
        }
        let window = find(&recording(times, values, Quantity::Position), None, None).window;
        assert_eq!(window.ends, Edge::Stopped, "{aside}: {window:?}");
        assert!((stop - 4.0 * PI / OMEGA..stop).contains(&window.to), "{aside} {stop}: {window:?}");
    }
}

#[test]
fn a_rest_by_dry_friction_is_not_broken_off() {
    let mut random = Random(5);
    for quantity in [Quantity::Position, Quantity::Velocity, Quantity::Acceleration] {
        for _ in 0..60 {
            let swings = random.between(5.0, 50.0);
            let coulomb_acceleration = 0.06 * OMEGA * OMEGA / (2.0 * swings);
            let truth = Parameters {
                coulomb_acceleration,
                damping_rate: 0.01,
                newton_rate: 0.1,
                ..truth()
            };
            let held = random.between(1.0, 3.0) * coulomb_acceleration;
            let (times, mut values) = recorded(&truth, held, 30.0, quantity);
            let noise = random.scale(1e-5, 6e-4) * OMEGA.powi(quantity as i32);
            values.iter_mut().for_each(|value| *value += noise * random.normal());
            let window = find(&recording(times, values, quantity), None, None).window;
            assert!(window.ends != Edge::Stopped && window.from < 0.1, "{swings}: {window:?}");
        }
    }
}

#[test]
fn free_decays_are_neither_broken_off_nor_clipped() {
    let mut random = Random(17);
    for _ in 0..400 {
        let recording = known(&mut random, 0.0).expect("a motion").recording;
        let window = find(&recording, None, None).window;
        assert_ne!(window.ends, Edge::Stopped, "{window:?}");
        let found = clipping(&recording.times, &recording.values);
        assert!(found.is_none(), "{found:?}");
    }
}

#[test]
fn noise_breaks_no_decay_off() {
    let mut random = Random(29);
    let truth = Parameters { damping_rate: 0.03, ..truth() };
    for _ in 0..150 {
        let (times, mut values) = recorded(&truth, 0.0, 60.0, Quantity::Position);
        let noise = random.scale(0.002, 0.02);
        values.iter_mut().for_each(|value| *value += noise * random.normal());
        let window = find(&recording(times, values, Quantity::Position), None, None).window;
        assert_ne!(window.ends, Edge::Stopped, "{noise}: {window:?}");
    }
}

#[test]
fn of_two_releases_the_last_counts_unless_it_is_much_shorter() {
    let mut random = Random(23);
    // So many seconds of each, held in between.
    for (one, two, last) in [(6.0, 20.0, true), (12.0, 10.0, true), (20.0, 3.0, false)] {
        let (_, first) = recorded(&truth(), 0.0, one, Quantity::Position);
        let (_, second) = recorded(&truth(), 0.0, two, Quantity::Position);
        let held = std::iter::repeat_n(0.06, 300);
        let mut values: Vec<f64> = first.into_iter().chain(held).chain(second).collect();
        values.iter_mut().for_each(|value| *value += 2e-4 * random.normal());
        let times: Vec<f64> = (0..values.len()).map(|i| 0.01 * i as f64).collect();
        let window = find(&recording(times, values, Quantity::Position), None, None).window;
        if last {
            assert_eq!((window.begins, window.ends), (Edge::Held, Edge::Recording));
            assert!((one + 2.8..one + 3.2).contains(&window.from), "{window:?}");
        } else {
            assert_eq!(window.ends, Edge::Stopped);
            assert!(window.from < 0.1 && window.to < one, "{window:?}");
        }
    }
}

/// 40 swings of dry and viscous friction from 3 mm, 100 values in a period.
fn ring(top: f64, step: f64, random: &mut Random) -> Recording {
    let truth = Parameters {
        damping_rate: 0.065,
        coulomb_acceleration: 1e-3,
        newton_rate: 0.0,
        position0: 0.003,
        ..truth()
    };
    let (times, mut values) = recorded(&truth, 1e-3, 20.0, Quantity::Position);
    for value in &mut values {
        *value = (*value + 1.5e-5 * random.normal()).clamp(-top, top);
        if step > 0.0 {
            *value = (*value / step).round() * step;
        }
    }
    recording(times, values, Quantity::Position)
}

#[test]
fn a_sensor_that_clips_is_seen_and_left_out() {
    let recording = ring(0.0022, 0.0, &mut Random(7));
    let report = fit(&recording, &Options::default()).expect("fits");
    let found = report.clipping.expect("it clips");
    assert_eq!((found.low, found.high), (Some(-0.0022), Some(0.0022)));
    assert!(found.left_out && found.turns >= 4, "{found:?}");
    assert_eq!(report.window.begins, Edge::Clipped);
    let largest = recording.values[report.window.first..].iter().copied().fold(0.0, f64::max);
    assert!(largest < 0.0022 && report.window.from < 7.0, "{:?}", report.window);
    let rate = report.best().and_then(|best| best.parameter("damping_rate").copied());
    let rate = rate.expect("Stokes friction acts");
    let off = (rate.value.unwrap_or(f64::NAN) - 0.065) / rate.stderr.unwrap_or(f64::NAN);
    assert!(off.abs() < 3.0, "{rate:?}");

    let asked = Options { from: Some(0.1), ..Options::default() };
    let found = fit(&recording, &asked).expect("fits").clipping.expect("it clips");
    assert!(found.enough && !found.left_out, "{found:?}");
}

#[test]
fn a_coarse_sensor_does_not_clip() {
    let mut random = Random(9);
    for _ in 0..200 {
        let step = random.scale(3e-6, 1e-3);
        let coarse = ring(1.0, step, &mut random);
        let found = clipping(&coarse.times, &coarse.values);
        assert!(found.is_none(), "{step}: {found:?}");
    }
    for step in [3e-5, 6e-5] {
        let both = ring(0.0022, step, &mut random);
        assert!(clipping(&both.times, &both.values).is_some(), "{step}");
    }
}
