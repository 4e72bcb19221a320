//! The article's difference scheme against its equations written out, and against what is known of
//! its accuracy.

use federpendel::scheme::article::{MAX_STEPS, MAX_STORED, Scheme};
use federpendel::{Coulomb, Error, Friction, Mode, Newton, NormalForce, Oscillator, State, Stokes};

const MASS: f64 = 0.5;
const STIFFNESS: f64 = 20.0;
const DAMPING: f64 = 0.2;
const MU_G: f64 = 0.02 * 9.81;
const DRAG: f64 = 0.235;

/// The mix whose bits are set: 1 Stokes, 2 Coulomb, 4 Newton.
fn oscillator(bits: u8) -> Oscillator {
    let coulomb = Coulomb::new(0.02, 0.05, NormalForce::Weight(9.81)).unwrap();
    let friction = Friction {
        stokes: (bits & 1 > 0).then(|| Stokes::new(DAMPING).unwrap()),
        coulomb: (bits & 2 > 0).then_some(coulomb),
        newton: (bits & 4 > 0).then(|| Newton::new(DRAG).unwrap()),
    };
    Oscillator::new(MASS, STIFFNESS, friction).unwrap()
}

fn scheme(bits: u8, position: f64, velocity: f64, time_step: f64) -> Scheme {
    let release = State::new(position, velocity).unwrap();
    Scheme::new(&oscillator(bits), release, time_step).unwrap()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} ± {tolerance}");
}

/// (51), (54), (59), (60), (85), (86) letter by letter, with the terms of the mix added up.
fn written_out(bits: u8, x0: f64, v0: f64, dt: f64, steps: usize) -> Vec<f64> {
    let sign = |v: f64| {
        if v > 0.0 {
            1.0
        } else if v < 0.0 {
            -1.0
        } else {
            0.0
        }
    };
    let friction = |v: f64| {
        let stokes = if bits & 1 > 0 { DAMPING / MASS * v } else { 0.0 };
        let coulomb = if bits & 2 > 0 { sign(v) * MU_G } else { 0.0 };
        let newton = if bits & 4 > 0 { sign(v) / MASS * DRAG * v * v } else { 0.0 };
        stokes + coulomb + newton
    };
    let mut x = vec![x0];
    x.push(x0 + v0 * dt - dt * dt / 2.0 * (STIFFNESS / MASS * x0 + friction(v0)));
    for i in 1..steps {
        let quotient = (x[i] - x[i - 1]) / dt;
        let bracket = STIFFNESS / MASS * x[i] + friction(quotient);
        x.push(2.0 * x[i] - x[i - 1] - dt * dt * bracket);
    }
    x
}

#[test]
fn every_mix_follows_its_equations_written_out() {
    for bits in 0..8 {
        for (x0, v0) in [(0.1, 0.0), (-0.1, 0.3), (0.0, -0.5)] {
            let found = scheme(bits, x0, v0, 1e-3).run(1500).unwrap();
            let expected = written_out(bits, x0, v0, 1e-3, 1500);
            assert_eq!(found.len(), 1501);
            for (found, expected) in found.iter().zip(&expected) {
                assert_close(*found, *expected, 1e-12);
            }
        }
    }
}

#[test]
fn the_start_from_rest_is_without_friction() {
    // (60) with sign(0) = 0: x1 = x0 − ½Δt² C/m x0, here 0.1 − 0.5e-6·40·0.1.
    let mut steps = scheme(2, 0.1, 0.0, 1e-3).steps();
    assert_eq!(steps.next().unwrap().unwrap().acceleration, -4.0);
    assert_close(steps.next().unwrap().unwrap().position, 0.099998, 1e-17);
    // In the centre at rest nothing moves it, although f64::signum(0.0) is 1.
    let resting = scheme(7, 0.0, 0.0, 1e-3).run(100).unwrap();
    assert!(resting.iter().all(|&x| x == 0.0));
    assert_eq!(scheme(7, 0.0, 0.0, 1e-3).sample(&[0.05]).unwrap().samples[0].mode, Mode::Stuck);
}

#[test]
fn steps_run_fill_and_sample_agree() {
    for bits in 0..8 {
        let scheme = scheme(bits, 0.1, 0.2, 2f64.powi(-9));
        let run = scheme.run(40_000).unwrap();
        let mut filled = vec![0.0; 40_001];
        scheme.fill(&mut filled).unwrap();
        assert_eq!(run, filled);
        let steps: Vec<_> = scheme.steps().take(40_001).map(Result::unwrap).collect();
        let times: Vec<f64> = [40_000, 0, 1, 17_000, 2, 17_000, 39_999]
            .iter()
            .map(|&index| steps[index as usize].time)
            .collect();
        let sampled = scheme.sample(&times).unwrap();
        assert!(!sampled.interpolated);
        for (sample, time) in sampled.samples.iter().zip(times) {
            let index = (time * 512.0) as usize;
            assert_eq!(sample.time, time);
            assert_eq!(sample.position, run[index]);
            assert_eq!(sample.position, steps[index].position);
            assert_eq!(sample.velocity, steps[index].velocity);
            assert_eq!(sample.acceleration, steps[index].acceleration);
        }
    }
    for length in 0..4 {
        let mut filled = vec![9.0; length];
        scheme(0, 0.1, 0.2, 1e-3).fill(&mut filled).unwrap();
        assert_eq!(filled, scheme(0, 0.1, 0.2, 1e-3).run(3).unwrap()[..length]);
    }
}

