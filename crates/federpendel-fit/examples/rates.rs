//! How often a fit finds the truth, on random recordings of all mixes:
//!
//!     cargo run --release -p federpendel-fit --example rates -- [N] [seed] [correlation]
//!
//! N recordings (1,000) from a seed (1); `correlation` is that of neighbouring values of the noise
//! (0).

use std::time::Instant;

use federpendel::Mix;
use federpendel_fit::plan::{Law, RESOLVED};
use federpendel_fit::{FitReport, Information, Options, Parameters, Standing, Stop, fit};

#[path = "../tests/synthetic/mod.rs"]
mod synthetic;
use synthetic::{Known, Random, known};

#[derive(Default)]
struct Tally {
    hits: usize,
    of: usize,
}

impl Tally {
    fn count(&mut self, hit: bool) {
        self.hits += usize::from(hit);
        self.of += 1;
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let share = 100.0 * self.hits as f64 / self.of.max(1) as f64;
        write!(f, "{share:6.2} %  ({} of {})", self.hits, self.of)
    }
}

const NAMES: [&str; 7] = Parameters::NAMES;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().map_or(Ok(1000), |n| n.parse())?;
    let seed: u64 = arguments.next().map_or(Ok(1), |n| n.parse())?;
    let correlation: f64 = arguments.next().map_or(Ok(0.0), |n| n.parse())?;
    let only: Option<usize> = arguments.next().map(|n| n.parse()).transpose()?;
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut reached = Tally::default();
    let mut covered: [[Tally; 4]; 3] = Default::default();
    let (mut named, mut named_alone, mut absent) =
        (Tally::default(), Tally::default(), Tally::default());
    let (mut adequate, mut cautioned, mut window) =
        (Tally::default(), Tally::default(), Tally::default());
    let mut seconds = Vec::new();
    let mut by_quantity: [Vec<f64>; 3] = Default::default();
    for i in 0..count {
        let known = known(&mut random, correlation)?;
        if only.is_some_and(|only| only != i) {
            continue;
        }
        let options = Options { every_mix: true, ..Options::default() };
        let clock = Clock::start();
        let report = fit(&known.recording, &Options::default());
        seconds.push(clock.seconds());
        by_quantity[known.recording.quantity as usize].extend(seconds.last());
        let Ok(report) = report.and_then(|_| fit(&known.recording, &options)) else {
            println!("{i}: no fit: {:?}", report_error(&known));
            reached.count(false);
            continue;
        };
        let good = at_truth(&known, &report);
        reached.count(good);
        let soon = report.window.first >= known.release && starts_soon(&known, &report);
        window.count(soon);
        if !soon {
            println!("{i}: window {}", describe(&known, &report));
        }
        if !good {
            println!("{i}: {}", describe(&known, &report));
        }
        if let Some(model) = report.model(known.mix) {
            for (tally, k) in covered[known.recording.quantity as usize].iter_mut().zip(0..4) {
                let truth = known.truth.to_array()[k];
                if let Some(p) = model.parameter(NAMES[k]) {
                    let (low, high) = p.interval95;
                    tally.count(low.is_none_or(|l| l <= truth) && high.is_none_or(|h| h >= truth));
                }
            }
        }
        adequate.count(report.adequacy.adequate);
        if !report.adequacy.adequate {
            println!("{i}: inadequate {:?}", report.adequacy.findings);
        }
        cautioned.count(report.adequacy.slight().is_some());
        if let Some(finding) = report.adequacy.slight() {
            println!("{i}: cautioned {finding:?} {}", describe(&known, &report));
        }
        let full = resolution(&known, Mix { stokes: true, coulomb: true, newton: true });
        let own = resolution(&known, known.mix);
        let acts = [known.mix.stokes, known.mix.coulomb, known.mix.newton];
        for law in 0..3 {
            let says = report.verdict.laws[law] == Standing::Acts;
            if !acts[law] {
                absent.count(says);
                if says {
                    println!("{i}: absent law {law} named: {}", describe(&known, &report));
                }
                continue;
            }
            if full[law] >= RESOLVED {
                named.count(says);
                if !says {
                    println!(
                        "{i}: law {law} ({:.1}) missed: {}",
                        full[law],
                        describe(&known, &report)
                    );
                }
            }
            if own[law] >= RESOLVED {
                let verdict = report.verdict.mix;
                named_alone.count([verdict.stokes, verdict.coulomb, verdict.newton][law]);
            }
        }
    }
    seconds.sort_by(f64::total_cmp);
    let at = |share: f64| 1e3 * seconds[((seconds.len() - 1) as f64 * share) as usize];
    println!("true mix at or below the residual of the truth  {reached}");
    println!("window begins in the free motion, and soon      {window}");
    for (quantity, tallies) in ["position", "velocity", "acceleration"].iter().zip(&covered) {
        for (tally, name) in tallies.iter().zip(NAMES) {
            println!("{quantity:<12}: 95 % interval holds {name:<20} {tally}");
        }
    }
    for (k, name) in NAMES.iter().take(4).enumerate() {
        let sum = |of: fn(&Tally) -> usize| covered.iter().map(|tallies| of(&tallies[k])).sum();
        let all = Tally { hits: sum(|tally| tally.hits), of: sum(|tally| tally.of) };
        println!("all         : 95 % interval holds {name:<20} {all}");
    }
    println!("acts, 5 standard errors beside all laws: named  {named}");
    println!("acts, 5 standard errors in the true mix: chosen {named_alone}");
    println!("does not act, but named                         {absent}");
    println!("found adequate                                  {adequate}");
    println!("cautioned of a pattern                          {cautioned}");
    for (quantity, times) in ["position", "velocity", "acceleration"].iter().zip(&by_quantity) {
        let mean = times.iter().sum::<f64>() / times.len().max(1) as f64 * 1e3;
        println!("{quantity:<12}: ms per fit, mean {mean:.0}");
    }
    let mean = seconds.iter().sum::<f64>() / seconds.len() as f64 * 1e3;
    println!(
        "ms per fit: mean {mean:.0}, median {:.0}, 90 % {:.0}, longest {:.0}",
        at(0.5),
        at(0.9),
        at(1.0)
    );
    Ok(())
}

