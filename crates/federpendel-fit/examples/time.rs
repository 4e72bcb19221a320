//! What a fit of all eight mixes costs: `cargo run --release -p federpendel-fit --example time -- 200 1`
//! (number of recordings, seed).
//!
//! Random recordings of 2,000 samples, on one core, with intervals from standard errors and from profiles (of the
//! verdict's mix, and of every mix).

#[path = "../tests/synthetic/mod.rs"]
mod synthetic;

use std::error::Error;
use std::time::Instant;

use federpendel_fit::{Intervals, Options, Recording, fit};
use synthetic::{Random, known_of};

const SAMPLES: usize = 2000;

/// Milliseconds of a fit.
fn milliseconds(recording: &Recording, options: &Options) -> Result<f64, Box<dyn Error>> {
    let began = Instant::now();
    fit(recording, options)?;
    Ok(began.elapsed().as_secs_f64() * 1e3)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().map_or(Ok(200), |text| text.parse())?;
    let mut random = Random(arguments.next().map_or(Ok(1), |text| text.parse())?);
    let with = |intervals, every_mix| Options { intervals, every_mix, ..Options::default() };
    let ways = [
        ("standard errors", with(Intervals::Covariance, false)),
        ("profiles, verdict", with(Intervals::Profile, false)),
        ("profiles, every mix", with(Intervals::Profile, true)),
    ];
    let mut times = ways.each_ref().map(|_| Vec::new());
    for _ in 0..count {
        let known = known_of(&mut random, 0.0, Some(SAMPLES))?;
        for ((_, options), times) in ways.iter().zip(&mut times) {
            times.push(milliseconds(&known.recording, options)?);
        }
    }
    println!("ms for all mixes of {SAMPLES} samples, {count} recordings");
    println!("{:<22}{:>8}{:>8}{:>8}", "intervals from", "median", "90 %", "most");
    for ((name, _), times) in ways.iter().zip(&mut times) {
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times[((count - 1) as f64 * share) as usize];
        println!("{name:<22}{:>8.1}{:>8.1}{:>8.1}", at(0.5), at(0.9), at(1.0));
    }
    Ok(())
}
