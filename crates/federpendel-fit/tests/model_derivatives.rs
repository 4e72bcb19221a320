//! The derivatives of the model against differences of the exact motion, extrapolated.

mod common;

use common::{Case, QUANTITIES, cases, recorded};
use federpendel_fit::model::{Course, evaluate};
use federpendel_fit::{Jacobian, Parameters, Quantity, Stop};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Samples of a recording in these tests.
const SAMPLES: usize = 120;
/// Levels of extrapolation; each halves the step.
const LEVELS: usize = 5;
/// The largest step, as a part of what changes the phase at the end of the record by one.
const STEP: f64 = 0.05;

fn config() -> ProptestConfig {
    ProptestConfig {
        rng_seed: RngSeed::Fixed(2),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// How one parameter is varied: by `step` at most, to both sides or to that of the step alone.
#[derive(Debug, Clone, Copy)]
struct Variation {
    index: usize,
    step: f64,
    both: bool,
}

impl Variation {
    fn new(case: &Case, index: usize) -> Self {
        let p = case.parameters;
        let (omega, size) = (p.angular_frequency, case.amplitude());
        let small = STEP / case.length;
        let step = match index {
            0 | 1 => small * omega,
            2 => small * size * omega * omega,
            3 => small / size,
            5 => small * size * omega,
            _ => small * size,
        };
        match index {
            1..=3 => Variation { index, step, both: p.to_array()[index] >= step },
            // At rest only a kick towards the centre leaves the pattern as it is.
            5 if p.velocity0 == 0.0 => {
                Variation { index, step: -step * p.position0.signum(), both: false }
            }
            _ => Variation { index, step, both: true },
        }
    }

    fn apply(&self, parameters: &Parameters, part: f64) -> Parameters {
        let mut values = parameters.to_array();
        values[self.index] += part * self.step;
        Parameters::from_array(values)
    }

    /// The derivatives of all values of a function, and how uncertain they are.
    fn derivatives(&self, function: impl Fn(f64) -> Vec<f64>) -> Vec<(f64, f64)> {
        let parts: Vec<f64> = (0..LEVELS).map(|level| 0.5_f64.powi(level as i32)).collect();
        let ahead: Vec<_> = parts.iter().map(|part| function(*part)).collect();
        let behind: Vec<_> =
            parts.iter().map(|part| function(if self.both { -part } else { 0.0 })).collect();
        let sides = if self.both { 2.0 } else { 1.0 };
        let derivative = |i: usize| {
            let quotient = |l: usize| (ahead[l][i] - behind[l][i]) / (sides * parts[l] * self.step);
            extrapolated((0..LEVELS).map(quotient).collect(), if self.both { 2 } else { 1 })
        };
        (0..ahead[0].len()).map(derivative).collect()
    }
}

/// Richardson's extrapolation of differences with halved steps, whose errors go with step^`order`, step^2`order` …:
/// the last value, and how far it is from the one before.
fn extrapolated(mut column: Vec<f64>, order: i32) -> (f64, f64) {
    let mut before = column[LEVELS - 1];
    for k in 1..LEVELS as i32 {
        before = column[column.len() - 1];
        let gain = 2.0_f64.powi(order * k) - 1.0;
        column = column.windows(2).map(|pair| pair[1] + (pair[1] - pair[0]) / gain).collect();
    }
    (column[0], (column[0] - before).abs())
}

fn model(p: &Parameters, stop: Stop, times: &[f64], quantity: Quantity) -> (Jacobian, Course) {
    let (mut jacobian, mut values) = (Jacobian::new(), vec![0.0; times.len()]);
    let course = evaluate(p, stop, times, quantity, &mut values, Some(&mut jacobian)).unwrap();
    (jacobian, course)
}

/// The samples in whose swing all of the variation happens: those that no reversal passes; none if the number of
/// reversals changes.
fn undisturbed(courses: &[Vec<f64>; 3], times: &[f64]) -> Vec<bool> {
    let [a, b, c] = courses;
    if a.len() != b.len() || b.len() != c.len() {
        return vec![false; times.len()];
    }
    let span = |i: usize| {
        let at = [a[i], b[i], c[i]];
        let (low, high) = (
            at.iter().copied().fold(f64::INFINITY, f64::min),
            at.iter().copied().fold(0.0, f64::max),
        );
        (low - 1e-6 * (1.0 + low), high + 1e-6 * (1.0 + high))
    };
    let spans: Vec<_> = (0..a.len()).map(span).collect();
    times.iter().map(|t| !spans.iter().any(|(low, high)| low <= t && t <= high)).collect()
}

/// Compares a column of the Jacobian with differences of `function`, of which each value is good to `noise` of its
/// size; the number of samples compared.
fn compare(
    (case, quantity): (&Case, Quantity),
    variation: Variation,
    (column, good): (&[f64], &[bool]),
    noise: f64,
    function: impl Fn(f64) -> Vec<f64>,
) -> Result<usize, TestCaseError> {
    if !good.contains(&true) {
        return Ok(0);
    }
    let expected = variation.derivatives(function);
    // A change by the amplitude's share of the parameter's unit, or the largest there is.
    let unit = case.size(quantity) * STEP / case.length / variation.step.abs();
    // What noise makes of the smallest differences, extrapolated.
    let rounding = 3.0 * noise * 0.5_f64.powi(1 - LEVELS as i32) * case.length / STEP;
    // Strong damping changes the acceleration that much faster than the position.
    let damping = case.parameters.damping_rate / case.parameters.angular_frequency;
    let within = match quantity {
        Quantity::Acceleration => 1e-8 * (1.0 + damping).powi(2),
        _ => 1e-8,
    };
    let largest = column.iter().fold(0.0_f64, |m, d| m.max(d.abs()));
    let mut compared = 0;
    for (i, (expected, uncertain)) in expected.into_iter().enumerate() {
        if !good[i] || uncertain > 1e-7 * largest {
            continue;
        }
        compared += 1;
        let error = (column[i] - expected).abs();
        prop_assert!(
            error <= within * largest + (within + rounding) * unit + 10.0 * uncertain,
            "sample {i}, {variation:?}: {} and {expected} ± {uncertain:e} of {largest}\n{case:?}",
            column[i]
        );
    }
    Ok(compared)
}

/// Times of the turning points since the first sample; one more at infinity if the mass rests.
fn turns(p: &Parameters, held: f64, until: f64) -> Vec<f64> {
    let motion = p.motion(held).unwrap();
    let turns = motion.turning_points().map(|turn| turn.time);
    let rests = motion.at(until).unwrap().mode == federpendel::Mode::Stuck;
    turns.take_while(|time| *time <= until).chain(rests.then_some(f64::INFINITY)).collect()
}

proptest! {
    #![proptest_config(config())]

    /// Natural stops, by the core crate, which shares no code with the model.
    #[test]
    fn derivatives_are_those_of_the_exact_motion(case in cases()) {
        prop_assume!(case.amplitude() > 0.0);
        let times = case.times(0.0, SAMPLES);
        let until = times[SAMPLES - 1] * 1.1;
        let p = case.parameters;
        for quantity in QUANTITIES {
            let (jacobian, _) = model(&p, case.stop(), &times, quantity);
            for index in 0..Parameters::COUNT {
                let variation = Variation::new(&case, index);
                let held = |p: &Parameters| case.held.max(p.coulomb_acceleration);
                let behind = if variation.both { -1.0 } else { 0.0 };
                let courses = [behind, 0.0, 1.0].map(|part| {
                    let p = variation.apply(&p, part);
                    turns(&p, held(&p), until)
                });
                let good = undisturbed(&courses, &times);
                compare((&case, quantity), variation, (jacobian.column(index), &good), 1e-14, |part| {
                    let p = variation.apply(&p, part);
                    recorded(&p, held(&p), &times, quantity)
                })?;
            }
        }
    }
}

/// Forced stops and motions that never stop, by differences of the model itself; the pattern is then the same
/// whatever the variation does.
fn compare_with_itself(case: &Case, stop: Stop) -> Result<usize, TestCaseError> {
    let times = case.times(5.0, SAMPLES);
    let p = case.parameters;
    // Truncation, which is another for each variation, and rounding, which strong damping amplifies.
    let noise = |quantity| {
        let factor = match quantity {
            Quantity::Position => 1.0,
            Quantity::Velocity => 10.0,
            Quantity::Acceleration => 100.0,
        };
        1e-12 * factor * (1.0 + p.damping_rate / p.angular_frequency)
    };
    let mut compared = 0;
    for quantity in QUANTITIES {
        let (jacobian, _) = model(&p, stop, &times, quantity);
        for index in 0..Parameters::COUNT {
            let variation = Variation::new(case, index);
            let behind = if variation.both { -1.0 } else { 0.0 };
            let courses = [behind, 0.0, 1.0].map(|part| {
                let (_, course) = model(&variation.apply(&p, part), stop, &times, quantity);
                let rests = course.rest.map(|_| f64::INFINITY);
                course.turning_points.iter().map(|turn| turn.time).chain(rests).collect()
            });
            let good = undisturbed(&courses, &times);
            compared += compare(
                (case, quantity),
                variation,
                (jacobian.column(index), &good),
                noise(quantity),
                |part| {
                    let mut values = vec![0.0; SAMPLES];
                    let p = variation.apply(&p, part);
                    evaluate(&p, stop, &times, quantity, &mut values, None).unwrap();
                    values
                },
            )?;
        }
    }
    Ok(compared)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn derivatives_hold_with_forced_stops(case in cases(), last in 1..8u64) {
        prop_assume!(case.amplitude() > 0.0);
        compare_with_itself(&case, Stop::After(last))?;
        compare_with_itself(&case, Stop::Never)?;
    }
}

/// Every mix, with its zero coefficients, in all quantities, swinging and then held: nearly every sample counts.
#[test]
fn every_mix_is_compared() {
    for mix in 0..8 {
        let acts = |law: u32, strength: f64| if mix >> law & 1 == 1 { strength } else { 0.0 };
        let parameters = Parameters {
            angular_frequency: 4.0,
            damping_rate: acts(0, 0.1),
            coulomb_acceleration: acts(1, 0.3),
            newton_rate: acts(2, 0.4),
            position0: -1.2,
            velocity0: 1.0,
            equilibrium: 0.3,
        };
        let case = Case { parameters, held: 0.3, length: 30.0 };
        for stop in [Stop::Never, Stop::After(7), Stop::After(5)] {
            let compared = compare_with_itself(&case, stop).unwrap();
            let all = QUANTITIES.len() * Parameters::COUNT * SAMPLES;
            assert!(compared > all * 7 / 10, "{mix} {stop:?}: {compared} of {all}");
        }
    }
}

/// The place of rest has the derivatives that the samples there have.
#[test]
fn the_place_of_rest_has_its_derivatives() {
    let parameters = Parameters {
        angular_frequency: 4.0,
        damping_rate: 0.1,
        coulomb_acceleration: 0.3,
        newton_rate: 0.4,
        position0: 0.2,
        velocity0: 0.0,
        equilibrium: 0.1,
    };
    let times: Vec<f64> = (0..100).map(|i| f64::from(i) * 0.1).collect();
    let stop = Stop::Natural { static_acceleration: 0.3 };
    let (jacobian, course) = model(&parameters, stop, &times, Quantity::Position);
    let rest = course.rest.unwrap();
    for index in 0..Parameters::COUNT - 1 {
        assert_eq!(jacobian.column(index)[99], rest.derivatives[index]);
        assert_ne!(rest.derivatives[index], 0.0);
    }
    assert_eq!((jacobian.column(6)[99], rest.derivatives[6]), (1.0, 0.0));
}
