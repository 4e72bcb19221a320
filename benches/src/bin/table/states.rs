//! The state at one time of a linear mix.

use std::hint::black_box;
use std::time::Duration;

use federpendel_benches::clock::{Candidate, race};
use federpendel_benches::experiment::{Experiment, LINEAR, WEAK_LINEAR};
use federpendel_benches::peers::dop853_state;

use crate::markdown::{ratio, table, timing};

pub fn section() -> String {
    let rows: Vec<_> =
        LINEAR.iter().zip(&WEAK_LINEAR).map(|(usual, weak)| row(usual, weak)).collect();
    let columns = [
        "mix",
        "t = 1 s",
        "10⁶ periods",
        "target",
        "with parameters, 10⁶ periods",
        "Dop853 to 1 s",
        "ratio",
    ];
    table("State at one time, linear mixes", &columns, &rows)
}

fn row(usual: &Experiment, weak: &Experiment) -> Vec<String> {
    let (near, far) = (usual.motion().expect("allowed"), weak.motion().expect("allowed"));
    let late = 1e6 * weak.period() + 0.1;
    let candidates: &mut [Candidate] = &mut [
        Box::new(|| {
            black_box(black_box(&near).at(black_box(1.0)).expect("allowed"));
        }),
        Box::new(|| {
            black_box(black_box(&far).at(black_box(late)).expect("allowed"));
        }),
        Box::new(|| {
            let motion = black_box(weak).motion().expect("allowed");
            black_box(motion.at(black_box(late)).expect("allowed"));
        }),
    ];
    let timings = race(candidates, Duration::from_secs(1));
    let (peer, factor) = match dop853_state(usual, 1.0) {
        Err(error) => (format!("fails: {error}"), "–".to_owned()),
        Ok(x) => {
            let exact = near.at(1.0).expect("allowed").position;
            assert!((x - exact).abs() < 1e-6 * usual.position, "Dop853: {x}, exact: {exact}");
            let near: Candidate = Box::new(|| {
                black_box(black_box(&near).at(black_box(1.0)).expect("allowed"));
            });
            let peer: Candidate = Box::new(|| {
                let _ = black_box(dop853_state(black_box(usual), 1.0));
            });
            let timings = race(&mut [near, peer], Duration::from_secs(1));
            (timing(timings[1]), ratio(timings[1], timings[0]))
        }
    };
    vec![
        usual.name.to_owned(),
        timing(timings[0]),
        timing(timings[1]),
        "1 µs".to_owned(),
        timing(timings[2]),
        peer,
        factor,
    ]
}
