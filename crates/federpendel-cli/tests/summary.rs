//! What the first screen and the details say, and what they leave out.

mod common;

use common::Workplace;

/// Standard output with single spaces, whatever its lines.
fn words(arguments: &[&str]) -> String {
    let finished = Workplace::new().run(&[&["simulate"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{arguments:?}: {}", finished.err);
    finished.out.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[track_caller]
fn says(arguments: &[&str], parts: &[&str]) {
    let text = words(arguments);
    for part in parts {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn what_is_given_stands_first() {
    says(&[], &["given m = 500 g, C = 20 N/m, x0 = 10 cm friction"]);
    says(
        &["--mass", "5", "--velocity", "-0,5", "--lang", "de"],
        &["Angegeben m = 5 kg, C = 20 N/m, x0 = 10 cm, v0 = −50 cm/s Reibung"],
    );
}

#[test]
fn with_newton_friction_the_period_is_one_of_small_swings() {
    let newton = ["--newton-coefficient", "1", "--details"];
    says(&newton, &["ms at small amplitude (frequency", "period at small amplitude T"]);
    let german = [&newton[..], &["--lang", "de"]].concat();
    says(&german, &["ms bei kleinen Ausschlägen (Frequenz", "Periode bei kleinen Ausschlägen T"]);
    assert!(!words(&["--details"]).contains("small amplitude"));
}

#[test]
fn rounding_is_not_shown() {
    // Released such that it rests in the centre, but for rounding.
    let centre = ["--position", "9.81 cm", "--details"];
    says(&centre, &["4.967 s, 0 m from the centre"]);
    let undamped = ["--kinetic", "0", "--details"];
    says(&undamped, &["100 mJ at the end of the record", "kinetic 0 J potential 100 mJ"]);
    for arguments in [&centre[..], &undamped] {
        let text = words(arguments);
        let shown = text.split("error of positions below").next().unwrap_or_default();
        assert!(!shown.contains("× 10⁻"), "{shown}");
    }
    says(
        &["--kinetic", "0", "--damping", "0.2", "--method", "article-printed"],
        &["article-printed agrees with that motion to rounding."],
    );
}

#[test]
fn the_damping_ratio_does_not_contradict_its_word() {
    let critical = 2.0 * 10f64.sqrt();
    for (factor, part) in [(0.999_975, "0.99998 (underdamped)"), (1.000_01, "1.00001 (overdamped)")]
    {
        let damping = (factor * critical).to_string();
        says(&["--kinetic", "0", "--damping", &damping], &[part]);
    }
    says(&["--kinetic", "0", "--damping", "7,9", "--lang", "de"], &["1,249 (Kriechfall)"]);
}

#[test]
fn the_articles_solutions_without_a_number_have_names() {
    let with = |damping| ["--kinetic", "0", "--damping", damping, "--method", "article-printed"];
    says(&with("40"), &["article-printed, the article’s solution for overdamped motion"]);
    let german = [&with("40")[..], &["--lang", "de"]].concat();
    says(&german, &["article-printed, die Lösung des Artikels für den Kriechfall"]);
}

#[test]
fn a_tie_at_the_release_has_no_last_swing() {
    says(&["--position", "0,004905 m"], &["It is released on the edge of the sticking band"]);
}

#[test]
fn nothing_is_said_of_a_scheme_that_has_run_away() {
    let text = words(&["--method", "article-scheme", "--dt", "0,5 s"]);
    assert!(!text.contains("chatters") && !text.contains("MJ"), "{text}");
    assert!(text.contains(" J (article-scheme)") && text.contains(" × 10"), "{text}");
}
