//! What an evaluation of the model costs: `cargo run --release -p federpendel-fit --example cost`.
//!
//! Times are the least of many, for 2,000 samples of 30 swings on one core, beside those of `Motion::sample`.

use std::hint::black_box;
use std::time::Instant;

use federpendel_fit::model::evaluate;
use federpendel_fit::{Jacobian, Parameters, Quantity, Stop};

const SAMPLES: usize = 2000;
const OMEGA: f64 = 6.3;
const SWINGS: f64 = 30.0;
const REPEATS: usize = 2000;

/// Least time of one call, µs.
fn least(mut call: impl FnMut()) -> f64 {
    let time = |_| {
        let began = Instant::now();
        call();
        began.elapsed().as_secs_f64() * 1e6
    };
    (0..REPEATS).map(time).fold(f64::INFINITY, f64::min)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let duration = SWINGS * std::f64::consts::PI / OMEGA;
    let times: Vec<f64> =
        (0..SAMPLES).map(|i| duration * i as f64 / (SAMPLES - 1) as f64).collect();
    println!("µs for {SAMPLES} samples of {SWINGS} swings");
    println!("{:<26}{:>8}{:>10}{:>16}", "mix", "values", "Jacobian", "Motion::sample");
    for mix in 0..8 {
        let acts = |law: u32, strength: f64| if mix >> law & 1 == 1 { strength } else { 0.0 };
        let parameters = Parameters {
            angular_frequency: OMEGA,
            damping_rate: acts(0, 0.06),
            coulomb_acceleration: acts(1, 0.15),
            newton_rate: acts(2, 0.1),
            position0: 1.0,
            velocity0: 0.3,
            equilibrium: 0.02,
        };
        let stop = Stop::Natural { static_acceleration: parameters.coulomb_acceleration };
        let (mut values, mut other) = (vec![0.0; SAMPLES], vec![0.0; SAMPLES]);
        let mut jacobian = Jacobian::new();
        let alone = least(|| {
            let result = evaluate(&parameters, stop, &times, Quantity::Position, &mut values, None);
            black_box(result.is_ok());
        });
        let both = least(|| {
            let jacobian = Some(&mut jacobian);
            let result =
                evaluate(&parameters, stop, &times, Quantity::Position, &mut values, jacobian);
            black_box(result.is_ok());
        });
        let exact = least(|| {
            // The motion is made anew each time, as a fit would have to.
            let result = parameters
                .motion(parameters.coulomb_acceleration)
                .map(|m| m.sample(&times, &mut values, &mut other));
            black_box(result.is_ok());
        });
        let laws = ["Stokes", "Coulomb", "Newton"];
        let names: Vec<&str> = (0..3).filter(|i| mix >> i & 1 == 1).map(|i| laws[i]).collect();
        let name = if names.is_empty() { "none".into() } else { names.join(" + ") };
        println!("{name:<26}{alone:>8.1}{both:>10.1}{exact:>16.1}");
    }
    Ok(())
}
