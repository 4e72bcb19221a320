//! `fit --format csv`: what engineers read off a row.

mod common;

use std::collections::HashMap;
use std::f64::consts::PI;

use common::Workplace;

/// The rows of `fit` with these arguments, each by the names of its columns.
fn rows(workplace: &Workplace, arguments: &[&str]) -> Vec<HashMap<String, String>> {
    let finished = workplace.run(&[&["fit", "--format", "csv"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    read(&finished.out)
}

fn read(table: &str) -> Vec<HashMap<String, String>> {
    let mut table = csv::Reader::from_reader(table.as_bytes());
    table.deserialize().map(|row| row.expect("a row as long as the header")).collect()
}

fn number(row: &HashMap<String, String>, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name}: {:?}", row[name]))
}

/// A recording of the built-in experiment, or with Stokes friction of this D, kg/s.
fn record(workplace: &Workplace, name: &str, damping: Option<&str>) {
    let law = damping.map(|damping| ["--kinetic", "0", "--damping", damping]);
    let law = law.iter().flatten().copied().collect::<Vec<_>>();
    let file = format!("./{name}");
    let recorded =
        workplace.run(&[&["simulate", "--noise", "0.5 mm", "-o", &file], &law[..]].concat());
    assert_eq!(recorded.status, Some(0), "{}", recorded.err);
}

#[test]
fn a_row_has_the_figures_of_engineers() {
    let workplace = Workplace::new();
    record(&workplace, "stokes.csv", Some("0.1"));
    record(&workplace, "coulomb.csv", None);
    let rows = rows(&workplace, &["stokes.csv", "coulomb.csv", "--mass", "500(1) g"]);
    let [stokes, coulomb] = &rows[..] else { panic!("{rows:?}") };
    // Mass 0.5 kg and stiffness 20 N/m.
    for row in &rows {
        let (found, error) =
            (number(row, "natural_frequency"), number(row, "natural_frequency_stderr"));
        assert!((found - 40f64.sqrt() / (2.0 * PI)).abs() < 5.0 * error && error < 0.01, "{row:?}");
        assert!(row["stiffness"].parse::<f64>().is_ok(), "{row:?}");
    }
    // D = 0.1 kg/s: Q = √(CM)/D, and Λ is the logarithm of the ratio of two amplitudes.
    let quality = (20.0f64 * 0.5).sqrt() / 0.1;
    let (found, error) =
        (number(stokes, "quality_factor"), number(stokes, "quality_factor_stderr"));
    assert!((found - quality).abs() < 5.0 * error && error < 0.1 * quality, "{stokes:?}");
    let decrement = number(stokes, "logarithmic_decrement");
    assert!((decrement - PI / quality).abs() < 0.1 * decrement, "{stokes:?}");
    assert_eq!(coulomb["quality_factor"], "");
    // Dry friction damps small swings more.
    let [first, last] = ["first", "last"].map(|end| {
        let name = format!("equivalent_damping_{end}");
        [number(coulomb, &name), number(coulomb, &format!("{name}_amplitude"))]
    });
    assert!(first[0] < last[0] && first[1] > last[1], "{coulomb:?}");
}

#[test]
fn a_name_does_not_begin_a_formula() {
    let workplace = Workplace::new();
    for name in ["=1+1.csv", "+1.csv", "@a.csv", "a=1.csv"] {
        record(&workplace, name, None);
    }
    let rows = rows(&workplace, &["=1+1.csv", "+1.csv", "@a.csv", "a=1.csv"]);
    let names: Vec<&str> = rows.iter().map(|row| &row["name"][..]).collect();
    assert_eq!(names, ["./=1+1.csv", "./+1.csv", "./@a.csv", "a=1.csv"]);
}

#[test]
fn a_file_that_cannot_be_fitted_has_a_row_with_the_reason() {
    let workplace = Workplace::new();
    record(&workplace, "a.csv", None);
    workplace.write("b.csv", b"t (s),x (m)\n0,err\n1,err\n2,err\n3,err\n");
    let table = String::from_utf8(workplace.read("a.csv")).expect("text");
    workplace.write("c.csv", table.split_once('\n').expect("rows below a header").1.as_bytes());
    let finished =
        workplace.run(&["fit", "b.csv", "a.csv", "c.csv", "--format", "csv", "-o", "r.html"]);
    assert_eq!(finished.status, Some(2), "{}", finished.err);
    let rows = read(&finished.out);
    let names: Vec<&str> = rows.iter().map(|row| &row["name"][..]).collect();
    assert_eq!(names, ["a.csv", "c.csv", "b.csv"]);
    let [fitted, assumed, failed] = &rows[..] else { panic!("{rows:?}") };
    assert_eq!((&fitted["error"][..], &fitted["notes"][..]), ("", ""));
    assert!(assumed["notes"].contains("a position is assumed"), "{assumed:?}");
    assert!(failed["error"].contains("b.csv:2: ") && failed["error"].contains("err"), "{failed:?}");
    let known = failed.iter().filter(|(_, cell)| !cell.is_empty()).count();
    assert_eq!(known, 2, "{failed:?}");
    let page = String::from_utf8_lossy(&workplace.read("r.html")).into_owned();
    let page = page.replace('\u{a0}', " ");
    assert!(page.contains("Which friction acts in 2 of 3 recordings?"), "{page}");
    assert!(page.contains("1 of 3 recordings could not be fitted."), "{page}");
    assert!(page.contains("<li>b.csv:2: "), "{page}");
}

/// In noise half as large as what the weaker law does, two mixes describe the recording.
#[test]
fn what_a_recording_leaves_open_has_a_column() {
    let workplace = Workplace::new();
    record(&workplace, "sure.csv", None);
    let simulate = ["simulate", "--damping", "0.1", "--noise", "5 mm", "--samples", "200"];
    workplace.run(&[&simulate[..], &["--duration", "4 s", "--seed", "3", "-o", "o.csv"]].concat());
    let rows = rows(&workplace, &["sure.csv", "o.csv"]);
    assert_eq!((&rows[0]["laws"][..], &rows[0]["alternatives"][..]), ("coulomb", ""));
    let mut mixes = ["laws", "alternatives"].map(|name| &rows[1][name][..]);
    mixes.sort_unstable();
    assert_eq!(mixes, ["coulomb+newton", "stokes+coulomb"]);
}
