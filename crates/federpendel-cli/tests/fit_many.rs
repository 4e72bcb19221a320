//! Several recordings on a terminal.

mod common;

use common::Workplace;

/// What the summary says of so many recordings of 0.5 kg on 20 N/m.
fn summary(count: usize, arguments: &[&str]) -> String {
    let workplace = Workplace::new();
    let names: Vec<String> = (0..count).map(|i| format!("{i}.csv")).collect();
    for (i, name) in names.iter().enumerate() {
        let seed = i.to_string();
        workplace.run(&[
            "simulate",
            "--noise",
            "1 mm",
            "--duration",
            "6 s",
            "--seed",
            &seed,
            "-o",
            name,
        ]);
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let finished = workplace.run(&[&["fit"], arguments, &names[..]].concat());
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    finished.out
}

#[test]
fn a_few_are_written_in_full_and_physical_numbers_of_many_stay() {
    for (count, in_full) in [(2, true), (5, false)] {
        let summary = summary(count, &["--mass", "500(1) g"]);
        assert_eq!(summary.matches("stiffness C").count(), count, "{summary}");
        let values = summary.matches("position at the beginning").count();
        assert_eq!(values, if in_full { count } else { 0 }, "{summary}");
    }
}

#[test]
fn a_summary_says_what_plus_minus_is_and_what_a_mass_would_add() {
    for (arguments, said, hint) in [
        (&["--details"][..], "one standard error", "--mass and --horizontal add"),
        (&["--lang", "de"], "ein Standardfehler", "Mit --mass und --horizontal"),
    ] {
        let plain = summary(1, arguments);
        assert_eq!((plain.matches(said).count(), plain.matches(hint).count()), (1, 1), "{plain}");
        let with_mass = summary(1, &[arguments, &["--mass", "500 g"]].concat());
        assert!(with_mass.contains(said) && !with_mass.contains(hint), "{with_mass}");
    }
}
