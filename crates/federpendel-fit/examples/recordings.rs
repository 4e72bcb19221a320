//! Writes the recordings of `examples/recordings`, whose motions are known, and their truth:
//! `cargo run -p federpendel-fit --example recordings -- FOLDER`

#[path = "../tests/laboratory/mod.rs"]
mod laboratory;
#[path = "../tests/synthetic/mod.rs"]
mod synthetic;

use std::error::Error;
use std::fs;
use std::path::Path;

use laboratory::{EXPERIMENTS, files};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("which folder?")?;
    for (name, bytes) in files()? {
        fs::write(Path::new(&folder).join(name), bytes)?;
    }
    println!("| recording | ω₀ (1/s) | γ (1/s) | a_c (m/s²) | κ (1/m) |\n|---|---|---|---|---|");
    for experiment in &EXPERIMENTS {
        let [omega, gamma, dry, kappa] = experiment.truth();
        let name = experiment.name.replace('#', " ");
        println!("| {name} | {omega:.5} | {gamma:.4} | {dry:.5} | {kappa:.4} |");
    }
    Ok(())
}
