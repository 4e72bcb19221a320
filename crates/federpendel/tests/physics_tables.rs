//! What is known of the article's errors and of its scheme, number by number, and the reference
//! problems against the exact motion.
//!
//! The numbers on the article's errors were measured by two independent programs for m = 0.5 kg,
//! C = 20 N/m, x0 = 0.1 m, v0 = 0, μ = 0.02, g = 9.81 m/s², unless a test says otherwise.

use federpendel::article::{Formula, Reading, eq_61, eq_78};
use federpendel::scheme::article::Scheme;
use federpendel::{Motion, Oscillator, Outcome, Rest, State, problems};

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} ± {tolerance}");
}

fn dry() -> Oscillator {
    problems::coulomb_reference().oscillator
}

fn motion(release: State) -> Motion {
    Motion::new(dry(), release).unwrap()
}

fn rest(motion: &Motion) -> Rest {
    match motion.outcome() {
        Outcome::Rests(rest) => rest,
        outcome => panic!("{outcome:?}"),
    }
}

/// The largest distance, m, between a formula and the exact motion until its rest.
fn largest_distance(formula: &Formula, motion: &Motion) -> f64 {
    let end = rest(motion).time;
    (0..=100_000)
        .map(|i| {
            let time = end * f64::from(i) / 1e5;
            (formula.at(time).unwrap().position - motion.at(time).unwrap().position).abs()
        })
        .fold(0.0, f64::max)
}

/// Every known number of a problem against the exact motion, relative to the amplitude.
#[track_caller]
fn assert_known(problem: &problems::Problem, tolerance: f64) {
    let motion = Motion::new(problem.oscillator, problem.release).unwrap();
    let omega = problem.oscillator.angular_frequency();
    let amplitude = problem.release.position.abs().max(problem.release.velocity.abs() / omega);
    let check = |what: &str, found: f64, known: f64, scale: f64| {
        let error = (found - known).abs() / scale;
        assert!(error <= tolerance, "{}: {what} is {found}, known is {known}", problem.name);
    };
    let known = &problem.known;
    for &(n, amplitude_n) in known.amplitudes {
        let point = motion.turning_points().nth(n - 1).unwrap();
        check("amplitude", point.position.abs(), amplitude_n, amplitude);
    }
    if let Some(time) = known.first_turn {
        check("first turn", motion.turning_points().next().unwrap().time, time, 1.0 / omega);
    }
    for state in known.states {
        let sample = motion.at(state.time).unwrap();
        check("position", sample.position, state.position, amplitude);
        check("velocity", sample.velocity, state.velocity, amplitude * omega);
    }
    if let Some(end) = known.rest {
        let rest = rest(&motion);
        assert_eq!(rest.swings, end.swings, "{}", problem.name);
        check("place of rest", rest.position, end.position, amplitude);
        check("time of rest", rest.time, end.time, end.time.max(1.0 / omega));
        assert_eq!(motion.turning_points().count() as u64, end.swings, "{}", problem.name);
    }
    let knows = !known.amplitudes.is_empty() || !known.states.is_empty() || known.rest.is_some();
    assert!(knows, "{} knows nothing", problem.name);
}

#[test]
fn the_reference_cases() {
    for problem in problems::references() {
        assert_known(&problem, 1e-13);
    }
}

#[test]
fn the_turning_amplitudes_of_six_mixes() {
    for problem in problems::turning_amplitudes() {
        assert_known(&problem, 1e-13);
    }
}

#[test]
fn the_textbook_motions() {
    let problems = problems::textbook();
    assert_eq!(problems.len(), 21);
    for problem in problems {
        assert_known(&problem, 1e-13);
    }
}

#[test]
fn the_formula_is_off_by_the_offset_between_the_turning_points() {
    let release = State::new(0.1, 0.0).unwrap();
    let (formula, motion) = (Formula::corrected(&dry(), release).unwrap(), motion(release));
    assert_close(largest_distance(&formula, &motion), 4.905e-3, 1e-9);
    // It meets the motion at the turning points, and is off by f where the formula is zero.
    for point in motion.turning_points() {
        let met = formula.at(point.time).unwrap().position;
        assert_close(met, point.position, 1e-15);
    }
    let quarter = 0.5 * motion.turning_points().next().unwrap().time;
    assert_close(formula.at(quarter).unwrap().position, 0.0, 1e-16);
    assert_close(motion.at(quarter).unwrap().position, 4.905e-3, 1e-15);
    // It starts with −v_A = −0.019749 m/s.
    assert_close(formula.at(0.0).unwrap().velocity, -0.019749, 5e-7);
}

