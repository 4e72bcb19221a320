//! `score`: samples of other programs against the reference problems.

mod common;

use std::path::Path;

use common::{Finished, Workplace};
use serde_json::Value;

/// What another program may write of `laboratory-c` (0.5 kg on 20 N/m, released at 10 cm, μ = 0.02).
fn own_samples(arguments: &[&str]) -> Vec<u8> {
    let workplace = Workplace::new();
    let finished = workplace.run(&[&["simulate", "--format", "csv"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    finished.out.into_bytes()
}

fn score(file: &[u8], arguments: &[&str]) -> Finished {
    let workplace = Workplace::new();
    workplace.write("s.csv", file);
    workplace.run(&[&["score", "s.csv"], arguments].concat())
}

fn json(file: &[u8], problem: &str) -> Value {
    let finished = score(file, &["--problem", problem, "--format", "json"]);
    assert_eq!(finished.status, Some(0), "{problem}: {}", finished.err);
    serde_json::from_str(&finished.out).expect("JSON")
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number at {path}"))
}

/// The stored answers of a problem of `reference/<file>.json`.
fn stored(file: &str, problem: &str) -> Vec<[String; 3]> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reference").join(file);
    let text = std::fs::read_to_string(path).expect("a reference file");
    let collection: Value = serde_json::from_str(&text).expect("JSON");
    let problems = collection["problems"].as_array().expect("problems");
    let found = problems.iter().find(|found| found["name"] == problem).expect("the problem");
    let field = |sample: &Value, name: &str| sample[name].as_str().expect("digits").to_owned();
    let samples = found["samples"].as_array().expect("samples").iter();
    samples.map(|s| ["time", "position", "velocity"].map(|name| field(s, name))).collect()
}

fn table(header: &str, rows: impl Iterator<Item = String>) -> Vec<u8> {
    let rows: Vec<String> = std::iter::once(header.to_owned()).chain(rows).collect();
    (rows.join("\n") + "\n").into_bytes()
}

/// Times up to ten times the rest, and the exact positions there plus what `error` adds.
fn laboratory(error: impl Fn(f64) -> f64) -> Vec<u8> {
    let csv = own_samples(&["--duration", "40 s", "--samples", "4001"]);
    let csv = String::from_utf8(csv).expect("text");
    table(
        "t,x",
        csv.lines().skip(1).map(|line| {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("f64")).collect();
            format!("{},{}", cells[0], cells[1] + error(cells[0]))
        }),
    )
}

#[test]
fn results_fit_their_schema() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schemas/score.schema.json");
    let schema = std::fs::read_to_string(path).expect("a schema");
    let schema = serde_json::from_str(&schema).expect("JSON");
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    let short = b"time,position\n0.1,0.2\n".to_vec();
    for problem in ["laboratory-c", "laboratory-free", "at-rest-c", "million-n-1e-07", "tie-9"] {
        for file in [&own_samples(&[]), &short] {
            let result = json(file, problem);
            let problems: Vec<_> =
                validator.iter_errors(&result).map(|error| error.to_string()).collect();
            assert!(problems.is_empty(), "{problem}: {problems:?}");
        }
    }
}

#[test]
fn our_own_samples_score_at_rounding_in_both_dialects() {
    for dialect in ["standard", "german"] {
        let file = own_samples(&["--csv-dialect", dialect, "--duration", "20 s"]);
        let result = json(&file, "laboratory-c");
        assert!(number(&result, "/position/max_error") < 1e-12);
        assert!(number(&result, "/velocity/max_error") < 1e-12);
        assert_eq!(result["rest"]["sticks"], true);
        assert_eq!(result["rest"]["creep"], 0.0);
    }
    let summary = score(&own_samples(&[]), &["--problem", "laboratory-c"]).out;
    assert!(summary.contains("agree with the exact motion to rounding"), "{summary}");
    assert!(summary.contains("After the rest at 4.9673 s they stand still"), "{summary}");
}

/// The stored digits themselves, which another program computed, at the times that `--times` prints.
#[test]
fn stored_digits_score_at_rounding() {
    for (file, problem) in [
        ("coulomb.json", "laboratory-c"),
        ("coulomb.json", "tie-4"),
        ("stokes.json", "million-s-1e-7"),
        ("newton.json", "throw-n-outward"),
        ("stokes-coulomb-newton.json", "static-scn-3"),
        ("coulomb.json", "stopped-c-1e4"),
    ] {
        let samples = stored(file, problem);
        let rows = samples.iter().rev().map(|sample| sample.join(","));
        let result = json(&table("time,position,velocity", rows), problem);
        assert_eq!(number(&result, "/stored/samples"), samples.len() as f64, "{problem}");
        assert_eq!(number(&result, "/stored/max_position_error"), 0.0, "{problem}");
        assert_eq!(number(&result, "/stored/max_velocity_error"), 0.0, "{problem}");
        assert!(number(&result, "/position/max_error") < 1e-13, "{problem}");
        assert_ne!(result["rest"]["sticks"], false, "{problem}");
        let times = Workplace::new().run(&["score", "--problem", problem, "--times"]).out;
        let expected: Vec<_> = samples.iter().map(|[time, ..]| time.as_str()).collect();
        assert_eq!(times.lines().collect::<Vec<_>>(), expected);
    }
    let result = json(&own_samples(&["--samples", "7"]), "laboratory-c");
    assert_eq!(number(&result, "/stored/samples"), 1.0, "the release is stored, nothing else here");
}

