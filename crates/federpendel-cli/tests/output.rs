//! What `simulate` writes, as scripts and people read it.

mod common;

use std::path::{Path, PathBuf};

use common::Workplace;
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn schema(name: &str) -> jsonschema::Validator {
    let text = std::fs::read_to_string(root().join("schemas").join(name)).expect("a schema");
    let schema = serde_json::from_str(&text).expect("JSON");
    jsonschema::validator_for(&schema).expect("a schema")
}

/// The experiments that the repository keeps, and the built-in one.
fn experiments() -> Vec<(String, String)> {
    let folder = std::fs::read_dir(root().join("examples")).expect("examples");
    let files = folder.map(|entry| entry.expect("an entry").path());
    let mut experiments: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .map(|path| {
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            (name, std::fs::read_to_string(path).expect("an example"))
        })
        .collect();
    experiments.push(("built-in".into(), federpendel_cli::experiment::BUILT_IN.into()));
    experiments
}

fn json(arguments: &[&str]) -> Value {
    let workplace = Workplace::new();
    let finished = workplace.run(&[&["simulate", "--format", "json"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{arguments:?}: {}", finished.err);
    serde_json::from_str(&finished.out).expect("JSON")
}

fn assert_valid(schema: &jsonschema::Validator, value: &Value, name: &str) {
    let problems: Vec<_> = schema.iter_errors(value).map(|error| error.to_string()).collect();
    assert!(problems.is_empty(), "{name}: {problems:?}");
}

#[test]
fn experiments_and_results_fit_their_schemas() {
    let (experiment, simulation) =
        (schema("experiment.schema.json"), schema("simulation.schema.json"));
    for (name, text) in experiments() {
        let file: toml::Value = toml::from_str(&text).expect("TOML");
        assert_valid(&experiment, &serde_json::to_value(file).expect("JSON"), &name);
        let workplace = Workplace::new();
        workplace.write("my.toml", text.as_bytes());
        let finished = workplace.run(&["simulate", "my.toml", "--format", "json"]);
        assert_eq!(finished.status, Some(0), "{name}: {}", finished.err);
        assert_valid(&simulation, &serde_json::from_str(&finished.out).expect("JSON"), &name);
    }
    for method in ["article-printed", "article-corrected", "article-scheme"] {
        assert_valid(&simulation, &json(&["--method", method]), method);
    }
}

#[test]
fn experiments_that_the_schema_refuses_are_refused() {
    let schema = schema("experiment.schema.json");
    let good = "[oscillator]\nmass = 1\nstiffness = 1\n[release]\nposition = 1\n";
    for bad in [
        good.replace("mass", "mas"),
        good.replace("mass = 1", ""),
        format!("{good}[friction]\nnewton = {{ density = 1, area = 1 }}"),
        format!("{good}[friction]\nnewton = {{ coefficient = 1, area = 1 }}"),
        format!("{good}[friction]\ncoulomb = {{ static = 1 }}"),
        format!("{good}[friction]\nstokes = {{}}"),
        good.replace("mass", "gravity = 1\nnormal_force = 1\nmass"),
    ] {
        let file: toml::Value = toml::from_str(&bad).expect("TOML");
        assert!(!schema.is_valid(&serde_json::to_value(file).expect("JSON")), "{bad}");
        let draft = federpendel_cli::experiment::parse(bad.as_bytes());
        assert!(draft.and_then(|draft| draft.resolve(usize::MAX)).is_err(), "{bad}");
    }
}

#[test]
fn the_built_in_experiment_is_the_one_that_was_measured() {
    let result = json(&["--samples", "3", "--duration", "20 s"]);
    assert_eq!(result["turning_points"].as_array().map(Vec::len), Some(10));
    let number = |path: &str| result.pointer(path).and_then(Value::as_f64).expect("a number");
    assert!((number("/rest/position") - 0.0019).abs() < 1e-15);
    assert!((number("/rest/time") - 4.96729).abs() < 5e-6);
    assert!((number("/derived/offset") - 0.004905).abs() < 1e-17);
    assert_eq!(result["samples"]["time"], serde_json::json!([0.0, 10.0, 20.0]));
    assert_eq!(result["samples"]["mode"], serde_json::json!([-1, 0, 0]));
    let spent = number("/energy/heat/coulomb") + number("/energy/potential");
    assert!((spent - number("/energy/initial")).abs() < 1e-14);
}

#[test]
fn what_is_undefined_is_null() {
    let overdamped = json(&["--damping", "40", "--kinetic", "0"]);
    for field in ["/derived/period", "/derived/frequency", "/derived/logarithmic_decrement"] {
        assert_eq!(overdamped.pointer(field), Some(&Value::Null), "{field}");
    }
    assert_eq!(overdamped["limit"], serde_json::json!(0.0));
    assert_eq!(overdamped["rest"], Value::Null);
    let undamped = json(&["--kinetic", "0"]);
    assert_eq!(undamped["derived"]["quality_factor"], Value::Null);
    assert_eq!(undamped["limit"], Value::Null);
}

#[test]
fn csv_in_both_dialects() {
    let table = |dialect| {
        let arguments = ["simulate", "--format", "csv", "--csv-dialect", dialect, "--samples", "3"];
        Workplace::new().run(&[&arguments[..], &["--duration", "1"]].concat()).out
    };
    let standard = table("standard");
    let mut lines = standard.lines();
    let header = "Time (s),Position (m),Velocity (m/s),Acceleration (m/s^2),Mode";
    assert_eq!(lines.next(), Some(header));
    assert!(
        lines.next().is_some_and(|line| line.starts_with("0,0.1,0,-3.80") && line.ends_with(",-1"))
    );
    assert!(lines.next().is_some_and(|line| line.starts_with("0.5,-0.09")));
    assert_eq!(standard.lines().count(), 4);
    assert_eq!(table("german").replace(';', ",,").replace(',', "."), standard.replace(',', ".."));
}

#[test]
fn files_appear_whole_beside_the_summary() {
    let workplace = Workplace::new();
    let names = ["a.csv", "a.json", "a.png", "a.svg"];
    let finished = workplace
        .run(&["simulate", "-o", names[0], "-o", names[1], "-o", names[2], "-o", names[3]]);
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    assert!(
        finished.out.contains("comes to rest after 10 swings, 4.967 s, 1.9 mm from the centre")
    );
    assert_eq!(workplace.files(), names);
    assert!(workplace.read("a.png").starts_with(b"\x89PNG"));
    assert!(workplace.read("a.svg").starts_with(b"<svg"));
    assert!(workplace.read("a.csv").starts_with(b"Time (s),"));
    assert_valid(
        &schema("simulation.schema.json"),
        &serde_json::from_slice(&workplace.read("a.json")).expect("JSON"),
        "a.json",
    );
}

#[test]
fn standard_output_can_be_named_as_a_file() {
    let workplace = Workplace::new();
    let table = workplace.run(&["simulate", "-o", "-"]).out;
    assert!(table.starts_with("Time (s),"));
    let finished = workplace.run(&["simulate", "-o", "-", "--format", "json"]);
    assert!(finished.out.starts_with('{') && finished.err.is_empty());
    assert!(workplace.files().is_empty());
}

#[test]
fn the_summary_speaks_both_languages_and_has_no_colours_in_a_file() {
    let workplace = Workplace::new();
    let german = workplace.run(&["simulate", "--lang", "de", "--details"]).out;
    assert!(german.contains("kommt nach 10 Halbschwingungen zur Ruhe, bei 4,967 s"));
    let english = workplace.run(&["simulate", "--details"]).out;
    for text in [&german, &english] {
        assert!(!text.contains('\u{1b}'));
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    }
    // “Exact” is only what has a closed form or a first integral.
    let series =
        workplace.run(&["simulate", "--damping", "0.1", "--newton-coefficient", "0.1"]).out;
    assert!(!series.to_lowercase().contains("exact") && series.contains("to rounding"), "{series}");
}

#[test]
fn help_has_examples_on_every_level() {
    let workplace = Workplace::new();
    for level in [&[][..], &["simulate"], &["completions"], &["man"]] {
        for (language, word) in [("en", "Examples:"), ("de", "Beispiele:")] {
            let finished = workplace.run(&[level, &["--help", "--lang", language]].concat());
            assert_eq!(finished.status, Some(0), "{}", finished.err);
            assert!(finished.out.contains(word), "{}", finished.out);
            assert!(language != "de" || !finished.out.contains("Usage"), "{}", finished.out);
        }
    }
}

#[test]
fn a_reader_that_has_seen_enough_is_no_failure() {
    let program = assert_cmd::cargo::cargo_bin("federpendel");
    for format in ["csv", "json"] {
        let mut run = std::process::Command::new(&program)
            .args(["simulate", "--samples", "200001", "--format", format])
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .expect("a run");
        drop(run.stdout.take());
        let output = run.wait_with_output().expect("an end");
        assert_eq!(output.status.code(), Some(0), "{format}");
        assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}
