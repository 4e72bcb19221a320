//! Weak Newton friction after 10⁶ periods (target 3 s), and any state of a stiff experiment (10 ms).
#![allow(missing_docs)]

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use federpendel_benches::experiment::{STIFF, WEAK_NEWTON};
use federpendel_benches::peers::stiff_state;

fn weak(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("1e6 periods");
    group.sample_size(10).warm_up_time(Duration::from_millis(1));
    for experiment in WEAK_NEWTON {
        let time = 1e6 * experiment.period();
        group.bench_function(experiment.name, |bencher| {
            bencher.iter(|| black_box(&experiment).motion().and_then(|motion| motion.at(time)));
        });
    }
}

fn stiff(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("stiff");
    for time in [1e-5, 1e-3, 1.0, 1e3, 1e4] {
        group.bench_function(format!("{time:e} s"), |bencher| {
            bencher.iter(|| black_box(&STIFF).motion().and_then(|motion| motion.at(time)));
        });
        group.bench_function(format!("{time:e} s, diffsol bdf"), |bencher| {
            bencher.iter(|| stiff_state(black_box(&STIFF), time));
        });
    }
}

criterion_group!(benches, weak, stiff);
criterion_main!(benches);