/// Time that this process has the processor, where Linux says it; else time on the wall.
struct Clock(Instant, Option<u64>);

impl Clock {
    fn start() -> Self {
        Clock(Instant::now(), Self::processor())
    }

    fn processor() -> Option<u64> {
        let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
        text.split(' ').next()?.parse().ok()
    }

    fn seconds(&self) -> f64 {
        match (self.1, Self::processor()) {
            (Some(start), Some(end)) => (end - start) as f64 * 1e-9,
            _ => self.0.elapsed().as_secs_f64(),
        }
    }
}

fn report_error(known: &Known) -> Option<federpendel_fit::FitError> {
    fit(&known.recording, &Options::default()).err()
}

fn noise_cost(known: &Known, report: &FitReport) -> f64 {
    known.noise[report.window.first..report.window.end].iter().map(|n| n * n).sum()
}

/// Whether the fit of the true mix is at least as good as the truth.
fn at_truth(known: &Known, report: &FitReport) -> bool {
    let cost = report.model(known.mix).map_or(f64::INFINITY, |model| model.chi_square);
    cost <= noise_cost(known, report) * (1.0 + 1e-9)
}

/// Whether at most a swing of the free motion is given away.
fn starts_soon(known: &Known, report: &FitReport) -> bool {
    let lost = report.window.from - known.recording.times[known.release];
    lost <= 1.5 * std::f64::consts::PI / known.truth.angular_frequency
}

/// The standard errors by which each coefficient is away from zero, at the truth in `mix`.
fn resolution(known: &Known, mix: Mix) -> [f64; 3] {
    let times = &known.recording.times[known.release..];
    let stop = known.rests.map_or(Stop::Never, Stop::After);
    let told = Information::of(&known.truth, stop, times, known.recording.quantity);
    let truth = known.truth.to_array();
    // Infinite where nothing is known, so that nothing is resolved.
    let stderr = |law: Law| match &told {
        Ok(told) if law.is_in(mix) => told.stderr(mix, law.index(), known.sigma),
        _ => f64::INFINITY,
    };
    Law::ALL.map(|law| truth[law.index()] / stderr(law))
}

fn describe(known: &Known, report: &FitReport) -> String {
    let cost = report.model(known.mix).map_or(f64::INFINITY, |model| model.chi_square);
    let swings = (known.recording.times.last().unwrap_or(&0.0) - known.recording.times[0])
        * known.truth.angular_frequency
        / std::f64::consts::PI;
    format!(
        "{} {:?} {:.0} swings {} samples noise {:.4} release {} rests {:?} static {:.2} cost/truth {:.4} window {}..{} {:?} {:?} verdict {} alt {:?} rest {:?}",
        known.mix,
        known.recording.quantity,
        swings,
        known.noise.len(),
        known.sigma,
        known.release,
        known.rests,
        known.static_acceleration / known.truth.coulomb_acceleration,
        cost / noise_cost(known, report),
        report.window.first,
        report.window.end,
        report.window.begins,
        report.window.ends,
        report.verdict.mix,
        report.verdict.alternatives.iter().map(|m| m.to_string()).collect::<Vec<_>>(),
        report.model(known.mix).and_then(|m| m.rest).map(|r| r.turning_points),
    )
}
