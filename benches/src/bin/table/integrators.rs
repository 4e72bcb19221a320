//! The public integrators on the four reference cases: time, and how far off they are.

use std::hint::black_box;
use std::time::Duration;

use federpendel::even_times;
use federpendel_benches::clock::{Candidate, Timing, race};
use federpendel_benches::experiment::{DURATION, Experiment, SAMPLES, fill_even, references};
use federpendel_benches::peers;

use crate::markdown::{digits, seconds, table, timing};

pub fn section() -> String {
    let references = references();
    let mut rows: Vec<Vec<String>> = vec![vec!["federpendel".to_owned()]];
    rows.extend(peers::ALL.iter().map(|peer| vec![peer.name.to_owned()]));
    let mut reasons = String::new();
    for experiment in &references {
        for (row, outcome) in rows.iter_mut().zip(column(experiment)) {
            row.push(outcome.unwrap_or_else(|reason| {
                reasons += &format!("- {}, {}: {reason}\n", experiment.name, row[0]);
                "fails".to_owned()
            }));
        }
    }
    let mut columns = vec!["10,000 samples"];
    columns.extend(references.iter().map(|experiment| experiment.name));
    let heading = "Integrators: median time, times ours, largest error of x over x0";
    format!("{}What those that fail say:\n\n{reasons}\n", table(heading, &columns, &rows))
}

/// What ours and each peer do with an experiment: a cell of the table, or why there is none.
fn column(experiment: &Experiment) -> Vec<Result<String, String>> {
    let times = even_times(DURATION, SAMPLES).expect("a good grid");
    let (mut x, mut v) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    fill_even(experiment, &mut x, &mut v).expect("allowed");
    let outcomes = peers::ALL.each_ref().map(|peer| peer.run(experiment, &times, true));
    let mut candidates: Vec<Candidate> = vec![Box::new(|| {
        let (mut x, mut v) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
        fill_even(black_box(experiment), &mut x, &mut v).expect("allowed");
        black_box((x, v));
    })];
    for (peer, _) in peers::ALL.iter().zip(&outcomes).filter(|(_, outcome)| outcome.is_ok()) {
        let times = &times;
        candidates.push(Box::new(move || {
            let _ = black_box(peer.run(black_box(experiment), times, false));
        }));
    }
    let timings = race(&mut candidates, Duration::from_secs(2));
    let mut peers = timings[1..].iter();
    let mut cells = vec![Ok(timing(timings[0]))];
    cells.extend(outcomes.into_iter().map(|outcome| {
        let record = outcome?;
        let taken = peers.next().expect("one timing for each that finished");
        let error = error(&record.positions, &x) / experiment.position;
        Ok(finish(*taken, timings[0], error))
    }));
    cells
}

fn finish(taken: Timing, ours: Timing, error: f64) -> String {
    let ratio = digits(taken.median / ours.median);
    format!("{}, {ratio} ×, {error:.0e}", seconds(taken.median))
}

/// Largest difference of the positions; rounding may cost an integrator the last one.
fn error(found: &[f64], exact: &[f64]) -> f64 {
    assert!(found.len() + 1 >= exact.len(), "{} of {} states", found.len(), exact.len());
    found.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
