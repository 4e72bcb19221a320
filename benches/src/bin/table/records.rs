//! Records of 10,000 samples, and ledgers of 2,001.

use std::hint::black_box;
use std::time::Duration;

use federpendel::even_times;
use federpendel_benches::clock::{Candidate, race};
use federpendel_benches::experiment::{
    DURATION, Experiment, LINEAR, SAMPLES, fill_at, fill_even, references, shuffled_times,
    uneven_times,
};
use federpendel_benches::plain;

use crate::markdown::{digits, ratio, seconds, table, timing};

const PATIENCE: Duration = Duration::from_secs(3);

pub fn section() -> String {
    let mut experiments: Vec<Experiment> = references().to_vec();
    experiments.extend([LINEAR[0], LINEAR[3]]);
    let rows: Vec<_> = experiments.iter().map(row).collect();
    let columns =
        ["record", "even", "target", "per 8", "uneven", "target", "shuffled", "libm loop", "ratio"];
    let records = table("Records: 10,000 samples of x and v over 20 s", &columns, &rows);
    records + &floor() + &ledgers()
}

/// A candidate that fills buffers of its own.
fn filling<'a>(mut fill: impl FnMut(&mut [f64], &mut [f64]) + 'a) -> Candidate<'a> {
    let (mut x, mut v) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    Box::new(move || {
        fill(&mut x, &mut v);
        black_box((&mut x, &mut v));
    })
}

fn row(experiment: &Experiment) -> Vec<String> {
    let (uneven, shuffled) = (uneven_times(), shuffled_times());
    let at = |times, x: &mut [f64], v: &mut [f64]| {
        fill_at(black_box(experiment), black_box(times), x, v).expect("allowed");
    };
    let stokes = LINEAR[1];
    let timings = race(
        &mut [
            filling(|x, v| fill_even(black_box(experiment), x, v).expect("allowed")),
            filling(|x, v| at(&uneven, x, v)),
            filling(|x, v| at(&shuffled, x, v)),
            filling(|x, v| plain::libm(black_box(&stokes), DURATION, x, v)),
        ],
        PATIENCE,
    );
    let (even, any) = match experiment.newton {
        0.0 => ("12 µs", "40 µs"),
        _ => ("80 µs", "–"),
    };
    vec![
        experiment.name.to_owned(),
        timing(timings[0]),
        even.to_owned(),
        seconds(timings[0].least * 8.0 / SAMPLES as f64),
        timing(timings[1]),
        any.to_owned(),
        timing(timings[2]),
        timing(timings[3]),
        ratio(timings[3], timings[0]),
    ]
}

/// What memory alone costs.
fn floor() -> String {
    let times = uneven_times();
    let timings = race(
        &mut [
            filling(|x, v| {
                x.fill(black_box(1.0));
                v.fill(black_box(2.0));
            }),
            filling(|x, v| {
                x.copy_from_slice(black_box(&times));
                v.copy_from_slice(black_box(&times));
            }),
        ],
        Duration::from_secs(1),
    );
    let rate = 16.0 * SAMPLES as f64 / timings[0].least * 1e-9;
    format!(
        "Filling both buffers with constants takes {} ({} GB/s), with a copy of the times {}: \
         memory is the limit of none of them.\n\n",
        timing(timings[0]),
        digits(rate),
        timing(timings[1])
    )
}

fn ledgers() -> String {
    let times = even_times(DURATION, 2001).expect("a good grid");
    let row = |experiment: &Experiment| {
        let ledger: Candidate = Box::new(|| {
            let motion = black_box(experiment).motion().expect("allowed");
            black_box(motion.ledger(&times).expect("allowed"));
        });
        let samples: Candidate = Box::new(|| {
            let motion = black_box(experiment).motion().expect("allowed");
            black_box(motion.samples(&times).expect("allowed"));
        });
        let timings = race(&mut [ledger, samples], Duration::from_secs(1));
        vec![experiment.name.to_owned(), timing(timings[0]), timing(timings[1])]
    };
    let rows: Vec<_> = references().iter().map(row).collect();
    table(
        "Ledgers: 2,001 samples over 20 s",
        &["experiment", "energy ledger", "samples (x, v, a, mode) alone"],
        &rows,
    )
}
