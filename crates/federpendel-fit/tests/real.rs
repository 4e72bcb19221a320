//! Recordings of real free decays: see the README of the folder of data. Set `FEDERPENDEL_DATA` where it lies
//! elsewhere than beside the repository; without it these tests say so and pass.

use std::path::PathBuf;

use federpendel::Mix;
use federpendel_fit::{Fault, FitReport, Options, Quantity, Recording, Standing, fit};

const STOKES: Mix = Mix { stokes: true, coulomb: false, newton: false };
const COULOMB: Mix = Mix { stokes: false, coulomb: true, newton: false };
const NEWTON: Mix = Mix { stokes: false, coulomb: false, newton: true };
const BOTH: Mix = Mix { stokes: true, coulomb: false, newton: true };

/// The columns of a file of numbers; lines that hold no numbers are passed over.
fn rows(name: &str) -> Option<Vec<Vec<f64>>> {
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data");
    let folder = std::env::var("FEDERPENDEL_DATA").unwrap_or(beside.to_owned());
    let path = PathBuf::from(folder).join(name);
    let Ok(text) = std::fs::read_to_string(&path) else {
        eprintln!("skipped: no {}", path.display());
        return None;
    };
    let row = |line: &str| -> Option<Vec<f64>> {
        let cells = line.split([',', '\t', ' ']).map(str::trim).filter(|cell| !cell.is_empty());
        let row: Option<Vec<f64>> = cells.map(|cell| cell.parse().ok()).collect();
        row.filter(|row| !row.is_empty())
    };
    Some(text.lines().filter_map(row).collect())
}

fn recording(name: &str, quantity: Quantity) -> Option<Recording> {
    let rows = rows(name)?;
    // One column alone is sampled at 1 kHz; the first two lines say so.
    let pair = |(i, row): (usize, &Vec<f64>)| match row.len() {
        1 => (i as f64 * 1e-3, row[0]),
        _ => (row[0], row[1]),
    };
    let rows = rows.iter().filter(|row| row.len() < 3);
    let (times, values) = rows.enumerate().map(pair).unzip();
    Some(Recording { times, values, quantity, unit: String::new() })
}

fn fitted(name: &str, quantity: Quantity) -> Option<FitReport> {
    let recording = recording(name, quantity)?;
    let report = fit(&recording, &Options::default()).unwrap_or_else(|e| panic!("{name}: {e}"));
    show(name, &report);
    Some(report)
}

/// What a person would want to see of it: `cargo test -p federpendel-fit --test real -- --nocapture`.
fn show(name: &str, report: &FitReport) {
    let window = report.window;
    println!(
        "\n{name}: {} s {:?} to {} s {:?}",
        window.from, window.begins, window.to, window.ends
    );
    println!("{} values, as good as {:.0}", report.samples, report.effective_samples);
    for model in &report.models {
        print!(
            "{:>22} AICc {:9.1} rms {:.5}",
            model.mix.to_string(),
            model.criteria.aicc,
            model.rms
        );
        for p in model.parameters.iter().take(4) {
            let (value, stderr) = (p.value.unwrap_or(f64::NAN), p.stderr.unwrap_or(f64::NAN));
            print!("  {} {value:.5} ± {stderr:.5}", p.name);
        }
        println!();
    }
    println!("{:?}\n{:?}\n{:?}", report.verdict, report.adequacy, report.reaches);
}

#[test]
fn a_weight_that_slides_on_metal_has_coulomb_friction_and_stops() {
    let Some(report) = fitted("nbi_harmosc/data_HarmOsc3.txt", Quantity::Position) else { return };
    let best = report.best().expect("a verdict has its model");
    assert!(best.mix.coulomb && report.verdict.laws[1] == Standing::Acts);
    let rest = best.rest.expect("it stops");
    assert!((rest.time - 11.8).abs() < 0.3, "{rest:?}");
    assert!(report.adequacy.adequate);
}

#[test]
fn a_weight_in_air_has_newton_friction() {
    let Some(report) = fitted("nbi_harmosc/data_HarmOsc1.txt", Quantity::Position) else { return };
    assert!(report.verdict.laws[2] == Standing::Acts);
    assert!(report.adequacy.adequate);
    assert!(report.best().is_some_and(|best| best.mix.newton));
    assert_eq!(report.verdict.mix, NEWTON);
}

#[test]
fn a_cardboard_disc_has_newton_and_stokes_friction() {
    let Some(report) = fitted("nbi_harmosc/data_HarmOsc2.txt", Quantity::Position) else { return };
    assert_eq!(report.verdict.mix, BOTH);
    assert!(report.adequacy.adequate);
}

#[test]
fn a_seismometer_with_a_magnet_has_stokes_friction() {
    for name in ["11mm_damping", "75mm_damping", "blow", "blow_2_5"] {
        let name = format!("nyu_seismometer/{name}.txt");
        let Some(report) = fitted(&name, Quantity::Position) else { return };
        // Its swings are so wide that it softens, which the fit says; of the laws Stokes' is still the nearest.
        let rms = |mix| report.model(mix).map_or(f64::INFINITY, |model| model.rms);
        assert!(rms(STOKES) < rms(NEWTON) && rms(STOKES) < rms(COULOMB), "{name}");
    }
}

#[test]
fn a_seismometer_near_critical_is_seen_to_be() {
    let name = "nyu_seismometer/Q5_2point5_critical.txt";
    let Some(report) = fitted(name, Quantity::Position) else { return };
    let stokes = report.model(STOKES).expect("it is fitted");
    let ratio = stokes.value("damping_rate") / stokes.value("angular_frequency");
    assert!((0.5..1.5).contains(&ratio), "{ratio}");
}

#[test]
fn a_pendulum_at_large_angles_is_no_linear_spring() {
    for i in 1..=3 {
        let name = format!("rip_freeswing/pendulum_free_swing_data_0{i}.txt");
        let Some(report) = fitted(&name, Quantity::Position) else { return };
        assert!(!report.adequacy.adequate, "{name}");
        let soft = report.adequacy.findings.iter().any(|f| f.fault == Fault::Softening && f.grave);
        assert!(soft, "{name}");
    }
}

#[test]
fn a_bicycle_wheel_has_a_frequency() {
    for (name, omega) in [("axial", 4.5), ("radial", 13.0)] {
        let name =
            format!("ucdavis_resonance/bicycle-wheel-{name}-inertia-rate-gyro-measurement.csv");
        let Some(report) = fitted(&name, Quantity::Velocity) else { return };
        let best = report.best().expect("a verdict has its model");
        let found = best.value("angular_frequency");
        assert!((found / omega - 1.0).abs() < 0.2, "{name}: {found}");
    }
}