#[test]
fn the_velocity_is_the_backward_quotient() {
    let scheme = scheme(1, 0.1, 0.2, 0.01);
    let run = scheme.run(3).unwrap();
    let steps: Vec<_> = scheme.steps().take(4).map(Result::unwrap).collect();
    assert_eq!(steps[0].velocity, 0.2);
    for i in 1..4 {
        assert_close(steps[i].velocity, (run[i] - run[i - 1]) / 0.01, 1e-14);
        // (49) at the step before the last is the acceleration that the scheme gave it.
        if i < 3 {
            let second = (run[i + 1] - 2.0 * run[i] + run[i - 1]) / 1e-4;
            assert_close(steps[i].acceleration, second, 1e-10);
        }
    }
}

#[test]
fn between_steps_it_interpolates_and_says_so() {
    let scheme = scheme(7, 0.1, 0.2, 0.01);
    let run = scheme.run(3).unwrap();
    let sampled = scheme.sample(&[0.0025, 0.025, 0.02]).unwrap();
    assert!(sampled.interpolated);
    assert_close(sampled.samples[0].position, 0.75 * run[0] + 0.25 * run[1], 1e-16);
    assert_close(sampled.samples[1].position, 0.5 * (run[2] + run[3]), 1e-16);
    assert_eq!(sampled.samples[2].position, run[2]);
    // Rounded times of a decimal grid are on it: 20 s · i/2000 with Δt = 1 ms.
    let times: Vec<f64> = (0..=2000).map(|i| 20.0 * f64::from(i) / 2000.0).collect();
    let scheme = Scheme::new(&oscillator(2), State::new(0.1, 0.0).unwrap(), 1e-3).unwrap();
    let sampled = scheme.sample(&times).unwrap();
    assert!(!sampled.interpolated);
    let run = scheme.run(20_000).unwrap();
    for (i, sample) in sampled.samples.iter().enumerate() {
        assert_eq!(sample.position, run[10 * i]);
    }
}

/// Slope of log2 of the errors against log2 of the step over halvings, by least squares.
fn fitted_order(errors: &[f64]) -> f64 {
    let n = errors.len() as f64;
    let mean_x = (n - 1.0) / 2.0;
    let mean_y = errors.iter().map(|error| error.log2()).sum::<f64>() / n;
    let (mut covariance, mut variance) = (0.0, 0.0);
    for (i, error) in errors.iter().enumerate() {
        covariance += (i as f64 - mean_x) * (error.log2() - mean_y);
        variance += (i as f64 - mean_x).powi(2);
    }
    -covariance / variance
}

/// The order over eight halvings from Δt = 1/64 s to 1/16384 s, at t = 3 s, against `exact`.
fn measured_order(bits: u8, exact: f64) -> f64 {
    let errors: Vec<f64> = (6..=14)
        .map(|power| {
            let run = scheme(bits, 0.1, 0.3, 2f64.powi(-power)).run(3 << power).unwrap();
            (run[3 << power] - exact).abs()
        })
        .collect();
    fitted_order(&errors)
}

#[test]
fn the_order_is_two_without_friction_and_one_with_stokes() {
    // x(3) of x0 = 0.1, v0 = 0.3, written with the functions of the closed forms.
    let undamped = |t: f64| {
        let w = 40f64.sqrt();
        0.1 * (w * t).cos() + 0.3 / w * (w * t).sin()
    };
    assert_close(measured_order(0, undamped(3.0)), 2.0, 0.2);
    let stokes = |t: f64| {
        let (gamma, w) = (0.2, 39.96f64.sqrt());
        (-gamma * t).exp() * (0.1 * (w * t).cos() + (0.3 + 0.02) / w * (w * t).sin())
    };
    assert_close(measured_order(1, stokes(3.0)), 1.0, 0.2);
}

#[test]
fn a_step_that_is_too_long_is_an_error_with_its_time() {
    // Without friction the limit is ω0Δt = 2, Δt = 0.3162 s.
    let steps = 1_000_000;
    assert!(scheme(0, 0.1, 0.0, 0.316).run(steps).is_ok());
    let refused = scheme(0, 0.1, 0.0, 0.33).run(steps).unwrap_err();
    let Error::Diverged { time_step, time } = refused else { panic!("{refused:?}") };
    assert_eq!(time_step, 0.33);
    // The steps one by one end there, too, with the same error.
    let last = scheme(0, 0.1, 0.0, 0.33).steps().last().unwrap();
    assert!(matches!(last, Err(Error::Diverged { .. })), "{last:?}");
    let count = scheme(0, 0.1, 0.0, 0.33).steps().count();
    assert!((count as f64 * 0.33 - time).abs() < 3.0 * 0.33, "{count} steps, {time} s");
    let sampled = scheme(0, 0.1, 0.0, 0.33).sample(&[1.0, 1e5]);
    assert!(matches!(sampled, Err(Error::Diverged { .. })), "{sampled:?}");
}

