//! `simulate --noise`: recordings as a sensor would make them.

mod common;

use common::Workplace;

/// Times and values that a run writes, and the header.
fn recording(arguments: &[&str]) -> (String, Vec<[f64; 2]>) {
    let finished = Workplace::new().run(&[&["simulate", "--format", "csv"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{arguments:?}: {}", finished.err);
    let mut lines = finished.out.lines();
    let header = lines.next().expect("a header").to_owned();
    let number = |cell: &str| cell.parse::<f64>().expect("a number");
    let row = |line: &str| {
        let cells: Vec<_> = line.split(',').map(number).collect();
        [cells[0], cells[1]]
    };
    (header, lines.map(row).collect())
}

/// Mean and standard deviation of what the noise has added to the column of this place.
fn added(noise: &str, place: usize) -> (String, f64, f64) {
    let (header, noisy) = recording(&["--noise", noise, "--seed", "7", "--samples", "20001"]);
    let plain = Workplace::new().run(&["simulate", "--format", "csv", "--samples", "20001"]);
    let exact = plain.out.lines().skip(1).map(|line| {
        line.split(',').nth(place).and_then(|cell| cell.parse::<f64>().ok()).expect("a number")
    });
    let noise: Vec<f64> = noisy.iter().zip(exact).map(|(noisy, exact)| noisy[1] - exact).collect();
    assert_eq!(noise.len(), 20001);
    let count = noise.len() as f64;
    let mean = noise.iter().sum::<f64>() / count;
    let square = noise.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count;
    (header, mean, square.sqrt())
}

#[test]
fn noise_has_the_deviation_that_was_asked_for_in_the_column_of_its_unit() {
    for (noise, place, deviation, column) in [
        ("1 mm", 1, 1e-3, "Time (s),Position (m)"),
        ("0.002", 1, 2e-3, "Time (s),Position (m)"),
        ("5 mm/s", 2, 5e-3, "Time (s),Velocity (m/s)"),
        ("3 cm/s^2", 3, 0.03, "Time (s),Acceleration (m/s^2)"),
    ] {
        let (header, mean, found) = added(noise, place);
        assert_eq!(header, column);
        // Twenty thousand values: 0.5 % of the deviation, and four times that to be safe.
        assert!((found / deviation - 1.0).abs() < 0.02, "{noise}: {found}");
        assert!(mean.abs() < 4.0 * deviation / 20001f64.sqrt(), "{noise}: {mean}");
    }
}

#[test]
fn a_seed_gives_its_noise_again() {
    let noisy = |seed: &str| recording(&["--noise", "1 mm", "--seed", seed]).1;
    assert_eq!(noisy("3"), noisy("3"));
    assert_ne!(noisy("3"), noisy("4"));
    assert_eq!(noisy("0"), recording(&["--noise", "1 mm"]).1);
    let silent = recording(&["--noise", "0 m"]).1;
    assert_eq!(silent[0], [0.0, 0.1]);
}

#[test]
fn what_makes_no_recording_is_refused() {
    let workplace = Workplace::new();
    for (arguments, said) in [
        (&["simulate", "--noise", "1 mm"][..], ".csv"),
        (&["simulate", "--noise", "1 mm", "-o", "a.svg"], ".csv"),
        (&["simulate", "--seed", "1", "-o", "a.csv"], "--noise"),
        (&["simulate", "--noise", "1 kg", "-o", "a.csv"], "--noise"),
        (&["simulate", "--noise", "-1 mm", "-o", "a.csv"], "--noise"),
        (&["simulate", "--noise", "1 mm", "--seed", "x", "-o", "a.csv"], "--seed"),
    ] {
        let finished = workplace.run(arguments);
        assert_eq!(finished.status, Some(2), "{arguments:?}");
        assert!(finished.err.contains(said), "{arguments:?}: {}", finished.err);
        assert!(workplace.files().is_empty(), "{arguments:?}");
    }
}
