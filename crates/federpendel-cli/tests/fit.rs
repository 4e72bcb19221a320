//! `fit`: recordings with a known truth, made by `simulate --noise`, and files that are none.

mod common;

use std::path::Path;

use common::Workplace;
use serde_json::Value;

/// A recording of an experiment with these flags, fitted: the first fit.
fn fitted(simulate: &[&str], fit: &[&str]) -> Value {
    let workplace = Workplace::new();
    let recorded = workplace.run(&[&["simulate", "-o", "r.csv"], simulate].concat());
    assert_eq!(recorded.status, Some(0), "{}", recorded.err);
    let finished = workplace.run(&[&["fit", "r.csv", "--format", "json"], fit].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    let document: Value = serde_json::from_str(&finished.out).expect("JSON");
    let schema = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schemas/fit.schema.json");
    let schema = serde_json::from_str(&std::fs::read_to_string(schema).expect("a schema"));
    let schema = jsonschema::validator_for(&schema.expect("JSON")).expect("a schema");
    let problems: Vec<_> = schema.iter_errors(&document).map(|error| error.to_string()).collect();
    assert!(problems.is_empty(), "{problems:?}");
    document["fits"][0].clone()
}

fn laws(fit: &Value) -> Vec<&str> {
    let laws = fit["verdict"]["laws"].as_array().expect("laws");
    laws.iter().map(|law| law.as_str().expect("a law")).collect()
}

/// Distance of a parameter from the truth, in standard errors.
fn distance(fit: &Value, name: &str, truth: f64) -> f64 {
    let parameter = &fit["parameters"][name];
    let number = |field: &str| parameter[field].as_f64().expect(field);
    (number("value") - truth).abs() / number("stderr")
}

#[test]
fn the_built_in_experiment_is_found_again() {
    let fit = fitted(&["--noise", "1 mm", "--seed", "1", "--duration", "6 s"], &[]);
    assert_eq!(laws(&fit), ["coulomb"]);
    assert_eq!(fit["verdict"]["adequate"], true);
    assert!(distance(&fit, "angular_frequency", 40f64.sqrt()) < 4.0, "{fit}");
    assert!(distance(&fit, "coulomb_acceleration", 0.1962) < 4.0, "{fit}");
    let rest = fit["rest"]["time"].as_f64().expect("a rest");
    assert!((rest - 4.96729).abs() < 0.02, "{rest}");
}

#[test]
fn every_quantity_tells_of_stokes_friction() {
    for noise in ["0.5 mm", "3 mm/s", "2 cm/s^2"] {
        let arguments =
            ["--kinetic", "0", "--damping", "0.1 kg/s", "--noise", noise, "--seed", "2"];
        let fit = fitted(&arguments, &[]);
        assert_eq!(laws(&fit), ["stokes"], "{noise}");
        assert!(distance(&fit, "damping_rate", 0.1) < 4.0, "{noise}: {fit}");
    }
}

#[test]
fn laws_can_be_chosen() {
    let noise = ["--noise", "1 mm"];
    let chosen = fitted(&noise, &["--laws", "stokes"]);
    assert_eq!(laws(&chosen), ["stokes"]);
    assert_eq!(chosen["models"].as_array().map(Vec::len), Some(2));
    assert!(laws(&fitted(&noise, &["--laws", "none"])).is_empty());
}

#[test]
fn the_summary_says_the_verdict_in_both_languages() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "-o", "r.csv"]);
    let english = workplace.run(&["fit", "r.csv"]);
    assert!(english.out.contains("Coulomb friction a_c = 0.19"), "{}", english.out);
    let german = workplace.run(&["fit", "r.csv", "--lang", "de", "--details"]);
    assert!(german.out.contains("Coulombsche Reibung a_c = 0,19"), "{}", german.out);
    let pictures = workplace.run(&["fit", "r.csv", "-o", "fit.svg", "-o", "fit.json"]);
    assert_eq!(pictures.status, Some(0), "{}", pictures.err);
    assert!(String::from_utf8_lossy(&workplace.read("fit.svg")).contains("</svg>"));
}

