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
        (&["--details"][..], "one standard error", "--horizontal, for a body on a level guide"),
        (&["--lang", "de"], "ein Standardfehler", "Mit --mass folgen auch"),
    ] {
        let plain = summary(1, arguments);
        assert_eq!((plain.matches(said).count(), plain.matches(hint).count()), (1, 1), "{plain}");
        let with_mass = summary(1, &[arguments, &["--mass", "500 g"]].concat());
        assert!(with_mass.contains(said) && !with_mass.contains(hint), "{with_mass}");
    }
}

/// A folder with a recording of these laws, and without units as some programs write it.
fn recorded(laws: &[&str]) -> Workplace {
    let workplace = Workplace::new();
    workplace.run(
        &[&["simulate", "--noise", "0.5 mm", "--duration", "6 s", "-o", "r.csv"], laws].concat(),
    );
    let table = String::from_utf8(workplace.read("r.csv")).expect("text");
    let rows = table.split_once('\n').expect("rows below a header").1;
    for name in ["a.dat", "b.dat", "c.dat"] {
        workplace.write(name, rows.as_bytes());
    }
    workplace
}

#[test]
fn damping_ratios_are_called_what_they_are() {
    for (laws, said, not_said) in [
        (
            &["--damping", "0.1"][..],
            &["  viscous damping ratio", "  equivalent damping ratio  "][..],
            "  damping ratio",
        ),
        (&["--kinetic", "0", "--damping", "0.1"], &["  damping ratio"], "equivalent damping ratio"),
        (&[], &["  equivalent damping ratio  "], "viscous damping ratio"),
    ] {
        let out = recorded(laws).run(&["fit", "r.csv"]).out;
        assert!(said.iter().all(|said| out.contains(said)) && !out.contains(not_said), "{out}");
        // Without dry friction there is no μ to be had.
        assert_eq!(out.contains("also μ"), !laws.contains(&"--kinetic"), "{out}");
    }
}

/// ζ_eq = 2a_c/(πω0²A) with a_c = μg, from the release at 10 cm to the last turning point that the mass leaves.
#[test]
fn the_equivalent_damping_ratio_is_that_of_the_first_and_the_last_amplitude() {
    let out = recorded(&[]).run(&["fit", "r.csv"]).out;
    let row = out.lines().find(|line| line.contains("equivalent damping ratio")).expect("a row");
    let ratio = |amplitude: f64| 2.0 * 0.02 * 9.81 / (std::f64::consts::PI * 40.0 * amplitude);
    // Each turn loses 2·μg/ω0² = 9.81 mm; the tenth stays where it is.
    let last = 0.1 - 9.0 * 2.0 * 0.02 * 9.81 / 40.0;
    let expected = format!("{:.3} to {:.2} (", ratio(0.1), ratio(last));
    assert!(row.contains(&expected), "{row}: {expected}");
}

#[test]
fn a_statistic_of_the_noise_needs_the_noise() {
    let workplace = recorded(&[]);
    for (arguments, said) in [(&["--details"][..], 0), (&["--details", "--sigma", "0.5 mm"], 1)] {
        let out = workplace.run(&[&["fit", "r.csv"], arguments].concat()).out;
        assert_eq!(out.matches("reduced χ²").count(), said, "{out}");
    }
}

#[test]
fn what_was_assumed_of_many_files_is_said_once() {
    let err = recorded(&[]).run(&["fit", "r.csv", "a.dat", "b.dat", "c.dat"]).err;
    let assumed: Vec<_> =
        err.lines().filter(|line| line.contains("a position is assumed")).collect();
    assert_eq!(assumed.len(), 1, "{err}");
    assert!(assumed[0].starts_with("a.dat and 2 more files: "), "{err}");
}