#[test]
fn a_shifted_sample_scores_what_was_shifted() {
    let shift = |time: f64| if time == 3.0 { 2e-5 } else { 0.0 };
    let result = json(&laboratory(shift), "laboratory-c");
    assert!((number(&result, "/position/max_error") - 2e-4).abs() < 1e-12);
    assert_eq!(number(&result, "/position/time_of_max_error"), 3.0);
    let mean = 2e-4 / f64::sqrt(4001.0);
    assert!((number(&result, "/position/rms_error") - mean).abs() < 1e-12);
    assert!(number(&result, "/last/error").abs() < 1e-12);
    assert_eq!(result["rest"]["sticks"], true);
    assert_eq!(result["velocity"], Value::Null);
    let result = json(&laboratory(|_| -1e-6), "laboratory-c");
    assert!((number(&result, "/last/error") + 1e-5).abs() < 1e-12);
    assert!((number(&result, "/position/rms_error") - 1e-5).abs() < 1e-12);
    // A velocity error counts over ω0 times the amplitude, 0.2 m/s·√10.
    let file = b"time,position,velocity\n0,0.1,0.001\n";
    let found = number(&json(file, "laboratory-c"), "/velocity/max_error");
    assert!((found - 0.001 / (0.2 * f64::sqrt(10.0))).abs() < 1e-15, "{found}");
}

#[test]
fn what_samples_do_at_rest_is_told_apart() {
    let creeping = laboratory(|time| 3e-6 * (time - 4.0).max(0.0));
    let result = json(&creeping, "laboratory-c");
    assert_eq!(result["rest"]["sticks"], false);
    assert!((number(&result, "/rest/creep") - 3e-6).abs() < 1e-12);
    let summary = score(&creeping, &["--problem", "laboratory-c"]).out;
    assert!(summary.contains("they creep on, at 3 µm/s"), "{summary}");
    let swinging = laboratory(|time| 1e-4 * (6.3 * time).sin());
    let summary = score(&swinging, &["--problem", "laboratory-c"]).out;
    assert!(summary.contains("they keep moving, within 200 µm"), "{summary}");
    let late = laboratory(|time| if (4.96..5.1).contains(&time) { 1e-4 } else { 0.0 });
    assert_eq!(json(&late, "laboratory-c")["rest"]["sticks"], true);
    let few = score(b"t,x\n0,0.1\n6,0.0019", &["--problem", "laboratory-c", "--lang", "de"]).out;
    assert!(few.contains("zu wenige"), "{few}");
}

#[test]
fn tables_are_read_as_other_programs_write_them() {
    let found = |file: &str| {
        let result = json(file.as_bytes(), "laboratory-c");
        (number(&result, "/samples"), number(&result, "/last/time"))
    };
    for file in [
        "time,position\n0,0.1\n0.5,-0.09\n",
        "\u{feff}Time (s);Position (m);Mode\r\n0,5;-0,09;1\r\n\r\n0;0,1;-1\r\n",
        "# x , t\n -9e-2 , +5e-1 \n\u{2212}0.1,0",
        "\"t\",\"x\"\n\"0.50\",\"-.09\"\n0,1e-1",
        "t;x\n0.5;-0.09\n0;0.1\n",
    ] {
        assert_eq!(found(file), (2.0, 0.5), "{file}");
    }
    let workplace = Workplace::new();
    workplace.write("s.csv", b"t,x\n0,0.1\n");
    let mut command = assert_cmd::Command::cargo_bin("federpendel").expect("the program");
    let command = command.args(["score", "-", "--problem", "laboratory-c"]);
    let output = command.write_stdin("t,x\n0,0.1\n").output().expect("a run");
    assert!(output.status.success());
}

fn refused(file: &[u8], arguments: &[&str], parts: &[&str]) {
    let Finished { status, out, err } = score(file, arguments);
    assert_eq!((status, out.as_str()), (Some(2), ""), "{arguments:?}: {err}");
    assert_eq!(err.lines().count(), 1, "{err}");
    for part in parts {
        assert!(err.contains(part), "{err:?} lacks {part:?}");
    }
}

