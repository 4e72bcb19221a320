//! Weak Newton friction over 10⁶ periods, and a stiff experiment.

use std::hint::black_box;
use std::time::{Duration, Instant};

use federpendel_benches::clock::{Candidate, Timing, alone};
use federpendel_benches::experiment::{Experiment, STIFF, WEAK_NEWTON};
use federpendel_benches::peers::{dop853_state, stiff_state};

use crate::markdown::{digits, seconds, table, timing};

/// Times at which the stiff experiment is asked for its state, s; it creeps for 3,000 s.
const STIFF_TIMES: [f64; 5] = [1e-5, 1e-3, 1.0, 1e3, 1e4];
/// The peer follows so many periods, and is scaled to 10⁶.
const FOLLOWED: f64 = 1e4;

pub fn section() -> String {
    let weak: Vec<_> = WEAK_NEWTON.iter().map(weak_row).collect();
    let stiff: Vec<_> = STIFF_TIMES.iter().map(|time| stiff_row(*time)).collect();
    table(
        "Weak Newton friction, state after 10⁶ periods",
        &["mix", "ours", "target", "Dop853, 10⁴ periods × 100", "ratio"],
        &weak,
    ) + &table(
        "Stiff: ζ = 10⁴ with Newton friction, any state",
        &["t", "ours", "target", "diffsol bdf", "its error", "Dop853"],
        &stiff,
    )
}

/// One call of something that takes long.
fn once<T>(call: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = black_box(call());
    (result, start.elapsed().as_secs_f64())
}

fn state(experiment: &Experiment, time: f64) -> f64 {
    let motion = black_box(experiment).motion().expect("allowed");
    motion.at(black_box(time)).expect("allowed").position
}

fn weak_row(experiment: &Experiment) -> Vec<String> {
    let candidate: Candidate = Box::new(|| {
        black_box(state(experiment, 1e6 * experiment.period()));
    });
    let ours: Timing = alone(candidate, Duration::ZERO);
    let time = FOLLOWED * experiment.period();
    let (peer, taken) = once(|| dop853_state(experiment, time));
    let scaled = taken * 1e6 / FOLLOWED;
    let (peer, ratio) = match peer {
        Ok(x) => {
            let error = (x - state(experiment, time)).abs() / experiment.position;
            let cell = format!("{}, error then {error:.0e}", seconds(scaled));
            (cell, format!("{} ×", digits(scaled / ours.median)))
        }
        Err(error) => (format!("fails: {error}"), "–".to_owned()),
    };
    vec![experiment.name.to_owned(), timing(ours), "3 s".to_owned(), peer, ratio]
}

fn stiff_row(time: f64) -> Vec<String> {
    let candidate: Candidate = Box::new(|| {
        black_box(state(&STIFF, time));
    });
    let ours = alone(candidate, Duration::from_millis(300));
    let exact = state(&STIFF, time);
    let (found, taken) = once(|| stiff_state(&STIFF, time));
    let (peer, error) = match found {
        Ok(x) => (seconds(taken), format!("{:.0e}", ((x - exact) / STIFF.position).abs())),
        Err(error) => (format!("fails: {error}"), "–".to_owned()),
    };
    // An explicit method needs steps of about 1/γ: beyond a second it would take minutes.
    let explicit = if time <= 1.0 {
        let (found, taken) = once(|| dop853_state(&STIFF, time));
        found.map_or_else(|error| format!("fails: {error}"), |_| seconds(taken))
    } else {
        "–".to_owned()
    };
    vec![format!("{time:e} s"), timing(ours), "10 ms".to_owned(), peer, error, explicit]
}
