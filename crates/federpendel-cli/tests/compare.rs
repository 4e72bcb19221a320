//! `compare`: methods beside the exact motion.

mod common;

use std::path::Path;

use common::{Finished, Workplace};
use serde_json::Value;

fn schema(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schemas").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).expect("a schema")).expect("JSON")
}

fn compare(arguments: &[&str]) -> Finished {
    Workplace::new().run(&[&["compare"], arguments].concat())
}

fn json(arguments: &[&str]) -> Value {
    let finished = compare(&[&["--format", "json"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{arguments:?}: {}", finished.err);
    serde_json::from_str(&finished.out).expect("JSON")
}

fn refused(arguments: &[&str], parts: &[&str]) {
    let workplace = Workplace::new();
    let finished = workplace.run(&[&["compare"], arguments, &["-o", "c.csv"]].concat());
    assert_eq!((finished.status, finished.out.as_str()), (Some(2), ""), "{arguments:?}");
    assert_eq!(finished.err.lines().count(), 1, "{}", finished.err);
    assert!(workplace.files().is_empty(), "{arguments:?}");
    for part in parts {
        assert!(finished.err.contains(part), "{:?} lacks {part:?}", finished.err);
    }
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number at {path}"))
}

#[test]
fn results_fit_their_schema_which_shares_the_motion_with_the_other() {
    let comparison = schema("comparison.schema.json");
    let validator = jsonschema::validator_for(&comparison).expect("a schema");
    let drag = ["--kinetic", "0", "--newton-coefficient", "0.235", "--damping", "0.05"];
    for arguments in [&[][..], &["--kinetic", "0"], &drag, &["--samples", "5", "--dt", "5 ms"]] {
        let result = json(arguments);
        let problems: Vec<_> =
            validator.iter_errors(&result).map(|error| error.to_string()).collect();
        assert!(problems.is_empty(), "{arguments:?}: {problems:?}");
    }
    let simulation = schema("simulation.schema.json");
    let shared = comparison["properties"].as_object().expect("properties");
    for (name, property) in
        shared.iter().filter(|(name, _)| *name != "methods" && *name != "schema")
    {
        assert_eq!(*property, simulation["properties"][name], "{name}");
    }
}

/// The measured errors of the article's formulas and scheme (experiment: 0.5 kg, 20 N/m, 10 cm, μ = 0.02).
#[test]
fn the_known_errors_of_the_article_are_found() {
    let result = json(&["--duration", "20 s", "--dt", "1 ms"]);
    let method = |name: &str, field: &str| number(&result, &format!("/methods/{name}/{field}"));
    assert!((method("article-corrected", "final_position") + 0.19964).abs() < 5e-6);
    assert!((method("article-printed", "final_position") + 5.279).abs() < 5e-4);
    // The scheme creeps: 1.897 mm at 5 s, 1.036 mm at 20 s.
    assert!((method("article-scheme", "final_position") - 1.036e-3).abs() < 1e-6);
    assert_eq!(result["methods"]["article-scheme"]["sticks"], false);
    assert_eq!(result["methods"]["moreau-jean"]["sticks"], true);
    let until_rest = json(&["--duration", "4.967 s", "--against", "article-corrected"]);
    let error = number(&until_rest, "/methods/article-corrected/max_error");
    assert!((error - 4.905e-3).abs() < 1e-5, "{error}");
}

#[test]
fn located_reversals_keep_their_order_and_stick() {
    let result = json(&[]);
    for (name, order, error) in [("verlet-located", 2.0, 1e-5), ("rk4-located", 4.0, 1e-9)] {
        let method = &result["methods"][name];
        assert!((method["observed_order"].as_f64().expect("an order") - order).abs() < 0.2);
        assert!(method["max_error"].as_f64().expect("an error") < error, "{name}");
        assert_eq!(method["sticks"], true);
        assert_eq!(method["creep"], 0.0);
    }
    let plain = result["methods"]["rk4"]["observed_order"].as_f64().expect("an order");
    assert!((0.6..1.5).contains(&plain), "{plain}");
    assert_eq!(result["methods"]["article-printed"]["observed_order"], Value::Null);
}

#[test]
fn the_order_asked_for_is_the_order_given() {
    let result = compare(&["--against", "rk4,verlet, rk4", "--format", "json"]).out;
    let (rk4, verlet) = (result.find("\"rk4\""), result.find("\"verlet\""));
    assert!(rk4.expect("rk4") < verlet.expect("verlet"));
    let table = compare(&["--against", "rk4,verlet", "--format", "csv", "--samples", "3"]).out;
    let header = "Time (s),exact Position (m),rk4 Position (m),verlet Position (m)";
    assert_eq!(table.lines().next(), Some(header));
    assert_eq!(table.lines().count(), 4);
}

/// A method that fails says when and why, and is no curve.
#[test]
fn a_method_that_fails_is_reported_not_drawn() {
    let arguments = ["--against", "dopri5,rk4", "--tolerance", "1e-10"];
    let result = json(&arguments);
    let failed = &result["methods"]["dopri5"];
    assert!(failed["failed"].as_str().expect("a reason").contains("4.97"), "{failed}");
    for field in ["max_error", "samples", "run_time", "final_position"] {
        assert_eq!(failed[field], Value::Null, "{field}");
    }
    assert!(result["methods"]["rk4"]["samples"].is_object());
    let summary = compare(&arguments).out;
    assert!(summary.contains("dopri5 failed: at 4.97"), "{summary}");
    let table = compare(&[&arguments[..], &["--format", "csv"]].concat()).out;
    assert!(!table.contains("dopri5"), "{}", &table[..80]);
}

#[test]
fn formulas_are_left_out_or_refused_where_the_article_has_none() {
    let mix = ["--damping", "0.1"];
    assert_eq!(json(&mix)["methods"].get("article-printed"), None);
    refused(
        &[&mix[..], &["--against", "rk4,article-printed"]].concat(),
        &["article-printed", "Stokes and Coulomb"],
    );
}

#[test]
fn bad_input_is_refused_by_name() {
    refused(&["--against", "rk5"], &["rk5", "rk4-located", "moreau-jean"]);
    refused(&["--against", ""], &["--against", "article-scheme"]);
    refused(&["--dt", "0"], &["--dt", "greater than 0"]);
    refused(&["--dt", "1 m"], &["--dt", "a time"]);
    refused(&["--tolerance", "-1"], &["--tolerance", "greater than 0"]);
    refused(&["--width", "1 s"], &["--width", "a velocity"]);
    refused(&["--tolerance", "--width", "1"], &["--tolerance"]);
    refused(&["--plot", "erorr"], &["--plot", "error"]);
    refused(&["--method", "rk4"], &["--method"]);
    refused(&["--mass", "0"], &["--mass"]);
}

#[test]
fn more_steps_than_are_taken_fail_before_the_first() {
    let result = json(&["--against", "verlet", "--dt", "1e-12 s", "--samples", "3"]);
    let reason = result["methods"]["verlet"]["failed"].as_str().expect("a reason").to_owned();
    assert!(reason.contains("steps"), "{reason}");
}

#[test]
fn every_picture_is_drawn_in_both_languages() {
    for (command, pictures) in [
        ("compare", ["error", "convergence", "work", "motion"]),
        ("simulate", ["motion", "phase", "energy", "decrement"]),
    ] {
        for picture in pictures {
            for language in ["en", "de"] {
                let workplace = Workplace::new();
                let arguments = [command, "--plot", picture, "--lang", language];
                let finished =
                    workplace.run(&[&arguments[..], &["-o", "p.svg", "-o", "p.png"]].concat());
                assert_eq!(finished.status, Some(0), "{}", finished.err);
                assert_eq!(workplace.files(), ["p.png", "p.svg"]);
                let svg = String::from_utf8(workplace.read("p.svg")).expect("text");
                assert!(svg.contains("<title ") && svg.contains("<desc "), "{picture}");
                assert!(!svg.contains("NaN"), "{picture}");
            }
        }
    }
}

#[test]
fn the_summary_speaks_both_languages_and_fits() {
    let english = compare(&["--details"]).out;
    assert!(english.contains("Nearest to it stays rk4-located"), "{english}");
    let german = compare(&["--lang", "de"]).out;
    assert!(german.contains("Am nächsten bleibt rk4-located"), "{german}");
    assert!(german.lines().all(|line| line.chars().count() <= 80), "{german}");
}
