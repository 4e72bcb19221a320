//! 10,000 samples of x and v over 20 s, from parameters to filled buffers: targets 12 µs (linear,
//! even), 40 µs (linear, any times), 80 µs (with Newton friction). Ledgers of 2,001 samples.
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use federpendel::even_times;
use federpendel_benches::experiment::{
    DURATION, LINEAR, SAMPLES, fill_at, fill_even, references, shuffled_times, uneven_times,
};
use federpendel_benches::plain;

fn record(criterion: &mut Criterion) {
    let (mut x, mut v) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    let mut group = criterion.benchmark_group("record");
    group.throughput(Throughput::Elements(SAMPLES as u64));
    group.bench_function("stokes, plain libm loop", |bencher| {
        bencher.iter(|| plain::libm(black_box(&LINEAR[1]), DURATION, &mut x, &mut v));
    });
    for experiment in references().into_iter().chain([LINEAR[0], LINEAR[3]]) {
        let name = experiment.name;
        group.bench_function(format!("{name}, even"), |bencher| {
            bencher.iter(|| fill_even(black_box(&experiment), &mut x, &mut v));
        });
        for (times, order) in [(uneven_times(), "uneven"), (shuffled_times(), "shuffled")] {
            group.bench_function(format!("{name}, {order}"), |bencher| {
                bencher.iter(|| fill_at(black_box(&experiment), &times, &mut x, &mut v));
            });
        }
    }
}

fn ledger(criterion: &mut Criterion) {
    let times = even_times(DURATION, 2001).expect("a good grid");
    let mut group = criterion.benchmark_group("ledger");
    for experiment in references() {
        group.bench_function(experiment.name, |bencher| {
            bencher
                .iter(|| black_box(&experiment).motion().and_then(|motion| motion.ledger(&times)));
        });
    }
}

criterion_group!(benches, record, ledger);
criterion_main!(benches);
