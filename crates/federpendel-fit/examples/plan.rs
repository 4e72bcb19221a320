//! Whether plans keep their promises: recordings as planned are made and fitted, and others from a third of the
//! amplitude.
//!
//!     cargo run --release -p federpendel-fit --example plan -- [N] [seed]
//!
//! N recordings (200) of each, from a seed (1).

use federpendel_fit::plan::plan;

#[path = "../tests/planned/mod.rs"]
mod planned;
#[path = "../tests/synthetic/mod.rs"]
mod synthetic;

use planned::{EXPERIMENTS, record_and_fit};
use synthetic::Random;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().map_or(Ok(200), |n| n.parse())?;
    let seed: u64 = arguments.next().map_or(Ok(1), |n| n.parse())?;
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    println!(
        "| experiment | quantity | law | planned | promised | spread/promised | named | named from a third |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for experiment in &EXPERIMENTS {
        let setup = experiment.setup()?;
        for prospect in plan(&setup)?.prospects {
            let law = prospect.law;
            print!("| {} | {:?} | {law:?} | ", experiment.name, setup.quantity);
            let Some((amplitude, resolution)) = prospect.smallest else {
                println!("not up to {:.3} m |", setup.max_amplitude);
                continue;
            };
            let duration = resolution.duration;
            let mut fitted =
                |amplitude| record_and_fit(&setup, law, (amplitude, duration), count, &mut random);
            let (found, third) = (fitted(amplitude)?, fitted(amplitude / 3.0)?);
            println!(
                "{:.2} cm, {duration:.1} s | {:.1} σ | {:.2} | {:.1} % | {:.1} % |",
                100.0 * amplitude,
                resolution.significance,
                found.spread(prospect.coefficient) / resolution.stderr,
                100.0 * found.share_named(),
                100.0 * third.share_named(),
            );
        }
    }
    Ok(())
}
