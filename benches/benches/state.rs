//! The state at one time of each linear mix, near and after 10⁶ periods: target 1 µs.
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use federpendel_benches::experiment::{LINEAR, WEAK_LINEAR};
use federpendel_benches::peers::dop853_state;

fn state(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("state");
    for (experiments, when) in [(LINEAR, "1 s"), (WEAK_LINEAR, "1e6 periods")] {
        for experiment in experiments {
            let motion = experiment.motion().expect("allowed");
            let time = if when == "1 s" { 1.0 } else { 1e6 * experiment.period() + 0.1 };
            group.bench_function(format!("{}, {when}", experiment.name), |bencher| {
                bencher.iter(|| black_box(&motion).at(black_box(time)));
            });
        }
    }
    for experiment in LINEAR {
        group.bench_function(format!("{}, 1 s, Dop853", experiment.name), |bencher| {
            bencher.iter(|| dop853_state(black_box(&experiment), black_box(1.0)));
        });
    }
}

criterion_group!(benches, state);
criterion_main!(benches);
