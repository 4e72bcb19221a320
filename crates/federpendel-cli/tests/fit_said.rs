//! What the summary of a fit says of mixes asked for, and of rests that come too soon.

mod common;

use common::Workplace;

/// The summary of `fit` with `arguments`, of a recording simulated with those before; on one line.
fn summary(simulate: &[&str], arguments: &[&str]) -> String {
    let workplace = Workplace::new();
    let recorded = workplace.run(&[&["simulate", "-o", "r.csv"], simulate].concat());
    assert_eq!(recorded.status, Some(0), "{}", recorded.err);
    let fitted = workplace.run(&[&["fit", "r.csv"], arguments].concat());
    assert_eq!(fitted.status, Some(0), "{}", fitted.err);
    fitted.out.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Stokes friction alone.
const STOKES: [&str; 10] = [
    "--kinetic",
    "0",
    "--damping",
    "0.15",
    "--noise",
    "0.2 mm",
    "--seed",
    "1",
    "--duration",
    "8 s",
];

#[test]
fn it_is_the_mix_asked_for_that_does_not_fit() {
    let none = summary(&STOKES, &["--laws", "none"]);
    assert!(
        none.contains("An undamped motion does not describe this recording: its amp"),
        "{none}"
    );
    let none = summary(&STOKES, &["--laws", "none", "--lang", "de"]);
    assert!(
        none.contains("Eine ungedämpfte Bewegung beschreibt diese Aufzeichnung nicht"),
        "{none}"
    );
    let newton = summary(&STOKES, &["--laws", "newton"]);
    let rejected = "This mix is rejected";
    assert!(newton.contains(rejected) || newton.contains("This mix does not"), "{newton}");
    // What Stokes friction explains is no fault of all mixes.
    assert!(!newton.contains("any mix"), "{newton}");
    let stokes = summary(&STOKES, &["--laws", "stokes"]);
    assert!(stokes.contains("Fitted as asked") && !stokes.contains(rejected), "{stokes}");
}

#[test]
fn a_rest_after_one_swing_gives_a_bound() {
    let dry = ["--kinetic", "0.25", "--noise", "0.2 mm", "--duration", "3 s"];
    let said = summary(&dry, &["--mass", "500 g", "--horizontal"]);
    for words in
        ["acts: a_c ≥ 0.7", "μ ≥ 0.07", "rests on one swing", "one swing before that tells only"]
    {
        assert!(said.contains(words), "{words}: {said}");
    }
    assert!(!said.contains("a_c ="), "{said}");
}

#[test]
fn swings_are_counted_up_to_the_rest() {
    let dry = ["--kinetic", "0.06", "--noise", "0.2 mm", "--duration", "8 s"];
    let said = summary(&dry, &[]);
    assert!(
        said.contains("comes to rest") && said.contains("swings (half periods) only"),
        "{said}"
    );
}

#[test]
fn laws_that_stand_alone_are_said_to() {
    let workplace = Workplace::new();
    workplace.write("r.csv", b"no numbers here\n");
    for (list, name) in [("none,stokes", "none"), ("stokes, auto", "auto")] {
        let run = workplace.run(&["fit", "r.csv", "--laws", list]);
        assert_eq!(run.status, Some(2));
        assert!(run.err.contains(&format!("“{name}” beside others")), "{}", run.err);
    }
}

#[test]
fn names_are_said_without_what_a_terminal_obeys() {
    let workplace = Workplace::new();
    let name = "e\u{1b}[31m\n\u{202e}x.csv";
    let run = workplace.run(&["fit", name]);
    assert!(run.err.contains("e [31m  x.csv: no such file"), "{:?}", run.err);
    let long = format!("time (s),position{} (m)\n", "y".repeat(1000));
    let rows = |i: i32| {
        let time = 0.02 * f64::from(i);
        format!("{time},{}\n", 0.1 * (-0.1 * time).exp() * (6.0 * time).cos())
    };
    let table = (0..400).map(rows).fold(long, |table, row| table + &row);
    workplace.write("long.csv", table.as_bytes());
    let run = workplace.run(&["fit", "long.csv"]);
    assert!(run.out.contains("positionyyy") && !run.out.contains(&"y".repeat(100)), "{}", run.out);
}

#[test]
fn a_folder_is_no_file_to_write() {
    let workplace = Workplace::new();
    let run = workplace.run(&["simulate", "-o", "new.svg/"]);
    assert_eq!((run.status, workplace.files().len()), (Some(2), 0), "{}", run.err);
    assert!(run.err.contains("new.svg/"), "{}", run.err);
}