#[test]
fn with_a_velocity_of_release_it_misses_the_turning_points_too() {
    // Largest distance until rest, and the largest at a turning point.
    for (velocity, farthest, at_turning) in [(0.3, 4.843e-3, 0.890e-3), (-0.3, 4.808e-3, 0.950e-3)]
    {
        let release = State::new(0.1, velocity).unwrap();
        let formula = Formula::corrected(&dry(), release).unwrap();
        assert_close(largest_distance(&formula, &motion(release)), farthest, 5e-7);
        let missed = motion(release)
            .turning_points()
            .map(|point| (formula.at(point.time).unwrap().position - point.position).abs())
            .fold(0.0, f64::max);
        assert_close(missed, at_turning, 5e-7);
    }
}

#[test]
fn the_printed_phase_puts_the_motion_off() {
    // The phase alone, that is with the left side of (68) for v_A.
    let release = State::new(0.1, -0.3).unwrap();
    let printed = eq_78(&dry(), release, Reading::Printed).unwrap();
    assert_close(largest_distance(&printed, &motion(release)), 0.204, 5e-4);
    // With v0 > 0 the printed phase is right.
    let release = State::new(0.1, 0.3).unwrap();
    let printed = eq_78(&dry(), release, Reading::Printed).unwrap();
    assert_close(largest_distance(&printed, &motion(release)), 4.843e-3, 5e-7);
}

#[test]
fn the_formulas_go_on_past_rest_and_grow() {
    let release = State::new(0.1, 0.0).unwrap();
    let at_20_s = |formula: Formula| formula.at(20.0).unwrap().position;
    assert_close(at_20_s(Formula::corrected(&dry(), release).unwrap()), -0.19964, 5e-6);
    assert_close(at_20_s(eq_61(&dry(), 0.1, Reading::Printed).unwrap()), -0.19964, 5e-6);
    assert_close(at_20_s(Formula::printed(&dry(), release).unwrap()), -5.279, 5e-4);
    assert_close(motion(release).at(20.0).unwrap().position, 1.9e-3, 1e-15);
    // The amplitude passes zero one part of a swing after the mass has come to rest.
    let end = Formula::corrected(&dry(), release).unwrap().amplitude_end().unwrap();
    let rest = rest(&motion(release));
    assert_close(rest.time, 4.96729, 5e-6);
    assert!(rest.time < end && end < rest.time + 0.4967, "{end}");
}

fn scheme_positions(position: f64, times: &[f64]) -> Vec<f64> {
    let release = State::new(position, 0.0).unwrap();
    let samples = Scheme::new(&dry(), release, 1e-3).unwrap().sample(times).unwrap();
    assert!(!samples.interpolated);
    samples.samples.iter().map(|sample| sample.position).collect()
}

#[test]
fn the_scheme_creeps_instead_of_sticking() {
    let found = scheme_positions(0.1, &[5.0, 10.0, 20.0]);
    for (found, known) in found.iter().zip([1.897e-3, 1.547e-3, 1.036e-3]) {
        assert_close(*found, known, 5e-7);
    }
    // The mass itself stays where it came to rest.
    let release = State::new(0.1, 0.0).unwrap();
    for time in [5.0, 10.0, 20.0] {
        assert_close(motion(release).at(time).unwrap().position, 1.9e-3, 1e-15);
    }
}

#[test]
fn the_scheme_creeps_out_of_the_sticking_band() {
    assert_close(scheme_positions(4e-3, &[20.0])[0], 1.796e-3, 5e-7);
    let release = State::new(4e-3, 0.0).unwrap();
    assert_eq!(motion(release).at(20.0).unwrap().position, 4e-3);
    assert_eq!(rest(&motion(release)).time, 0.0);
}

#[test]
fn with_coulomb_friction_the_scheme_is_first_order_with_scatter() {
    // At t = 3 s, in the seventh swing; slope by least squares over ten halvings.
    let release = State::new(0.1, 0.0).unwrap();
    let exact = motion(release).at(3.0).unwrap().position;
    let points: Vec<(f64, f64)> = (6..=16)
        .map(|power| {
            let scheme = Scheme::new(&dry(), release, 2f64.powi(-power)).unwrap();
            let found = scheme.sample(&[3.0]).unwrap().samples[0].position;
            (-f64::from(power), (found - exact).abs().log2())
        })
        .collect();
    let mean = |values: &dyn Fn(&(f64, f64)) -> f64| {
        points.iter().map(values).sum::<f64>() / points.len() as f64
    };
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let slope = mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x).powi(2));
    assert!((0.6..=1.5).contains(&slope), "{slope}");
}
