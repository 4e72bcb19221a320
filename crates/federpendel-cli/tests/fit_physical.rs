//! `fit` with a mass, a stiffness or a normal force: recordings with a known truth, and input that is refused.

mod common;

use common::Workplace;
use serde_json::Value;

/// 0.25 kg that move on 12 N/m, with dry friction of 0.02 N and D = 0.02 kg/s.
const EXPERIMENT: [&str; 12] = [
    "--mass",
    "250 g",
    "--stiffness",
    "12 N/m",
    "--damping",
    "0.02 kg/s",
    "--kinetic",
    "0.01",
    "--normal-force",
    "2 N",
    "--noise",
    "0.2 mm",
];

/// The place of a recording of that experiment.
fn recorded() -> Workplace {
    let workplace = Workplace::new();
    let rest = ["--duration", "12 s", "--seed", "3", "-o", "r.csv"];
    let finished = workplace.run(&[&["simulate"], &EXPERIMENT[..], &rest].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    workplace
}

fn json(workplace: &Workplace, file: &str, arguments: &[&str]) -> Value {
    let finished = workplace.run(&[&["fit", file, "--format", "json"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    common::document(&finished.out, "fit.schema.json")
}

fn assert_near(number: &Value, truth: f64, unit: &str) {
    let field = |name: &str| number[name].as_f64().unwrap_or_else(|| panic!("{number}"));
    assert!((field("value") - truth).abs() < 4.0 * field("stderr"), "{number}: {truth}");
    assert!(field("stderr") < 0.1 * truth, "{number}");
    assert_eq!(number["unit"], unit);
}

#[test]
fn what_was_put_in_comes_back() {
    let workplace = recorded();
    // Of 250 g that move, a third of 30 g are the spring's.
    let mass = ["--mass", "240(1) g", "--spring-mass", "30 ± 1 g"];
    let given = [&mass[..], &["--normal-force", "2,00 ± 0,02 N"]].concat();
    let fit = json(&workplace, "r.csv", &given);
    let physical = &fit["physical"];
    for (name, truth, unit) in [
        ("moving_mass", 0.25, "kg"),
        ("stiffness", 12.0, "N/m"),
        ("damping", 0.02, "kg/s"),
        ("coulomb_force", 0.02, "N"),
        ("kinetic", 0.01, "1"),
    ] {
        assert_near(&physical[name], truth, unit);
    }
    assert_eq!(physical["mass"]["stderr"], 0.001);
    assert_eq!(physical["absent"]["newton_coefficient"], "law");
    let ratio = &fit["damping"]["damping_ratio"];
    assert_near(ratio, 0.02 / (2.0 * (0.25f64 * 12.0).sqrt()), "1");
    assert_eq!(fit["damping"]["equivalent"].as_array().map(Vec::len), Some(5));

    let by_stiffness = json(&workplace, "r.csv", &["--stiffness", "12.00 +/- 0.03 N/m"]);
    assert_near(&by_stiffness["physical"]["mass"], 0.25, "kg");
    assert_eq!(by_stiffness["physical"]["absent"]["kinetic"], "normal-force");
    assert!(json(&workplace, "r.csv", &[])["physical"].is_null());
}

#[test]
fn a_forgotten_spring_is_asked_for() {
    let workplace = recorded();
    let both = ["fit", "r.csv", "--mass", "240(1) g", "--stiffness", "12.00(3) N/m"];
    let without = workplace.run(&both);
    assert!(without.out.contains("Was the mass of the spring left out?"), "{}", without.out);
    let with = workplace.run(&[&both[..], &["--spring-mass", "30(1) g"]].concat());
    assert!(!with.out.contains("left out"), "{}", with.out);
    assert!(with.out.contains("moving mass M = m + m_s/3"), "{}", with.out);
}

#[test]
fn angles_have_no_mass_on_a_spring() {
    let workplace = recorded();
    let text = String::from_utf8(workplace.read("r.csv")).expect("text");
    let header = text.lines().next().expect("a header");
    // Without a unit the name says it.
    for heading in ["Angle (rad)", "Winkel"] {
        let angles = text.replacen(header, &format!("Time (s),{heading}"), 1);
        workplace.write("angles.csv", angles.as_bytes());
        let fit = json(&workplace, "angles.csv", &["--mass", "240 g", "--horizontal"]);
        let physical = &fit["physical"];
        let absent = physical["absent"].as_object().expect("reasons");
        assert!(absent.len() == 8 && absent.values().all(|why| why == "angle"), "{physical}");
        assert!(physical["stiffness"].is_null() && physical["mass"].is_null());
    }
}

#[test]
fn the_summary_shows_them_in_both_languages() {
    let workplace = recorded();
    let fit = ["fit", "r.csv", "--mass", "250(1) g", "--horizontal"];
    let english = workplace.run(&fit).out;
    for said in ["stiffness C  ", "± ", "damping D  ", "kinetic coefficient μ", "level guide"] {
        assert!(english.contains(said), "{said}: {english}");
    }
    // One row has the first and the last; those between them are details.
    assert!(!english.contains("equivalent damping ratio at"), "{english}");
    let german = workplace.run(&[&fit[..], &["--lang", "de", "--details"]].concat()).out;
    for said in ["Federkonstante C", "Gleitreibungszahl μ", "gleichwertiger Dämpfungsgrad bei"] {
        assert!(german.contains(said), "{said}: {german}");
    }
}

#[test]
fn what_is_no_measurement_is_refused() {
    let workplace = recorded();
    for (arguments, said) in [
        (&["--mass", "0 g"][..], &["--mass is “0 g”", "greater than 0"][..]),
        (&["--mass", "-1(1) kg"], &["--mass", "greater than 0"]),
        (&["--mass", "12 N/m"], &["--mass", "a stiffness", "a mass (kg, g"]),
        (&["--mass", "250(a) g"], &["--mass is “250(a) g”", "250(1) g"]),
        (&["--stiffness", "12 ± -1 N/m"], &["--stiffness", "uncertainty is negative"]),
        (&["--stiffness", "12 N/m ± 1"], &["--stiffness", "uncertainty has no unit"]),
        (&["--stiffness", "12 N/m ± 1 g"], &["--stiffness", "a mass"]),
        (&["--spring-mass", "-1 g"], &["--spring-mass", "0 or greater"]),
        (&["--normal-force", "0 N"], &["--normal-force", "greater than 0"]),
        (&["--horizontal", "--normal-force", "2 N"], &["--horizontal", "--normal-force is “2 N”"]),
        (&["--gravity", "9.81"], &["--gravity is “9.81”", "--horizontal"]),
        (&["--horizontal", "--gravity", "0 m/s^2"], &["--gravity", "greater than 0"]),
    ] {
        let finished = workplace.run(&[&["fit", "r.csv", "-o", "fit.json"], arguments].concat());
        assert_eq!(finished.status, Some(2), "{arguments:?}: {}", finished.err);
        assert_eq!(finished.err.lines().count(), 1, "{}", finished.err);
        for part in said {
            assert!(finished.err.contains(part), "{arguments:?}: {}", finished.err);
        }
        assert_eq!((finished.out.as_str(), workplace.files()), ("", vec!["r.csv".to_owned()]));
    }
}
