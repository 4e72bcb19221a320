//! `fit`: recordings with a known truth, made by `simulate --noise`, and files that are none.

mod common;

use common::Workplace;
use serde_json::Value;

/// A document on fits.
fn document(text: &str) -> Value {
    common::document(text, "fit.schema.json")
}

/// A recording of an experiment with these flags, fitted.
fn fitted(simulate: &[&str], fit: &[&str]) -> Value {
    let workplace = Workplace::new();
    let recorded = workplace.run(&[&["simulate", "-o", "r.csv"], simulate].concat());
    assert_eq!(recorded.status, Some(0), "{}", recorded.err);
    let finished = workplace.run(&[&["fit", "r.csv", "--format", "json"], fit].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    document(&finished.out)
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
    // The mix asked for is fitted, though one of its laws is not needed.
    let mix = fitted(&noise, &["--laws", "coulomb, newton"]);
    assert_eq!(laws(&mix), ["coulomb", "newton"]);
    assert!(mix["parameters"]["newton_rate"]["value"].is_number(), "{mix}");
    assert_eq!(mix["verdict"]["standing"]["newton"], "not-needed");
}

#[test]
fn intervals_are_found_as_asked() {
    let noise = ["--noise", "1 mm"];
    let interval = |how: &str| {
        let fit = fitted(&noise, &["--intervals", how]);
        let interval = fit["parameters"]["coulomb_acceleration"]["interval95"].clone();
        [0, 1].map(|end| interval[end].as_f64().expect("an end"))
    };
    let [profile, covariance, bootstrap] = ["profile", "covariance", "bootstrap"].map(interval);
    for other in [covariance, bootstrap] {
        assert_ne!(profile, other);
        let ratio = (other[1] - other[0]) / (profile[1] - profile[0]);
        assert!((0.7..1.4).contains(&ratio), "{profile:?} {other:?}");
    }
}

#[test]
fn outliers_do_not_sway_a_robust_loss() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "--duration", "4 s", "-o", "r.csv"]);
    let text = String::from_utf8(workplace.read("r.csv")).expect("text");
    let spoilt = |(i, line): (usize, &str)| match line.split_once(',') {
        Some((time, _)) if i > 0 && i % 40 == 0 => format!("{time},0.5\n"),
        _ => format!("{line}\n"),
    };
    let text: String = text.lines().enumerate().map(spoilt).collect();
    workplace.write("spoilt.csv", text.as_bytes());
    let off = |loss: &str| {
        let finished = workplace.run(&[
            "fit",
            "spoilt.csv",
            "--laws",
            "coulomb",
            "--loss",
            loss,
            "--format",
            "json",
        ]);
        let a_c = document(&finished.out)["parameters"]["coulomb_acceleration"]["value"].clone();
        (a_c.as_f64().expect("a value") - 0.1962).abs()
    };
    assert!(off("tukey") < 0.1 * off("squares"), "{} {}", off("tukey"), off("squares"));
}

#[test]
fn the_summary_says_the_verdict_in_both_languages() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "-o", "r.csv"]);
    let english = workplace.run(&["fit", "r.csv"]);
    assert!(english.out.contains("Dry (Coulomb) friction acts: a_c = 0.19"), "{}", english.out);
    let german = workplace.run(&["fit", "r.csv", "--lang", "de", "--details"]);
    let acts = "Trockene (Coulombsche) Reibung wirkt: a_c = 0,19";
    assert!(german.out.contains(acts), "{}", german.out);
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
    // The results are written, and the status says that they are not all.
    assert_eq!(finished.status, Some(2), "{}", finished.err);
    assert!(finished.err.contains("1 of 2"), "{}", finished.err);
    let fits = document(&finished.out);
    assert_eq!(fits["fits"].as_array().map(Vec::len), Some(1));
    assert_eq!(fits["failed"][0]["name"], "bad.csv");
}

