//! A mass that is held before it is let go, for a part of a swing or for long, and comes to rest after few swings.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use federpendel::Mix;
use federpendel_fit::window::find;
use federpendel_fit::{Edge, FitReport, Options, Parameters, Quantity, Recording, fit};

mod synthetic;
use synthetic::Random;

/// A mass that dry friction, and in some viscous friction too, brings to rest.
struct Released {
    recording: Recording,
    /// The truth from the release on, which is at rest.
    truth: Parameters,
    mix: Mix,
    /// When it was let go, s, and half a period, s.
    at: f64,
    half: f64,
}

/// So many swings of it.
fn released(seed: u64, swings: Range<f64>) -> Released {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let (omega, amplitude) = (TAU * random.scale(0.3, 5.0), 0.1);
    let (half, swings) = (PI / omega, random.between(swings.start, swings.end));
    let viscous = random.chance(0.3);
    // Dry friction takes 2a_c/ω0² of the amplitude a swing.
    let dry = amplitude * omega * omega / (2.0 * swings);
    let quantity = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration]
        [(random.unit() * 3.0) as usize];
    let scale = amplitude * omega.powi(quantity as i32);
    let truth = Parameters {
        angular_frequency: omega,
        damping_rate: if viscous { random.between(0.0, 0.05) * omega } else { 0.0 },
        coulomb_acceleration: dry,
        newton_rate: 0.0,
        position0: amplitude,
        velocity0: 0.0,
        equilibrium: random.between(-1.0, 1.0) * scale,
    };
    let at = if random.chance(0.2) { 0.0 } else { random.scale(0.1, 10.0) * half };
    let rest = if random.chance(0.2) { 0.0 } else { random.scale(0.2, 10.0) * half };
    let step = half / random.scale(12.0, 200.0);
    let duration = at + (swings.floor() + 1.0) * half + rest;
    let times: Vec<f64> = (0..(duration / step) as usize).map(|i| i as f64 * step).collect();
    let since: Vec<f64> = times.iter().map(|time| (time - at).max(0.0)).collect();
    let motion = truth.motion(dry * random.between(1.0, 1.3)).expect("in range");
    let sigma = random.scale(0.001, 0.02) * scale;
    let mut value = |(sample, time): (&federpendel::Sample, &f64)| {
        let moves = match quantity {
            Quantity::Position => sample.position,
            _ if *time < at => 0.0,
            Quantity::Velocity => sample.velocity,
            Quantity::Acceleration => sample.acceleration,
        };
        truth.equilibrium + moves + sigma * random.normal()
    };
    let samples = motion.samples(&since).expect("in range");
    let values = samples.iter().zip(&times).map(&mut value).collect();
    let recording = Recording { times, values, quantity, unit: String::new() };
    Released {
        recording,
        truth,
        mix: Mix { stokes: viscous, coulomb: true, newton: false },
        at,
        half,
    }
}

/// By how many standard errors the dry friction of the true mix is off.
fn off(known: &Released, report: &FitReport) -> Option<f64> {
    let dry = report.model(known.mix)?.parameter("coulomb_acceleration")?;
    Some((dry.value? - known.truth.coulomb_acceleration) / dry.stderr?)
}

/// Those of 300 recordings of so many swings that are judged wrongly, with what `sensor` makes of them.
fn wrong(swings: &Range<f64>, sensor: fn(&mut Released)) -> Vec<String> {
    let options = Options { every_mix: true, ..Options::default() };
    (1..=300)
        .filter_map(|seed| {
            let mut known = released(seed, swings.clone());
            sensor(&mut known);
            let report = fit(&known.recording, &options).expect("fits");
            let off = off(&known, &report);
            let right = report.adequacy.adequate && off.is_some_and(|off| off.abs() < 5.0);
            let held = known.at / known.half;
            (!right).then(|| format!("{seed}: held for {held:.2} swings, off {off:?}"))
        })
        .collect()
}

/// Half of what the values span.
fn height(known: &Released) -> f64 {
    let values = &known.recording.values;
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    0.5 * (high - values.iter().copied().fold(f64::INFINITY, f64::min))
}

#[test]
fn however_long_it_was_held_its_friction_is_found() {
    // Judged with the time before the release, which a first look took for a swing: 29 of 300.
    let wrong = wrong(&(3.0..9.0), |_| ());
    assert!(wrong.len() <= 2, "{}: {wrong:#?}", wrong.len());
}

#[test]
fn of_few_swings_before_a_rest_too() {
    let wrong = wrong(&(2.0..3.0), |_| ());
    assert!(wrong.len() <= 3, "{}: {wrong:#?}", wrong.len());
}

#[test]
fn a_hand_may_tremble() {
    let wrong = wrong(&(2.0..9.0), |known| {
        let (at, half, trembles) = (known.at, known.half, 0.015 * height(known));
        let Recording { times, values, .. } = &mut known.recording;
        let held = values.iter_mut().zip(times).take_while(|(_, time)| **time < at);
        held.for_each(|(value, time)| *value += trembles * (*time * 9.0 / half).sin());
    });
    assert!(wrong.len() <= 3, "{}: {wrong:#?}", wrong.len());
}

#[test]
fn a_sensor_may_have_steps() {
    let wrong = wrong(&(2.0..9.0), |known| {
        let step = 0.01 * height(known);
        known.recording.values.iter_mut().for_each(|value| *value = (*value / step).round() * step);
    });
    assert!(wrong.len() <= 3, "{}: {wrong:#?}", wrong.len());
}

