//! The article's scheme beside the same loop in C.

use std::hint::black_box;
use std::time::Duration;

use federpendel::State;
use federpendel::scheme::article::Scheme;
use federpendel_benches::clock::{Candidate, race};
use federpendel_benches::experiment::{Experiment, references};
use federpendel_benches::plain;

use crate::markdown::{digits, table};

const STEPS: usize = 100_000;
const TIME_STEP: f64 = 1e-3;

pub fn section() -> String {
    let rows: Vec<_> = references().iter().map(row).collect();
    let columns = [
        "experiment",
        "ours, 10⁶ steps/s",
        "plain C loop (-O2)",
        "ratio",
        "target",
        "largest difference",
    ];
    table("The article's scheme, 100,000 steps kept", &columns, &rows)
}

fn row(experiment: &Experiment) -> Vec<String> {
    let (mut ours, mut theirs) = (vec![0.0; STEPS + 1], vec![0.0; STEPS + 1]);
    let motion = experiment.motion().expect("allowed");
    let release = State::new(experiment.position, 0.0).expect("allowed");
    let candidates: [Candidate; 2] = [
        Box::new(|| {
            let scheme = Scheme::new(black_box(motion.oscillator()), release, TIME_STEP);
            scheme.and_then(|scheme| scheme.fill(&mut ours)).expect("it does not diverge");
            black_box(&mut ours);
        }),
        Box::new(|| {
            plain::c_scheme(black_box(experiment), TIME_STEP, &mut theirs);
            black_box(&mut theirs);
        }),
    ];
    let timings = race(&mut { candidates }, Duration::from_secs(2));
    let rate = |seconds: f64| digits(STEPS as f64 / seconds * 1e-6);
    let both = |i: usize| format!("{} / {}", rate(timings[i].least), rate(timings[i].median));
    let ratio = timings[1].median / timings[0].median;
    // In the sum of all the rounding of either loop decides when it chatters: compare early.
    let difference = ours.iter().zip(&theirs).take(STEPS / 100).map(|(a, b)| (a - b).abs());
    vec![
        experiment.name.to_owned(),
        both(0),
        both(1),
        format!("{} ×", digits(ratio)),
        "1 ×".to_owned(),
        format!("{:.0e} m", difference.fold(0.0, f64::max)),
    ]
}