#[test]
fn many_recordings_give_a_row_each() {
    let workplace = Workplace::new();
    for (seed, damping) in [("1", "0.1"), ("2", "0.2")] {
        let name = format!("{seed}.csv");
        let law = ["--kinetic", "0", "--damping", damping, "--seed", seed];
        workplace.run(&[&["simulate", "--noise", "0.5 mm", "-o", &name][..], &law].concat());
    }
    for (dialect, delimiter, comma) in [("standard", ',', "."), ("german", ';', ",")] {
        let arguments = ["fit", "1.csv", "2.csv", "--format", "csv", "--csv-dialect", dialect];
        let finished = workplace.run(&arguments);
        assert_eq!(finished.status, Some(0), "{}", finished.err);
        let rows: Vec<Vec<&str>> =
            finished.out.lines().map(|line| line.split(delimiter).collect()).collect();
        let column = |name| rows[0].iter().position(|cell| *cell == name).expect(name);
        assert_eq!(rows.len(), 3);
        for (row, truth) in rows[1..].iter().zip([0.1, 0.2]) {
            assert_eq!(row[column("laws")], "stokes");
            let rate = row[column("damping_rate")].replace(comma, ".").parse::<f64>();
            assert!((rate.expect("a number") - truth).abs() < 0.01, "{row:?}");
            assert_eq!(row[column("newton_rate")], "");
        }
    }
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
        (&["fit", "r.csv", "-o", "fit.txt"], ".json"),
        (&["fit", "r.csv", "--loss", "absolute"], "huber"),
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

#[test]
fn what_makes_a_verdict_unsure_is_said() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "--duration", "1 s", "-o", "few.csv"]);
    let few = workplace.run(&["fit", "few.csv"]);
    assert!(few.out.contains("swings (half periods) only"), "{}", few.out);
    workplace.run(&["simulate", "--noise", "1 mm", "--duration", "4 s", "-o", "r.csv"]);
    let text = String::from_utf8(workplace.read("r.csv")).expect("text");
    let spoilt = |(i, line): (usize, &str)| match line.split_once(',') {
        Some((time, _)) if i == 1000 => format!("{time},0.5\n"),
        _ => format!("{line}\n"),
    };
    let spoilt: String = text.lines().enumerate().map(spoilt).collect();
    workplace.write("spoilt.csv", spoilt.as_bytes());
    for (language, said) in [("en", "One value lies far off"), ("de", "Ein Wert liegt weit ab")] {
        let finished = workplace.run(&["fit", "spoilt.csv", "--lang", language]);
        assert!(finished.out.contains(said), "{}", finished.out);
        let robust = workplace.run(&["fit", "spoilt.csv", "--loss", "tukey", "--lang", language]);
        assert!(!robust.out.contains(said), "{}", robust.out);
    }
}

#[test]
fn what_a_file_does_not_say_can_be_said() {
    let workplace = Workplace::new();
    workplace.run(&["simulate", "--noise", "1 mm", "-o", "r.csv"]);
    let text = String::from_utf8(workplace.read("r.csv")).expect("text");
    // Values in centimetres, without a word of it.
    let centimetres = |line: &str| {
        let (_, value) = line.split_once(',')?;
        Some(format!("{}\n", 100.0 * value.parse::<f64>().ok()?))
    };
    let values: String = text.lines().filter_map(centimetres).collect();
    workplace.write("values.txt", values.as_bytes());
    let step =
        |line: Option<&str>| line.and_then(|line| line.split(',').next()?.parse::<f64>().ok());
    let rate = 1.0 / step(text.lines().nth(2)).expect("a time");
    let rate = format!("{rate} Hz");
    let said = [
        "fit",
        "values.txt",
        "--rate",
        &rate,
        "--unit",
        "cm",
        "--sigma",
        "1 mm",
        "--format",
        "json",
    ];
    let finished = workplace.run(&said);
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    let fit = document(&finished.out);
    assert_eq!(fit["unit"], "m");
    assert!(distance(&fit, "coulomb_acceleration", 0.1962) < 4.0, "{fit}");
    let reduced = fit["statistics"]["reduced_chi_square"].as_f64().expect("a number");
    assert!((reduced - 1.0).abs() < 0.2, "{reduced}");
    for (option, value) in
        [("--unit", "kg"), ("--rate", "0 Hz"), ("--sigma", "1 kg"), ("--sigma", "1 m/s")]
    {
        let rate = if option == "--rate" { &[][..] } else { &["--rate", "50 Hz", "--value", "1"] };
        let finished = workplace.run(&[&["fit", "values.txt", option, value][..], rate].concat());
        assert_eq!(finished.status, Some(2), "{}", finished.err);
        assert!(finished.err.contains(&option[2..]), "{}", finished.err);
    }
}
