//! Recordings in the page.

use std::fs;
use std::path::{Path, PathBuf};

use federpendel_wasm::asked::Asked;
use federpendel_wasm::motion::Solution;
use federpendel_wasm::words::catalogue;
use federpendel_wasm::{Experiment, presets, recording};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn example_recordings_are_fitted_and_told() {
    let folder = root().join("examples/recordings");
    let mut fitted = 0;
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
        let name = entry.file_name().into_string().unwrap();
        if name.ends_with(".md") {
            continue;
        }
        let bytes = fs::read(entry.path()).unwrap();
        for language in ["en", "de"] {
            for fit in
                recording::fits(&bytes, &name, &Asked::default(), catalogue(language)).unwrap()
            {
                let shown = fit.shown(catalogue(language));
                assert!(!shown.sentences.is_empty() && shown.rows.len() > 2, "{shown:?}");
                let numbers = fit.numbers();
                let all = (numbers.len() - 2 * shown.count) / 2;
                assert!(shown.first + shown.count <= all && all > 10);
                // What is recorded is the fit and what it leaves.
                for i in 0..shown.count {
                    let value = numbers[all + shown.first + i];
                    let sum = numbers[2 * all + i] + numbers[2 * all + shown.count + i];
                    assert!((value - sum).abs() <= 1e-12 * value.abs().max(1.0));
                }
                fitted += 1;
            }
        }
    }
    assert!(fitted >= 10, "{fitted}");
}

#[test]
fn a_workbook_is_fitted_as_its_text_is() {
    let fits = |file: &str| {
        let bytes = fs::read(root().join(file)).unwrap();
        let fits = recording::fits(&bytes, "vernier", &Asked::default(), catalogue("de")).unwrap();
        fits.iter()
            .map(|fit| (fit.numbers(), fit.shown(catalogue("de")).sentences))
            .collect::<Vec<_>>()
    };
    let text = fits("examples/recordings/vernier.csv");
    assert_eq!(text.len(), 1);
    for book in ["vernier.xls", "vernier.xlsx"] {
        assert_eq!(fits(&format!("crates/federpendel-fit/tests/data/{book}")), text);
    }
}

#[test]
fn a_simulated_motion_is_found_again() {
    let presets = presets::presets(catalogue("en"));
    let given = presets.into_iter().find(|preset| preset.id == "all-three").unwrap().experiment;
    let samples = Solution::new(&given).unwrap().samples(0.0, given.duration, 1001).unwrap();
    // Time and place alone, as a camera has them, to a hundredth of a millimetre.
    let mut text = "Zeit (s);Auslenkung (m)".to_owned();
    for (time, place) in samples.iter().zip(&samples[1001..2002]) {
        text += &format!("\n{time};{place:.5}").replace('.', ",");
    }
    let fits =
        recording::fits(text.as_bytes(), "all.csv", &Asked::default(), catalogue("de")).unwrap();
    let found: Experiment = fits[0].shown(catalogue("de")).experiment.unwrap();
    for (name, share) in
        [("stiffness", 1e-3), ("damping", 0.1), ("kinetic", 0.1), ("position", 1e-2)]
    {
        let (found, given) = (found.value(name), given.value(name));
        assert!((found / given - 1.0).abs() < share, "{name}: {found}, {given}");
    }
    let end =
        |experiment: &Experiment| Solution::new(experiment).unwrap().samples(0.0, 10.0, 2).unwrap();
    assert!((end(&found)[3] - end(&given)[3]).abs() < 1e-3);
}

#[test]
fn files_that_are_no_recordings_are_refused_in_a_sentence() {
    let workbook = fs::read(root().join("crates/federpendel-fit/tests/data/vernier.xls")).unwrap();
    for (bytes, name) in [
        (&b""[..], "empty.csv"),
        (b"hello, world", "text.txt"),
        (b"\x89PNG\r\n", "picture.png"),
        (b"PK\x03\x04 broken", "broken.zip"),
        (b"t;x\n0;1\n1;2\n", "short.csv"),
        (b"t;x\n0;1\n1;1\n2;1\n3;1\n4;1\n5;1\n6;1\n7;1\n8;1\n9;1\n10;1\n", "still.csv"),
        (&workbook[..workbook.len() / 2], "half.xls"),
    ] {
        for language in ["en", "de"] {
            match recording::fits(bytes, name, &Asked::default(), catalogue(language)) {
                Ok(_) => panic!("{name} has been fitted"),
                Err(refusal) => {
                    assert_eq!(refusal.field, "file");
                    assert!(refusal.message.len() > 20, "{name}: {}", refusal.message);
                    // Neither a flag of the command line, nor what a library says in its own language.
                    assert!(!refusal.message.contains("--"), "{}", refusal.message);
                    assert!(!refusal.message.contains("EOCD"), "{}", refusal.message);
                }
            }
        }
    }
}