#[test]
fn bad_input_is_refused_by_name() {
    let release = State::new(0.1, 0.0).unwrap();
    for time_step in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        let refused = Scheme::new(&oscillator(7), release, time_step);
        assert!(matches!(refused, Err(Error::Parameter { name: "dt", .. })), "{refused:?}");
    }
    for time_step in [1e-170, 1e-308, 1e200] {
        let refused = Scheme::new(&oscillator(7), release, time_step);
        assert!(matches!(refused, Err(Error::Derived { .. })), "{refused:?}");
    }
    let nowhere = State { position: f64::NAN, velocity: 0.0 };
    assert!(matches!(Scheme::new(&oscillator(7), nowhere, 1e-3), Err(Error::Parameter { .. })));
    let scheme = Scheme::new(&oscillator(7), release, 1e-6).unwrap();
    for time in [-1.0, f64::NAN, f64::INFINITY] {
        let refused = scheme.sample(&[0.0, time]);
        assert!(matches!(refused, Err(Error::Parameter { name: "time", .. })), "{refused:?}");
    }
    let refused = scheme.sample(&[1.1e-6 * MAX_STEPS as f64]).unwrap_err();
    assert!(matches!(refused, Error::TooManySteps { limit: MAX_STEPS, .. }), "{refused:?}");
    let refused = scheme.run(MAX_STORED + 1).unwrap_err();
    assert!(matches!(refused, Error::TooManySteps { limit: MAX_STORED, .. }), "{refused:?}");
}

#[test]
fn the_default_step_is_a_thousandth_of_the_period() {
    let default = |damping: f64| {
        let law = Stokes::new(damping).unwrap();
        // ω0 = 1, γ = D/2
        Scheme::default_time_step(&Oscillator::new(1.0, 1.0, law).unwrap())
    };
    let undamped = 2e-3 * std::f64::consts::PI;
    assert_close(default(0.0), undamped, 1e-17);
    assert_close(default(1.2), undamped / 0.8, 1e-17);
    for damping in [1.9999, 2.0, 2.0001, 100.0] {
        assert_close(default(damping), undamped, 1e-17);
    }
}

#[test]
fn a_walk_that_is_interrupted_takes_the_same_steps() {
    let times: Vec<f64> = (0..500).map(|i| 0.0137 * f64::from(i)).collect();
    for bits in 0..8 {
        let scheme = scheme(bits, 0.1, -0.2, 1e-3);
        let whole = scheme.sample(&times).unwrap();
        let mut walk = scheme.walk();
        for (time, expected) in times.iter().zip(&whole.samples) {
            walk.advance(0.4 * time + 0.6 * (time - 0.0137).max(0.0)).unwrap();
            assert_eq!(walk.sample(*time).unwrap(), *expected);
        }
        assert!(walk.interpolated() && whole.interpolated);
        assert!(matches!(walk.sample(1.0), Err(Error::Order { .. })));
    }
}

#[test]
fn the_scheme_is_stable_up_to_its_longest_step() {
    for damping in [0.0, 0.2, 2.0, 40.0] {
        let oscillator = Oscillator::new(MASS, STIFFNESS, Stokes::new(damping).unwrap()).unwrap();
        let release = State::new(0.1, 0.0).unwrap();
        let longest = Scheme::longest_stable_step(&oscillator, release);
        let largest = |step: f64| {
            let positions = Scheme::new(&oscillator, release, step).unwrap().run(2_000).unwrap();
            positions.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()))
        };
        let (below, above) = (largest(0.999 * longest), largest(1.01 * longest));
        assert!(below < 10.0 && above > 1e3, "D = {damping}: {below}, {above}");
    }
    // With Newton friction it errs on the safe side.
    for (velocity, drag) in [(0.0, 2.0), (30.0, 0.2), (-5.0, 20.0)] {
        let oscillator = Oscillator::new(MASS, STIFFNESS, Newton::new(drag).unwrap()).unwrap();
        let release = State::new(0.1, velocity).unwrap();
        let step = Scheme::longest_stable_step(&oscillator, release);
        let positions = Scheme::new(&oscillator, release, step).unwrap().run(20_000).unwrap();
        let reach = velocity.abs() / (STIFFNESS / MASS).sqrt() + 0.1;
        assert!(positions.iter().all(|x| x.abs() < 2.0 * reach), "{velocity} {drag}");
    }
}
