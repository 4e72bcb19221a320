//! The public integrators on the reference cases that they finish; those that they do not are named.
#![allow(missing_docs)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use federpendel::even_times;
use federpendel_benches::experiment::{DURATION, SAMPLES, fill_even, references};
use federpendel_benches::peers;

fn integrators(criterion: &mut Criterion) {
    let times = even_times(DURATION, SAMPLES).expect("a good grid");
    let (mut x, mut v) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
    let mut group = criterion.benchmark_group("integrators");
    for experiment in references() {
        let name = experiment.name;
        group.bench_function(format!("{name}, federpendel"), |bencher| {
            bencher.iter(|| fill_even(black_box(&experiment), &mut x, &mut v));
        });
        for peer in &peers::ALL {
            if let Err(reason) = peer.run(&experiment, &times, false) {
                eprintln!("{name}, {} fails: {reason}", peer.name);
                continue;
            }
            group.bench_function(format!("{name}, {}", peer.name), |bencher| {
                bencher.iter(|| peer.run(black_box(&experiment), &times, false));
            });
        }
    }
}

criterion_group!(benches, integrators);
criterion_main!(benches);