/// One fit of an example recording, as the page shows it in English.
fn shown(file: &str, asked: Asked) -> recording::Shown {
    let bytes = fs::read(root().join("examples/recordings").join(file)).unwrap();
    let fits = recording::fits(&bytes, file, &asked, catalogue("en")).unwrap();
    fits[0].shown(catalogue("en"))
}

/// The number at the beginning of the value of a row.
fn number(shown: &recording::Shown, name: &str) -> f64 {
    let row = shown.rows.iter().find(|(row, _)| row.starts_with(name));
    let (_, value) = row.unwrap_or_else(|| panic!("{name}: {:?}", shown.rows));
    value.split(' ').next().unwrap().parse().unwrap()
}

#[test]
fn what_was_measured_beside_a_recording_makes_physical_numbers() {
    let bare = shown("vernier.csv", Asked::default());
    let asked = [("mass", "250(1) g"), ("support", "horizontal")];
    let known = shown("vernier.csv", asked.into());
    assert!(!bare.rows.iter().any(|(name, _)| name.starts_with("kinetic coefficient")));
    // C = m ω0² and μ = a_c/g, from the numbers that are shown, rounded as they are.
    let omega = 2.0 * std::f64::consts::PI * number(&known, "natural frequency");
    let stiffness = number(&known, "stiffness");
    assert!((stiffness / (0.25 * omega * omega) - 1.0).abs() < 0.01, "{stiffness}, {omega}");
    // The motion is simulated with the mass that is known.
    let simulated = known.experiment.as_ref().unwrap();
    assert!((simulated.value("mass") - 0.25).abs() < 1e-12);
    assert!((simulated.value("stiffness") / stiffness - 1.0).abs() < 0.01);
    assert!(
        (simulated.value("kinetic") / number(&known, "kinetic coefficient") - 1.0).abs() < 0.05
    );
    // The force of a spring scale in place of the weight: μ m g = F_c either way.
    let asked = [("mass", "250(1) g"), ("support", "force"), ("normal_force", "2,45 N")];
    let forced = shown("vernier.csv", asked.into());
    let ratio = number(&forced, "kinetic coefficient") / number(&known, "kinetic coefficient");
    assert!((ratio - 0.25 * 9.81 / 2.45).abs() < 0.02, "{ratio}");
}

#[test]
fn a_part_and_a_column_are_fitted_as_asked() {
    let whole = shown("vernier.csv", Asked::default());
    let part = shown("vernier.csv", [("from", "1"), ("to", "4,5 s")].into());
    assert!(part.count < whole.count);
    let column = &whole.time_columns[0];
    let same = shown("vernier.csv", [("time", column.value.as_str())].into());
    assert_eq!(same.sentences, whole.sentences);
}

#[test]
fn a_field_is_refused_by_its_own_name() {
    let bytes = fs::read(root().join("examples/recordings/vernier.csv")).unwrap();
    for (field, written) in [
        ("mass", "250 N"),
        ("stiffness", "-3 N/m"),
        ("spring_mass", "heavy"),
        ("from", "x"),
        ("rate", "0 Hz"),
        ("unit", "kg"),
    ] {
        let asked = Asked::from([(field, written)]);
        for language in ["en", "de"] {
            let found = recording::fits(&bytes, "a.csv", &asked, catalogue(language));
            let refusal = found.err().unwrap_or_else(|| panic!("{field} {written} is taken"));
            assert_eq!(refusal.field, field, "{}", refusal.message);
            assert!(refusal.message.contains(written), "{}", refusal.message);
            assert!(!refusal.message.contains("--"), "{}", refusal.message);
        }
    }
    let asked = Asked::from([("from", "5"), ("to", "2")]);
    assert_eq!(asked.read(catalogue("de")).err().map(|refusal| refusal.field), Some("to".into()));
    // A bare number is kilograms, which is said.
    let wanted = Asked::from([("mass", "250")]).read(catalogue("de")).ok().unwrap();
    assert!(
        wanted.remarks[0].0 == "mass" && wanted.remarks[0].1.contains("250 kg"),
        "{:?}",
        wanted.remarks
    );
}

