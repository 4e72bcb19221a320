//! The samples of a public integrator on one of the reference cases, as `federpendel score` reads them:
//! `cargo run --release --bin samples -- "ode_solvers Dopri5" laboratory-c > samples.csv`

use std::process::ExitCode;

use federpendel::even_times;
use federpendel_benches::experiment::{DURATION, Experiment, references};
use federpendel_benches::peers::{self, Peer};

/// Samples over the record.
const SAMPLES: usize = 2001;

/// The problems of `reference/` that the reference cases are, in their order.
const PROBLEMS: [&str; 4] = ["laboratory-s", "laboratory-c", "laboratory-n", "laboratory-scn"];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let found = match &arguments[..] {
        [peer, problem] => find(peer, problem),
        _ => Err("usage: samples PEER PROBLEM".to_owned()),
    };
    match found.and_then(|(peer, experiment)| samples(peer, &experiment)) {
        Ok(table) => {
            print!("{table}");
            ExitCode::SUCCESS
        }
        Err(reason) => {
            eprintln!("{reason}");
            ExitCode::FAILURE
        }
    }
}

fn find(peer: &str, problem: &str) -> Result<(&'static Peer, Experiment), String> {
    const ALL: &[Peer] = &peers::ALL;
    let peer = ALL.iter().find(|known| known.name == peer);
    let peer = peer.ok_or_else(|| {
        let names: Vec<_> = ALL.iter().map(|known| known.name).collect();
        format!("no such peer; there are {}", names.join(", "))
    })?;
    let place = PROBLEMS.iter().position(|known| *known == problem);
    let place = place.ok_or_else(|| format!("does not apply; only {}", PROBLEMS.join(", ")))?;
    Ok((peer, references()[place]))
}

/// Times and positions; an integrator that rounding has cost the last state gives one sample less.
fn samples(peer: &Peer, experiment: &Experiment) -> Result<String, String> {
    let times = even_times(DURATION, SAMPLES).map_err(|error| error.to_string())?;
    let record = peer.run(experiment, &times, true)?;
    let rows = times.iter().zip(&record.positions).map(|(t, x)| format!("{t:?},{x:?}\n"));
    Ok(std::iter::once("time,position\n".to_owned()).chain(rows).collect())
}