#[test]
fn one_call_writes_report_json_and_picture() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "-o", "r.csv"]);
    let outputs = ["-o", "r.html", "-o", "r.json", "-o", "r.svg", "--plot", "decrement"];
    let finished = workplace.run(&[&["fit", "r.csv", "--lang", "de"], &outputs[..]].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    let text = |name: &str| String::from_utf8_lossy(&workplace.read(name)).into_owned();
    let page = text("r.html");
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("<html lang=\"de\">"));
    assert!(page.contains("Welche Reibung wirkt in r.csv?") && page.contains("0,19"));
    serde_json::from_str::<Value>(&text("r.json")).expect("JSON");
    for picture in [text("r.svg"), finished.out] {
        assert!(picture.contains("Achsenabschnitt 2f"), "{picture}");
    }
}

#[test]
fn many_recordings_stand_on_one_page() {
    let workplace = Workplace::new();
    for (seed, name) in [("1", "a.csv"), ("2", "b.csv")] {
        workplace.run(&["simulate", "--noise", "1 mm", "--seed", seed, "-o", name]);
    }
    let finished = workplace.run(&["fit", "a.csv", "b.csv", "-o", "r.html"]);
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    let page = String::from_utf8_lossy(&workplace.read("r.html")).into_owned();
    // The number stays on the line of what it counts.
    assert!(page.contains("Which friction acts in 2\u{a0}recordings?"));
    assert!(page.contains("<a href=\"#recording-2\">b.csv</a>"), "{page}");
}

#[test]
fn a_bad_file_does_not_stop_the_others() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "-o", "r.csv"]);
    workplace.write("bad.csv", b"no numbers here\n");
    let finished = workplace.run(&["fit", "bad.csv", "r.csv", "--format", "json"]);
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    assert!(finished.err.contains("bad.csv"), "{}", finished.err);
    let document: Value = serde_json::from_str(&finished.out).expect("JSON");
    assert_eq!(document["fits"].as_array().map(Vec::len), Some(1));
}

#[test]
fn no_recording_is_overwritten_and_no_refusal_said_twice() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "-o", "a.csv"]);
    workplace.write("b.json", b"a recording of another name");
    let finished = workplace.run(&["fit", "a.csv", "b.json", "-o", "b.json"]);
    assert_eq!(finished.status, Some(2), "{}", finished.err);
    assert_eq!(workplace.read("b.json"), b"a recording of another name");
    workplace.write("empty.csv", b"");
    let finished = workplace.run(&["fit", "b.json", "empty.csv"]);
    assert_eq!(finished.status, Some(2), "{}", finished.err);
    for name in ["b.json", "empty.csv"] {
        assert_eq!(finished.err.matches(name).count(), 1, "{}", finished.err);
    }
}

#[test]
fn what_is_no_recording_is_refused() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "-o", "r.csv"]);
    workplace.write("empty.csv", b"");
    workplace.write("one.csv", b"Time (s),Position (m)\n0,1\n");
    workplace.write("still.csv", &still());
    workplace.write("picture.png", b"\x89PNG\r\n\x1a\n0000");
    let files = workplace.files();
    for (arguments, said) in [
        (&["fit"][..], ""),
        (&["fit", "empty.csv"], "empty.csv"),
        (&["fit", "one.csv"], "one.csv"),
        (&["fit", "still.csv"], "still.csv"),
        (&["fit", "picture.png"], "picture.png"),
        (&["fit", "r.csv", "--laws", "sliding"], "sliding"),
        (&["fit", "r.csv", "--value", "Temperature"], "Temperature"),
        (&["fit", "r.csv", "--from", "1 kg"], "--from"),
        (&["fit", "r.csv", "-o", "fit.csv"], ".json"),
    ] {
        let finished = workplace.run(arguments);
        assert_eq!(finished.status, Some(2), "{arguments:?}: {}", finished.err);
        assert!(finished.err.contains(said), "{arguments:?}: {}", finished.err);
        assert_eq!(workplace.files(), files, "{arguments:?}");
    }
}

/// A mass that never moves.
fn still() -> Vec<u8> {
    let rows = (0..200).map(|i| format!("{},0.5\n", 0.01 * f64::from(i)));
    format!("Time (s),Position (m)\n{}", rows.collect::<String>()).into_bytes()
}
