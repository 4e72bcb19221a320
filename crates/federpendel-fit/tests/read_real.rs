//! Recordings of real experiments, where their folder is at hand: `../shared/data` beside the repository, or the
//! folder that FEDERPENDEL_DATA names.

use std::path::{Path, PathBuf};

use federpendel_fit::Quantity;
use federpendel_fit::read::{Choice, Clock, Read, recordings};

fn folder() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let folder = std::env::var_os("FEDERPENDEL_DATA").map_or(beside, PathBuf::from);
    folder.join("README.md").exists().then_some(folder)
}

/// The recording in a file, or none without the folder.
fn read(file: &str) -> Option<Read> {
    let Some(folder) = folder() else {
        println!("skipped, since there is no folder of recordings: {file}");
        return None;
    };
    let bytes = std::fs::read(folder.join(file)).unwrap();
    let mut all = recordings(&bytes, &Choice::default()).unwrap_or_else(|e| panic!("{file}: {e}"));
    assert_eq!(all.len(), 1, "{file}");
    Some(all.remove(0))
}

#[track_caller]
fn check(file: &str, rows: usize, ends: [(f64, f64); 2], quantity: Quantity) {
    let Some(Read { recording, .. }) = read(file) else { return };
    assert_eq!((recording.times.len(), recording.quantity), (rows, quantity), "{file}");
    let at = |row: usize| (recording.times[row], recording.values[row]);
    assert_eq!([at(0), at(rows - 1)], ends, "{file}");
}

/// Rows, first and last of them as `head` and `tail` show them.
#[test]
fn springs() {
    let quantity = Quantity::Position;
    check("nbi_harmosc/data_HarmOsc1.txt", 3806, [(10.0, -0.683), (48.05, -0.473)], quantity);
    check("nbi_harmosc/data_HarmOsc2.txt", 3616, [(0.0, 0.179), (36.15, 0.022)], quantity);
    check("nbi_harmosc/data_HarmOsc3.txt", 13700, [(0.0, 0.614049), (13.699, -0.499952)], quantity);
}

#[test]
fn seismometers() {
    for (file, rows, ends) in [
        ("11mm_damping", 1873, [(0.0, 0.019), (187.2, -0.018)]),
        ("75mm_damping", 2616, [(0.0, 0.014), (261.5, -0.002)]),
        ("Q5_2point5_critical", 203, [(0.0, -0.008), (20.2, -0.002)]),
        ("blow", 1179, [(0.0, 0.205), (117.8, 0.003)]),
        ("blow_2_5", 1105, [(0.0, 0.191), (110.4, -0.007)]),
    ] {
        let file = format!("nyu_seismometer/{file}.txt");
        check(&file, rows, ends, Quantity::Position);
        let Some(read) = read(&file) else { return };
        assert_eq!(read.recording.unit, "V");
    }
}

#[test]
fn free_swings() {
    for (number, first, last) in [(1, -90.36, 24.82), (2, -135.27, -18.82), (3, -45.27, 1.18)] {
        let file = format!("rip_freeswing/pendulum_free_swing_data_0{number}.txt");
        check(&file, 5000, [(0.0, first), (4.999, last)], Quantity::Position);
        let Some(read) = read(&file) else { return };
        assert_eq!(read.clock, Clock::Rate(1000.0));
    }
}

#[test]
fn wheels() {
    let ends = [(0.0, 0.641871019987239), (4.632, 0.01878158926343861)];
    let file =
        |axis| format!("ucdavis_resonance/bicycle-wheel-{axis}-inertia-rate-gyro-measurement.csv");
    check(&file("axial"), 2317, ends, Quantity::Velocity);
    let ends = [(0.0, 3.236790061330015), (2.0000000000000004, -0.030127249708722107)];
    check(&file("radial"), 1001, ends, Quantity::Velocity);
}
