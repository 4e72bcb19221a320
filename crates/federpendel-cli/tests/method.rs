//! What is said about another method than the exact one: its faults, its energy, its steps.

mod common;

use common::{Finished, Workplace};

fn run(arguments: &[&str]) -> Finished {
    let finished = Workplace::new().run(&[&["simulate"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{arguments:?}: {}", finished.err);
    finished
}

/// Standard output with single spaces, whatever its lines.
fn words(arguments: &[&str]) -> String {
    run(arguments).out.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_first_screen_says_what_is_wrong_with_it() {
    for (method, says) in [
        (
            "article-printed",
            "Equation (69) of the article lets the amplitude fall at a rate that is wrong",
        ),
        (
            "article-corrected",
            "Equation (61) of the article meets the exact motion only at its turning points",
        ),
        ("article-scheme", "The scheme has no static friction"),
    ] {
        let text = words(&["--method", method]);
        assert!(text.contains(says), "{text}");
    }
    let text = words(&["--method", "article-printed", "--velocity", "-0.3", "--lang", "de"]);
    assert!(
        text.contains("Gleichung (79) des Artikels verliert bei v0 < 0, wie hier, den Quadranten"),
        "{text}"
    );
    let stokes = words(&["--method", "article-printed", "--kinetic", "0", "--damping", "0.2"]);
    assert!(!stokes.contains("Equation ("), "{stokes}");
}

#[test]
fn the_energy_is_the_one_of_the_json() {
    let method = ["--method", "article-corrected", "--details"];
    let text = words(&method);
    let json = run(&[&method[..2], &["--format", "json"]].concat()).out;
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let energy = |part: &str| json["energy"][part].as_f64().expect("a number");
    let left = energy("kinetic") + energy("potential");
    let catalogue = federpendel_text::Catalogue::new(federpendel_text::Language::English);
    let joule = |energy: f64, digits| catalogue.quantity(energy, "J", digits);
    let both = format!("36.1 µJ (exact motion), {} (article-corrected)", joule(left, 4));
    assert!(text.contains(&both), "{both}: {text}");
    let section = format!(
        "Energy at the end of the record (article-corrected) kinetic {} potential {}",
        joule(energy("kinetic"), 9),
        joule(energy("potential"), 9)
    );
    assert!(text.contains(&section), "{section}: {text}");
    for heading in ["Energy at the end of the record", "How well it is known", "Turning points"] {
        assert!(text.contains(&format!("{heading} (exact motion)")), "{heading}: {text}");
    }
    let series =
        words(&["--damping", "1", "--newton-coefficient", "1", method[0], "article-scheme"]);
    assert!(series.contains("(motion to rounding)") && !series.contains("exact"), "{series}");
    assert!(!words(&["--details"]).contains("(exact motion)"));
}

#[test]
fn the_margin_of_a_rest_is_a_length_and_a_share_of_the_offset() {
    // f = 4.905 mm, f_s = 9.81 mm, rest at 1.9 mm after ten swings: earlier at 8.29 − … inside f_s.
    let text = words(&["--static", "0.04", "--details"]);
    let margin = text.split("rest inside the sticking band ").nth(1).expect("a margin");
    let mut parts = margin.split(' ');
    let distance: f64 = parts.next().and_then(|number| number.parse().ok()).expect("a length");
    let percent = margin.split("its edge, ").nth(1).and_then(|rest| rest.split(' ').next());
    let percent: f64 = percent.and_then(|number| number.parse().ok()).expect("a share");
    assert!(margin.contains("% of the offset f"), "{margin}");
    assert!((distance / 4.905 - percent / 100.0).abs() < 1e-3, "{margin}");
    assert!(!words(&["--details", "--kinetic", "0"]).contains("sticking band"));
}

#[test]
fn a_step_that_is_too_long_is_said_so_with_one_that_is_safe() {
    // Without friction it is stable below 2/ω0 = 316 ms.
    let scheme = ["--method", "article-scheme", "--kinetic", "0", "--duration", "5 s"];
    let with = |step: &'static str| run(&[&scheme[..], &["--dt", step]].concat());
    let err = with("340 ms").err;
    assert!(err.starts_with("warning: a time step of 340 ms is too long"), "{err}");
    assert!(err.contains("stable below 316 ms") && err.contains("993 µs"), "{err}");
    assert_eq!(with("20 ms").err, "");
    let german = run(&[&scheme[..], &["--dt", "0,34", "--lang", "de"]].concat()).err;
    assert!(german.starts_with("Warnung: ein Zeitschritt von 340 ms ist zu lang"), "{german}");
    // Stable, but the phase goes astray.
    let err = run(&[&scheme[..4], &["--dt", "60 ms", "--duration", "60 s"]].concat()).err;
    assert!(err.contains("60 ms is too long for this record"), "{err}");
    // Stokes friction makes it shorter: 2/(γ + √(γ² + ω0²)) with γ = 40/s.
    let damped = ["--damping", "40", "--kinetic", "0", "--duration", "2 s", "--dt", "35 ms"];
    let err = run(&[&["--method", "article-scheme"], &damped[..]].concat()).err;
    assert!(err.contains("stable below 24.8 ms"), "{err}");
    // So long that no numbers are left.
    let far = [&["simulate"], &scheme[..4], &["--dt", "1 s", "--duration", "1000 s"]].concat();
    let finished = Workplace::new().run(&far);
    assert_eq!((finished.status, finished.out.as_str()), (Some(2), ""));
    assert!(finished.err.contains("stable below 316 ms"), "{}", finished.err);
}
