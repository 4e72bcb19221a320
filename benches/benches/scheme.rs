//! Steps of the article's scheme beside the same loop in C: no slower.
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use federpendel::State;
use federpendel::scheme::article::Scheme;
use federpendel_benches::experiment::references;
use federpendel_benches::plain;

const STEPS: usize = 100_000;
const TIME_STEP: f64 = 1e-3;

fn scheme(criterion: &mut Criterion) {
    let mut x = vec![0.0; STEPS + 1];
    let mut group = criterion.benchmark_group("scheme");
    group.throughput(Throughput::Elements(STEPS as u64));
    for experiment in references() {
        let motion = experiment.motion().expect("allowed");
        let release = State::new(experiment.position, 0.0).expect("allowed");
        group.bench_function(experiment.name, |bencher| {
            bencher.iter(|| {
                let scheme = Scheme::new(black_box(motion.oscillator()), release, TIME_STEP);
                scheme.and_then(|scheme| scheme.fill(&mut x))
            });
        });
        group.bench_function(format!("{}, C loop", experiment.name), |bencher| {
            bencher.iter(|| plain::c_scheme(black_box(&experiment), TIME_STEP, &mut x));
        });
    }
}

criterion_group!(benches, scheme);
criterion_main!(benches);
