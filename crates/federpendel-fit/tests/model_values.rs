//! The values of the model against the motion of the core crate, and what every motion has.

mod common;

use common::{Case, QUANTITIES, cases, recorded};
use federpendel_fit::model::{Course, evaluate};
use federpendel_fit::{Jacobian, ModelError, Parameters, Quantity, Stop};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

fn config() -> ProptestConfig {
    ProptestConfig { rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
}

fn values(case: &Case, stop: Stop, times: &[f64], quantity: Quantity) -> (Vec<f64>, Course) {
    let mut values = vec![f64::NAN; times.len()];
    let course = evaluate(&case.parameters, stop, times, quantity, &mut values, None).unwrap();
    (values, course)
}

fn farthest(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| if a == b { 0.0 } else { (a - b).abs() })
        .fold(0.0, |m, d| if d <= m { m } else { d })
}

/// Whether some turning point lies so near the edge of a band that rounding decides.
fn tied(case: &Case, motion: &federpendel::Motion, until: f64) -> bool {
    let p = &case.parameters;
    let bands = [case.held, p.coulomb_acceleration].map(|a| a / p.angular_frequency.powi(2));
    let near = |x: f64| bands.iter().any(|band| (x.abs() - band).abs() < 1e-9 * case.amplitude());
    let turns = motion.turning_points().take_while(|turn| turn.time <= until);
    turns.map(|turn| turn.position).chain([p.position0]).any(near)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn values_are_those_of_the_exact_motion(case in cases(), first in -100.0..100.0) {
        let times = case.times(first, 301);
        let motion = case.parameters.motion(case.held).unwrap();
        prop_assume!(!tied(&case, &motion, times[300] - first));
        for quantity in QUANTITIES {
            let (found, _) = values(&case, case.stop(), &times, quantity);
            let expected = recorded(&case.parameters, case.held, &times, quantity);
            // Beside a reversal rounding of the time decides which acceleration is meant.
            let near = |t: &f64| {
                let turns = motion.turning_points().take_while(|turn| turn.time <= t - first + 1.0);
                let close = 1e-10 * case.length / case.parameters.angular_frequency;
                turns.map(|turn| turn.time).any(|time| (time - (t - first)).abs() < close)
            };
            let pairs = found.iter().zip(&expected).zip(&times);
            for ((a, b), t) in pairs.filter(|(_, t)| quantity != Quantity::Acceleration || !near(t)) {
                prop_assert!((a - b).abs() <= 1e-9 * case.size(quantity), "{t} {quantity:?}: {a} {b} {:e}", (a - b).abs() / case.size(quantity));
            }
        }
    }

    #[test]
    fn turning_points_and_rest_are_those_of_the_exact_motion(case in cases()) {
        let times = case.times(7.0, 50);
        let last = times[49] - 7.0;
        let motion = case.parameters.motion(case.held).unwrap();
        prop_assume!(!tied(&case, &motion, last));
        let (_, course) = values(&case, case.stop(), &times, Quantity::Position);
        let expected: Vec<_> = motion.turning_points().take_while(|turn| turn.time <= last).collect();
        prop_assert_eq!(course.turning_points.len(), expected.len());
        let unit = 1.0 / case.parameters.angular_frequency;
        for (found, expected) in course.turning_points.iter().zip(&expected) {
            prop_assert!((found.position - expected.position).abs() <= 1e-10 * case.amplitude());
            // Where the mass nearly rests, a reversal is as late as rounding of the velocity makes it.
            let flat = case.amplitude() / expected.position.abs().max(1e-300);
            let within = 1e-10 * (case.length + flat) * unit;
            prop_assert!((found.time - 7.0 - expected.time).abs() <= within, "{found:?} {expected:?}");
        }
        let rests = motion.at(last).unwrap().mode == federpendel::Mode::Stuck;
        prop_assert_eq!(course.rest.is_some(), rests);
        if let Some(rest) = course.rest {
            prop_assert_eq!(rest.number, expected.len() as u64);
        }
    }

    /// Mirrored, every number but the equilibrium changes its sign and nothing else.
    #[test]
    fn mirror_images_agree_to_the_last_bit(mut case in cases()) {
        case.parameters.equilibrium = 0.0;
        let times = case.times(0.0, 100);
        let p = case.parameters;
        let mirrored = Case {
            parameters: Parameters { position0: -p.position0, velocity0: -p.velocity0, ..p },
            ..case
        };
        for quantity in QUANTITIES {
            let (a, _) = values(&case, case.stop(), &times, quantity);
            let (b, _) = values(&mirrored, case.stop(), &times, quantity);
            let negative: Vec<f64> = b.iter().map(|b| -b).collect();
            prop_assert_eq!(farthest(&a, &negative), 0.0);
        }
    }

    /// Forced to stop where it would stop, the mass does the same; with a Jacobian too.
    #[test]
    fn forced_and_natural_stops_agree(case in cases()) {
        let times = case.times(0.0, 100);
        let (natural, course) = values(&case, case.stop(), &times, Quantity::Position);
        let Some(rest) = course.rest.filter(|rest| rest.number > 0) else { return Ok(()) };
        let stop = Stop::After(rest.number);
        let (forced, forced_course) = values(&case, stop, &times, Quantity::Position);
        prop_assert_eq!(&natural, &forced);
        prop_assert_eq!(&course.turning_points, &forced_course.turning_points);
        let (mut again, mut jacobian) = (vec![0.0; 100], Jacobian::new());
        evaluate(&case.parameters, stop, &times, Quantity::Position, &mut again, Some(&mut jacobian)).unwrap();
        prop_assert!(farthest(&again, &natural) <= 1e-10 * case.amplitude());
    }
}