#[test]
fn the_window_begins_soon_after_the_release() {
    for seed in 1..=300 {
        let known = released(seed, 3.0..9.0);
        if known.at < known.half {
            continue;
        }
        let window = find(&known.recording, None, None).window;
        let after = (window.from - known.at) / known.half;
        assert!((0.0..1.7).contains(&after), "{seed}: {after} swings after the release");
        assert!(matches!(window.begins, Edge::Held), "{seed}: {:?}", window.begins);
    }
}

#[test]
fn held_tried_and_held_again_it_begins_with_the_last_release() {
    // Six swings of a mass that is let go too early, between two holds, at 100 values a half period.
    let free = |swings: f64, since: f64| -> f64 {
        let amplitude = 0.1 * (1.0 - 0.03 * since);
        if since < swings { amplitude * (PI * since).cos() } else { 0.1 }
    };
    let mut random = Random(5);
    let times: Vec<f64> = (0..2400).map(|i| 0.01 * f64::from(i)).collect();
    let value = |time: f64| match time {
        ..2.0 => 0.1,
        2.0..11.0 => free(6.0, time - 2.0),
        _ => free(f64::INFINITY, time - 11.0),
    };
    let values = times.iter().map(|&time| value(time) + 3e-4 * random.normal()).collect();
    let recording = Recording { times, values, quantity: Quantity::Position, unit: String::new() };
    let window = find(&recording, None, None).window;
    assert!((11.0..12.0).contains(&window.from), "{window:?}");
}

#[test]
fn a_free_motion_that_begins_where_it_turns_is_not_cut() {
    for seed in 1..=300 {
        let known = released(seed, 3.0..9.0);
        let first = known.recording.times.partition_point(|&time| time < known.at);
        let times = known.recording.times[first..].to_vec();
        let values = known.recording.values[first..].to_vec();
        let free = Recording { times, values, ..known.recording };
        let report = fit(&free, &Options::default()).expect("fits");
        assert_eq!(report.window.begins, Edge::Recording, "{seed}");
    }
}

/// Decays at whose end somebody takes the sensor away.
fn taken_away(seed: u64) -> Recording {
    let known = released(seed, 3.0..9.0);
    let far = 20.0 * height(&known);
    let Recording { times, mut values, quantity, unit } = known.recording;
    let first = times.partition_point(|&time| time < known.at);
    let end = times.partition_point(|&time| time < known.at + 3.0 * known.half);
    values[end..].iter_mut().for_each(|value| *value += far);
    Recording { times: times[first..].to_vec(), values: values[first..].to_vec(), quantity, unit }
}

#[test]
fn a_decay_beside_something_far_larger_at_the_end_was_not_held() {
    for seed in 1..=300 {
        let window = find(&taken_away(seed), None, None).window;
        assert_ne!(window.begins, Edge::Held, "{seed}: {window:?}");
    }
}

/// The velocity of a mass that is pushed for a tenth of half a period from where it rests, and the dry friction.
fn pushed(seed: u64) -> (Recording, f64) {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let omega = TAU * random.scale(0.3, 5.0);
    let (half, amplitude, swings) = (PI / omega, 0.1, random.between(3.0, 9.0));
    let dry = amplitude * omega * omega / (2.0 * swings);
    let (at, lasts) = (half * random.between(1.0, 5.0), 0.1 * half);
    // Steps of the push: it ends with about the velocity of such a swing.
    let steps = 2000_u32;
    let step = lasts / f64::from(steps);
    let (mut position, mut velocity, mut course) = (0.0, 0.0, vec![0.0]);
    for i in 0..steps {
        let push = 0.5 * PI * (f64::from(i) / f64::from(steps) * PI).sin();
        velocity +=
            step * (push * (amplitude * omega / lasts + dry) - dry - omega * omega * position);
        position += step * velocity;
        course.push(velocity);
    }
    let truth = Parameters {
        angular_frequency: omega,
        damping_rate: 0.0,
        coulomb_acceleration: dry,
        newton_rate: 0.0,
        position0: position,
        velocity0: velocity,
        equilibrium: 0.0,
    };
    let motion = truth.motion(dry).expect("in range");
    let count = 60.0 * (at / half + swings + 3.0);
    let times: Vec<f64> = (0..count as usize).map(|i| i as f64 * half / 60.0).collect();
    let since: Vec<f64> = times.iter().map(|time| (time - at - lasts).max(0.0)).collect();
    let samples = motion.samples(&since).expect("in range");
    let values = times.iter().zip(samples).map(|(&time, sample)| {
        let free = time >= at + lasts;
        let step = ((time - at).max(0.0) / step) as usize;
        let noise = 3e-3 * amplitude * omega * random.normal();
        noise + if free { sample.velocity } else { course[step.min(steps as usize)] }
    });
    let values = values.collect();
    (Recording { times, values, quantity: Quantity::Velocity, unit: String::new() }, dry)
}

#[test]
fn a_push_is_left_out() {
    let mix = Mix { stokes: false, coulomb: true, newton: false };
    let options = Options { every_mix: true, ..Options::default() };
    let right = (1..=100).filter(|&seed| {
        let (recording, truth) = pushed(seed);
        let report = fit(&recording, &options).expect("fits");
        let dry = report.model(mix).and_then(|model| model.parameter("coulomb_acceleration"));
        let off = dry.and_then(|dry| Some((dry.value? - truth) / dry.stderr?));
        report.adequacy.adequate && off.is_some_and(|off| off.abs() < 5.0)
    });
    assert!(right.clone().count() >= 98, "{}", right.count());
}
