//! Pictures of very many swings, beside what even samples of single swings show.

use std::f64::consts::PI;

use federpendel_wasm::Experiment;
use federpendel_wasm::experiment::Laws;
use federpendel_wasm::motion::Solution;
use federpendel_wasm::words::catalogue;

const COUNT: usize = 10_000;
/// 1/s, of 0.5 kg on 20 N/m.
const OMEGA: f64 = 6.324_555_320_336_759;
const STOKES: Laws = Laws { stokes: true, coulomb: false, newton: false };
const COULOMB: Laws = Laws { stokes: false, coulomb: true, newton: false };
const NEWTON: Laws = Laws { stokes: false, coulomb: false, newton: true };
const ALL: Laws = Laws { stokes: true, coulomb: true, newton: true };

/// Friction so weak that thousands of swings show it.
fn weak(laws: Laws) -> Solution {
    let mut experiment = Experiment { laws, duration: 10_000.0, ..Experiment::default() };
    let values =
        [("damping", 2e-4), ("kinetic", 1e-5), ("static", 1e-5), ("area", 1e-6), ("velocity", 0.1)];
    for (name, value) in values {
        experiment.values.insert(name.to_owned(), value);
    }
    Solution::new(&experiment).unwrap()
}

fn columns(numbers: &[f64], count: usize) -> Vec<&[f64]> {
    numbers.chunks(numbers.len() / count).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

#[test]
fn the_course_is_as_high_as_the_motion_everywhere() {
    for laws in [STOKES, COULOMB, NEWTON, ALL] {
        let solution = weak(laws);
        let course = solution.course(0.0, 10_000.0, COUNT).unwrap();
        let course = columns(&course, 4);
        for part in 0..100 {
            let from = 100.0 * f64::from(part);
            let swing = solution.samples(from, from + 2.0 * PI / OMEGA, 1000).unwrap();
            let inside = course[0].partition_point(|time| *time < from)
                ..course[0].partition_point(|time| *time < from + 100.0);
            let (found, known) = (largest(&course[1][inside]), largest(&swing[1000..2000]));
            // A column is 8 s wide, within which the amplitude falls.
            assert!((found - known).abs() < 3e-4, "{laws:?} {from} s: {found}, {known}");
        }
    }
}

#[test]
fn few_swings_are_sampled_evenly() {
    let solution = Solution::new(&Experiment::default()).unwrap();
    let samples = solution.samples(0.0, 5.5, COUNT).unwrap();
    assert_eq!(solution.course(0.0, 5.5, COUNT).unwrap(), samples);
    assert_eq!(solution.energies(COUNT).unwrap(), solution.ledger(5.5, COUNT).unwrap());
}

#[test]
fn the_phase_portrait_is_whole_loops_side_by_side() {
    for laws in [STOKES, COULOMB, NEWTON, ALL] {
        let orbit = weak(laws).orbit(COUNT).unwrap();
        let orbit = columns(&orbit, 4);
        let size = largest(orbit[1]);
        let mut radii = Vec::new();
        for i in 1..orbit[0].len() {
            let place = |i: usize| (orbit[1][i] / size, orbit[2][i] / (OMEGA * size));
            let ((x, v), (x0, v0)) = (place(i), place(i - 1));
            assert!((x - x0).hypot(v - v0) < 0.15 || i == 65, "{laws:?}: {i} {x0} {v0} to {x} {v}");
            radii.push(x.hypot(v));
        }
        // No gap that could be seen between the loops.
        radii.sort_by(f64::total_cmp);
        assert!(radii.windows(2).all(|pair| pair[1] - pair[0] < 0.02), "{laws:?}");
    }
}

#[test]
fn energies_are_means_that_keep_the_sum() {
    for laws in [STOKES, COULOMB, NEWTON, ALL] {
        let solution = weak(laws);
        let energies = solution.energies(COUNT).unwrap();
        let [_, kinetic, potential, stokes, coulomb, newton] = columns(&energies, 6)[..] else {
            panic!()
        };
        let total = solution.summary(catalogue("en")).energy;
        assert!(kinetic.len() > 1000);
        for i in 0..kinetic.len() {
            let heat = stokes[i] + coulomb[i] + newton[i];
            assert!((kinetic[i] + potential[i] + heat - total).abs() < 1e-9 * total);
            let left = total - heat;
            assert!(left < 0.02 * total || (kinetic[i] / left - 0.5).abs() < 0.01, "{laws:?} {i}");
        }
    }
}

#[test]
fn the_envelope_goes_through_the_turning_points() {
    // Strong damping, whose turning points are far from each other.
    let mut experiment = Experiment { laws: STOKES, ..Experiment::default() };
    experiment.values.insert("damping".to_owned(), 1.5);
    let solution = Solution::new(&experiment).unwrap();
    let envelope = solution.envelope(500).unwrap();
    let [times, heights] = columns(&envelope, 2)[..] else { panic!() };
    let turns = solution.turning_points(20);
    let [t, x] = columns(&turns, 2)[..] else { panic!() };
    assert!(t.len() > 8);
    for (t, x) in t.iter().zip(x) {
        let next = times.partition_point(|time| time <= t).clamp(1, 499);
        let part = (t - times[next - 1]) / (times[next] - times[next - 1]);
        let height = heights[next - 1].powf(1.0 - part) * heights[next].powf(part);
        assert!((height / x.abs() - 1.0).abs() < 1e-9, "{t} s: {height}, {x}");
    }
    // With dry friction the points themselves, and of very many those that are asked for.
    for solution in [Solution::new(&Experiment::default()).unwrap(), weak(COULOMB)] {
        let envelope = solution.envelope(500).unwrap();
        let [times, heights] = columns(&envelope, 2)[..] else { panic!() };
        assert!(times.len() <= 500 && *times.last().unwrap() > 0.8 * solution.duration());
        for (time, height) in times.iter().zip(heights) {
            let place = solution.at(*time).unwrap()[0];
            assert!((place.abs() - height).abs() < 1e-12, "{time} s");
        }
    }
}

#[test]
fn swings_of_all_amplitudes_are_in_the_loss_plot() {
    let found = weak(COULOMB).decrement(catalogue("en")).unwrap();
    // 2f, f = μ g m / C.
    let lost = 2.0 * 1e-5 * 9.81 * 0.5 / 20.0;
    assert!(found.loss.iter().all(|loss| (loss / lost - 1.0).abs() < 1e-6));
    let least = found.amplitude.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(least < 0.05 * largest(&found.amplitude), "{least}");
}