#[test]
fn bad_tables_are_refused_with_their_place() {
    let says = |file: &str, parts: &[&str]| {
        refused(file.as_bytes(), &["--problem", "laboratory-c"], parts);
    };
    says("", &["s.csv is empty", "time and position"]);
    says("\n \n", &["s.csv is empty"]);
    says("time,position\n", &["s.csv has a header but no samples"]);
    says("time,pos\n0,1\n", &["s.csv:1: the header “time,pos”", "column position", "or x"]);
    says("0,0.1\n1,0.2\n", &["s.csv:1: the header “0,0.1” has no column time"]);
    says("t,x,time\n0,1,0\n", &["s.csv:1: the column time stands twice"]);
    says("time (ms),x\n0,1\n", &["s.csv:1: the column time is in “ms”; allowed is s"]);
    says("t,x\n0,0.1\n\n1,abc\n", &["s.csv:4: position is “abc”; allowed is a number"]);
    says("t,x\r\n0,0.1\r\n1,\r\n", &["s.csv:3: position is “”"]);
    says("t;x\n0;1.000,5\n", &["s.csv:2: position is “1.000,5”"]);
    for value in ["nan", "NaN", "inf", "-Infinity", "1e999", "1e101"] {
        let file = format!("t,x,v\n0,0.1,{value}\n");
        says(&file, &["s.csv:2: velocity is “", value, "a finite number, at most 1e100"]);
    }
    says("t,x\n0,1\n-0.5,1\n", &["s.csv:3: time is “-0.5”; allowed is 0 or greater"]);
    says("t,x\n0,5;1\n", &["s.csv:2:", "“5;1”"]);
    says("t,x\n0,5,0,1\n", &["s.csv:2: this row has 4 cells, the header 2", "decimal commas"]);
    says("t,x\n1e101,0\n", &["s.csv:2: time is “1e101”"]);
    let beyond = ["s.csv: ", "1e90", "swings"];
    refused(b"t,x\n1e90,0\n", &["--problem", "laboratory-free"], &beyond);
    refused(
        b"t,x\n0,1\n0,\xff\n",
        &["--problem", "laboratory-c"],
        &["s.csv:3: this line is not UTF-8"],
    );
}

#[test]
fn bad_requests_are_refused() {
    let good = b"t,x\n0,0.1\n";
    refused(good, &["--problem", "laboratorie-c"], &["“laboratorie-c”", "laboratory-c?"]);
    refused(good, &["--problem", "qqq"], &["“qqq”", "score --list shows"]);
    refused(good, &[], &["--problem is missing"]);
    refused(good, &["--problem"], &["--problem has no value"]);
    refused(good, &["--problem", "tie-1", "--times"], &["--times only with --problem"]);
    refused(good, &["--problem", "tie-1", "--format", "csv"], &["--format", "summary, json"]);
    refused(good, &["more.csv", "--problem", "tie-1"], &["“more.csv” is one file too many"]);
    refused(good, &["--problem", "tie-1", "--mass", "1"], &["--mass is unknown"]);
    let workplace = Workplace::new();
    for (arguments, status, part) in [
        (&["--list", "nothing like it"][..], 2, "“nothing like it”"),
        (&["--list", "--times"], 2, "--list stands alone"),
        (&["--times"], 2, "--problem is missing"),
        (&["--problem", "tie-1"], 2, "The file of samples is missing"),
        (&["nowhere.csv", "--problem", "tie-1"], 1, "nowhere.csv: no such file"),
        (&["nowhere.csv", "--problem", "tie-1", "--lang", "de"], 1, "nicht gefunden"),
        (&["--problem", "tie-123", "--lang", "de"], 2, "so heißt kein Problem; war tie-1"),
    ] {
        let finished = workplace.run(&[&["score"], arguments].concat());
        assert_eq!(finished.status, Some(status), "{arguments:?}: {}", finished.err);
        assert!(finished.err.contains(part), "{:?} lacks {part:?}", finished.err);
        assert_eq!((finished.out.as_str(), finished.err.lines().count()), ("", 1));
    }
}

#[test]
fn problems_are_listed_one_in_a_line() {
    let list =
        |arguments: &[&str]| Workplace::new().run(&[&["score", "--list"], arguments].concat()).out;
    let all = list(&[]);
    assert_eq!(all.lines().count(), 356);
    let of_drag = list(&["Strong-Drag"]);
    assert!(of_drag.lines().count() > 10, "a corner is found");
    assert!(of_drag.lines().all(|line| all.contains(line.split(' ').next().unwrap_or(line))));
    assert!(list(&["laboratory"]).starts_with("laboratory-free"));
}
