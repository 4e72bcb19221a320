//! `plan`: what it promises, held to recordings that `simulate` makes and `fit` reads, and what it refuses.

mod common;

use common::Workplace;
use serde_json::Value;

const SMALL: [&str; 8] = [
    "--noise",
    "1 mm",
    "--kinetic",
    "0",
    "--damping",
    "0.03 kg/s",
    "--newton-coefficient",
    "0.15 kg/m",
];

fn planned(arguments: &[&str]) -> Value {
    let finished = Workplace::new().run(&[&["plan", "--format", "json"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{arguments:?}: {}", finished.err);
    common::document(&finished.out, "plan.schema.json")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn a_recording_as_planned_shows_what_was_promised() {
    let plan = planned(&[&SMALL[..], &["--position", "30 cm"]].concat());
    let (amplitude, duration) = (&plan["advice"]["amplitude"], &plan["advice"]["duration"]);
    let workplace = Workplace::new();
    let samples = (50.0 * number(duration)) as usize + 1;
    let [amplitude, duration] = [amplitude, duration].map(|value| number(value).to_string());
    let samples = samples.to_string();
    let record = ["simulate", "-o", "r.csv", "--position", &amplitude, "--duration", &duration];
    let recorded = workplace.run(&[&record, &SMALL[..], &["--samples", &samples]].concat());
    assert_eq!(recorded.status, Some(0), "{}", recorded.err);
    let laws = ["fit", "r.csv", "--format", "json", "--laws", "stokes,newton"];
    let fit: Value = serde_json::from_str(&workplace.run(&laws).out).expect("JSON");
    for law in plan["advice"]["laws"].as_array().expect("laws") {
        let law = law.as_str().expect("a law");
        assert_eq!(fit["verdict"]["standing"][law], "acts", "{fit}");
    }
    for law in plan["laws"].as_array().expect("laws") {
        let found = &fit["parameters"][law["parameter"].as_str().expect("a name")];
        let promised = number(&law["value"]) / 5.0;
        let stderr = number(&found["stderr"]);
        assert!(stderr < 1.1 * promised, "{law}: {found}");
        assert!((number(&found["value"]) - number(&law["value"])).abs() < 4.0 * stderr, "{found}");
    }
}

#[test]
fn plans_fit_their_schema_whatever_is_expected() {
    let all = planned(&["--noise", "1 mm", "--damping", "0.05", "--newton-coefficient", "0.2"]);
    assert_eq!(all["pairs"].as_array().map(Vec::len), Some(3));
    assert_eq!(all["limits"].as_array().map(Vec::len), Some(0));
    let none = planned(&["--noise", "1 mm/s", "--kinetic", "0", "--duration", "30 s"]);
    assert_eq!(none["advice"], Value::Null);
    assert_eq!(none["limits"].as_array().map(Vec::len), Some(3));
    assert_eq!(none["setup"]["quantity"], "velocity");
    let dry = planned(&["--noise", "0.02", "--quantity", "acceleration", "--laws", "auto"]);
    assert_eq!(dry["setup"]["fitted"].as_array().map(Vec::len), Some(3));
    assert_eq!(dry["setup"]["quantity"], "acceleration");
    // Static friction holds the mass at the smallest amplitudes: they tell nothing.
    let held = planned(&["--noise", "1 mm", "--static", "0.05", "--min-amplitude", "1 cm"]);
    assert_eq!(held["amplitudes"][0]["coulomb"], Value::Null);
}

#[test]
fn half_the_noise_or_four_times_the_rate_halve_the_standard_error() {
    let stderr = |arguments: &[&str]| {
        let fixed = ["--kinetic", "0", "--damping", "0.1", "--duration", "8 s"];
        let plan = planned(&[&fixed, arguments].concat());
        number(&plan["laws"][0]["largest"]["stderr"])
    };
    let usual = stderr(&["--noise", "1 mm"]);
    assert!((usual / stderr(&["--noise", "0.5 mm"]) - 2.0).abs() < 0.01);
    assert!((usual / stderr(&["--noise", "1 mm", "--rate", "200 Hz"]) - 2.0).abs() < 0.02);
}

#[test]
fn what_is_not_resolved_says_what_would_help() {
    let hopeless = [&SMALL[..], &["--position", "2 cm", "--duration", "5 s"]].concat();
    let plan = planned(&hopeless);
    let newton = &plan["laws"][1];
    assert_eq!(newton["smallest"], Value::Null);
    assert!(number(&newton["noise_factor"]) > 1.0);
    let beyond = number(&newton["beyond"]).to_string();
    let better = [&SMALL[..], &["--position", &beyond, "--duration", "5 s"]].concat();
    assert!(planned(&better)["laws"][1]["smallest"].is_object());
    let factor = number(&newton["noise_factor"]);
    let mut quieter = hopeless.clone();
    let noise = format!("{} mm", 1.0 / factor);
    quieter[1] = &noise;
    assert!(planned(&quieter)["laws"][1]["smallest"].is_object());
}

#[test]
fn summary_table_and_pictures_are_written_in_both_languages() {
    let workplace = Workplace::new();
    let arguments = [&["plan"], &SMALL[..], &["--position", "30 cm"]].concat();
    let english = workplace.run(&[&arguments[..], &["--details"]].concat());
    assert_eq!(english.status, Some(0), "{}", english.err);
    assert!(english.out.contains("Release from at least"), "{}", english.out);
    assert!(english.out.contains("--laws stokes,newton"), "{}", english.out);
    let german = workplace.run(&[&arguments[..], &["--lang", "de", "--details"]].concat());
    assert!(german.out.contains("Dann trennen sich"), "{}", german.out);
    let files = ["-o", "p.csv", "-o", "p.svg", "-o", "p.png", "-o", "p.json"];
    let written = workplace.run(&[&arguments[..], &files].concat());
    assert_eq!(written.status, Some(0), "{}", written.err);
    let table = String::from_utf8(workplace.read("p.csv")).expect("text");
    let mut lines = table.lines();
    let header = lines.next().expect("a header");
    assert!(header.starts_with("Amplitude (m),damping_rate duration (s)"), "{header}");
    assert!(lines.clone().count() > 20);
    assert!(lines.all(|line| line.split(',').count() == 7));
}

#[test]
fn what_makes_no_plan_is_refused() {
    let workplace = Workplace::new();
    for (arguments, said) in [
        (&[][..], "--noise"),
        (&["--noise", "0 mm"], "--noise"),
        (&["--noise", "-1 mm"], "--noise"),
        (&["--noise", "--rate", "1"], "--noise"),
        (&["--noise", "1 kg"], "--noise"),
        (&["--noise", "1 mm", "--quantity", "velocity"], "--noise"),
        (&["--noise", "2 cm"], "2 cm"),
        (&["--noise", "1 mm", "--rate", "5 Hz"], "8.05 Hz"),
        (&["--noise", "1 mm", "--rate", "0"], "--rate"),
        (&["--noise", "1 mm", "--min-amplitude", "20 cm"], "--min-amplitude"),
        (&["--noise", "1 mm", "--max-amplitude", "-1 cm"], "--max-amplitude"),
        (&["--noise", "1 mm", "--duration", "1 s"], "2.48 s"),
        (&["--noise", "1 mm", "--samples", "100"], "--samples"),
        (&["--noise", "1 mm", "--position", "0"], "--max-amplitude"),
        (&["--noise", "1 mm", "--static", "0.5"], "12.3 cm"),
        (&["--noise", "1 mm", "--damping", "10"], "damping ratio"),
        (&["--noise", "1 mm", "--laws", "sliding"], "sliding"),
        (&["--noise", "1 mm", "-o", "plan.html"], ".json"),
        (&["a.toml", "b.toml", "--noise", "1 mm"], "b.toml"),
    ] {
        let finished = workplace.run(&[&["plan"], arguments].concat());
        assert_eq!(finished.status, Some(2), "{arguments:?}: {}{}", finished.out, finished.err);
        assert!(finished.err.contains(said), "{arguments:?}: {}", finished.err);
        assert!(finished.out.is_empty() && workplace.files().is_empty(), "{arguments:?}");
    }
}

#[test]
fn too_few_swings_are_not_taken_for_noise() {
    let workplace = Workplace::new();
    // Dry friction shifts the middle by f = a_c/ω0² = 4.9 mm: below nine times that the mass rests within five swings.
    let english = workplace.run(&["plan", "--noise", "0.1 mm"]);
    assert!(
        english.out.contains("fewer than five swings (half periods) remain"),
        "{}",
        english.out
    );
    assert!(!english.out.contains("does not show"), "{}", english.out);
    let german = workplace.run(&["plan", "--noise", "0.1 mm", "--lang", "de"]);
    assert!(german.out.contains("weniger als fünf Halbschwingungen"), "{}", german.out);
}