#[test]
fn a_file_without_a_known_time_offers_its_columns() {
    let rows: String = (0..40).map(|k| format!("{};{}\n", (k * k) % 7, (k % 5) - 2)).collect();
    let text = format!("a;b\n{rows}");
    let found = recording::fits(text.as_bytes(), "a.csv", &Asked::default(), catalogue("en"));
    let refusal = found.err().unwrap();
    assert_eq!(refusal.field, "time", "{}", refusal.message);
    let labels: Vec<_> = refusal.offers.iter().map(|offer| offer.label.as_str()).collect();
    assert_eq!(labels, ["a", "b"]);
    assert!(!refusal.message.contains("--"), "{}", refusal.message);
}

#[test]
fn a_motion_that_grows_is_said_to_grow() {
    // Of the fast one little is fitted, which no mix describes; the steady one does not grow.
    for (rate, grows) in [(0.15, true), (0.02, true), (0.0, false)] {
        // Noise of the sensor, 0.1 mm: neighbours have nothing in common.
        let noise = |t: f64| 1e-4 * (12.9898e4 * t * t).sin();
        let value = |t: f64| 0.02 * (rate * t).exp() * (6.0 * t).cos() + noise(t);
        let times = (0..800).map(|k| f64::from(k) * 0.02);
        let rows: String = times.map(|t| format!("{t},{}\n", value(t))).collect();
        let text = format!("t (s),x (m)\n{rows}");
        for (language, words) in [("en", "amplitude grows"), ("de", "wächst")] {
            let fits =
                recording::fits(text.as_bytes(), "a.csv", &Asked::default(), catalogue(language));
            let said = fits.unwrap()[0].shown(catalogue(language)).sentences;
            assert_eq!(said[0].contains(words), grows, "{rate}: {said:?}");
        }
    }
}

#[test]
fn lengths_without_a_unit_are_said_to_hinder_a_simulation() {
    let bytes = fs::read(root().join("examples/recordings/tracker.txt")).unwrap();
    let fit = |asked: Asked| {
        let fits = recording::fits(&bytes, "tracker.txt", &asked, catalogue("en")).unwrap();
        fits[0].shown(catalogue("en"))
    };
    let bare = fit(Asked::default());
    assert!(bare.experiment.is_none());
    assert!(bare.no_experiment.unwrap().contains("unit"));
    let metres = fit([("unit", "m")].into());
    assert!(metres.experiment.is_some() && metres.no_experiment.is_none());
}

#[test]
fn the_report_has_what_that_of_the_program_has() {
    let shown = shown("vernier.csv", [("mass", "250 g")].into());
    let said = shown.report;
    for words in ["95 % interval", "AICc", "standard error", "Correlations", "vernier.csv", "ω₀"]
    {
        assert!(said.contains(words), "{words}");
    }
    // Formulas are set in signs, nothing of their notation is left.
    assert!(!said.contains('$') && !said.contains('\\'), "{said}");
}

#[test]
fn what_a_file_says_of_itself_is_no_part_of_the_page() {
    let bytes = fs::read(root().join("examples/recordings/vernier.csv")).unwrap();
    let text = String::from_utf8(bytes).unwrap().replace("Position", "<b>P</b>&");
    let name = "<script>$.csv";
    let fits = recording::fits(text.as_bytes(), name, &Asked::default(), catalogue("de")).unwrap();
    let report = fits[0].shown(catalogue("de")).report;
    assert!(!report.contains("<script") && !report.contains("<b>"), "{report}");
    assert!(report.contains("&lt;script&gt;$.csv") && report.contains("&lt;b&gt;P&lt;/b&gt;&amp;"));
}