fn ordinary() -> Case {
    let parameters = Parameters {
        angular_frequency: 6.0,
        damping_rate: 0.1,
        coulomb_acceleration: 0.2,
        newton_rate: 0.3,
        position0: 0.1,
        velocity0: -0.2,
        equilibrium: 0.01,
    };
    Case { parameters, held: 0.2, length: 40.0 }
}

#[test]
fn a_forced_stop_holds_the_mass_at_that_turning_point() {
    let case = ordinary();
    let times = case.times(3.0, 400);
    let (_, free) = values(&case, Stop::Never, &times, Quantity::Position);
    let (found, course) = values(&case, Stop::After(2), &times, Quantity::Position);
    let rest = course.rest.unwrap();
    assert_eq!((rest.number, course.swings()), (2, 2));
    assert_eq!(course.turning_points[..], free.turning_points[..2]);
    assert_eq!(
        (rest.time, rest.position),
        (free.turning_points[1].time, free.turning_points[1].position)
    );
    let resting = times.iter().zip(&found).filter(|(t, _)| **t >= rest.time);
    assert!(resting.map(|(_, x)| *x).all(|x| x == rest.position + 0.01));
}

#[test]
fn a_release_within_the_band_stays() {
    let mut case = ordinary();
    case.parameters.velocity0 = 0.0;
    case.held = 36.0 * 0.11;
    let (found, course) = values(&case, case.stop(), &[0.0, 1.0], Quantity::Position);
    assert_eq!(found, [0.11, 0.11]);
    let rest = course.rest.unwrap();
    assert_eq!((rest.number, rest.time, rest.position), (0, 0.0, 0.1));
    assert_eq!(rest.derivatives, [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
}

/// Thousands of swings and uneven times, some of them equal.
#[test]
fn long_recordings_stay_accurate() {
    let mut case = ordinary();
    case.parameters =
        Parameters { damping_rate: 1e-4, coulomb_acceleration: 0.0, ..case.parameters };
    case.held = 0.0;
    case.length = 3000.0 * std::f64::consts::PI;
    for newton_rate in [0.0, 0.3] {
        case.parameters.newton_rate = newton_rate;
        let mut times = case.times(1e3, 20_000);
        (times[77], times[500]) = (times[76], times[499]);
        for quantity in QUANTITIES {
            let (found, course) = values(&case, case.stop(), &times, quantity);
            let expected = recorded(&case.parameters, 0.0, &times, quantity);
            assert!(farthest(&found, &expected) <= 1e-9 * case.size(quantity));
            assert!(course.turning_points.len() >= 2998);
        }
    }
}

#[test]
fn what_is_refused_is_named() {
    let case = ordinary();
    let p = case.parameters;
    let refused = |p: Parameters, times: &[f64], room: usize| {
        evaluate(&p, Stop::Never, times, Quantity::Position, &mut vec![0.0; room], None)
            .unwrap_err()
    };
    for (i, bad) in
        [(0, 0.0), (1, -1.0), (2, -0.1), (3, f64::NAN), (4, f64::INFINITY), (5, f64::NAN)]
    {
        let mut values = p.to_array();
        values[i] = bad;
        let error = refused(Parameters::from_array(values), &[0.0], 1);
        assert!(
            matches!(error, ModelError::Parameter { value, .. } if value.to_bits() == bad.to_bits())
        );
    }
    assert_eq!(refused(p, &[0.0, 2.0, 1.0], 3), ModelError::Times { index: 2 });
    assert_eq!(refused(p, &[0.0, f64::NAN], 2), ModelError::Times { index: 1 });
    assert_eq!(refused(p, &[0.0], 2), ModelError::Length { times: 1, values: 2 });
    let fast = Parameters { angular_frequency: 1e12, ..p };
    assert!(matches!(refused(fast, &[0.0, 1.0], 2), ModelError::TooLong { .. }));
    let strong = Parameters { newton_rate: 1e300, ..p };
    assert_eq!(refused(strong, &[0.0, 1.0], 2), ModelError::Overflow);
    assert_eq!(values(&case, case.stop(), &[], Quantity::Position).0, []);
}
