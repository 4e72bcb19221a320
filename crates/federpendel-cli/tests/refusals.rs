//! One sentence for what cannot be done: it names the flag, the value and what is allowed, in the user's language.

mod common;

use common::Workplace;

/// The sentence that refuses `arguments`; nothing is written.
fn refusal(arguments: &[&str]) -> String {
    let workplace = Workplace::new();
    workplace.write("r.csv", b"no numbers here\n");
    let finished = workplace.run(arguments);
    assert_eq!(finished.status, Some(2), "{arguments:?}: {}", finished.err);
    assert_eq!(workplace.files(), ["r.csv"], "{arguments:?}");
    assert_eq!(finished.err.lines().count(), 1, "{arguments:?}: {}", finished.err);
    finished.err
}

/// Whether all of `words` stand in `sentence`.
fn names(sentence: &str, words: &[&str]) {
    for word in words {
        assert!(sentence.contains(word), "{word}: {sentence}");
    }
}

#[test]
fn a_fit_without_a_recording_says_what_is_missing() {
    names(&refusal(&["fit"]), &["A file with a recording is missing"]);
    names(&refusal(&["fit", "--lang", "de"]), &["Es fehlt eine Datei mit einer Aufzeichnung"]);
    names(&refusal(&["completions"]), &["<SHELL> is missing", "fish"]);
}

#[test]
fn a_file_without_a_command_is_told_its_command() {
    names(&refusal(&["r.csv"]), &["r.csv is a file", "federpendel fit r.csv"]);
    names(&refusal(&["r.csv", "--lang", "de"]), &["r.csv ist eine Datei", "federpendel fit r.csv"]);
    names(&refusal(&["s.csv"]), &["s.csv is no command"]);
    let workplace = Workplace::new();
    workplace.write("my.toml", b"");
    names(&workplace.run(&["my.toml"]).err, &["federpendel simulate my.toml"]);
}

#[test]
fn a_seed_is_a_whole_number() {
    for seed in ["abc", "-1", "1.5", "18446744073709551616"] {
        let asked = ["simulate", "--noise", "1mm", "--seed", seed, "-o", "z.csv"];
        let english = format!("--seed is “{seed}”; allowed is a whole number from 0");
        names(&refusal(&asked), &[&english]);
        let german = format!("--seed ist „{seed}“; erlaubt ist eine ganze Zahl von 0");
        names(&refusal(&[&asked[..], &["--lang", "de"]].concat()), &[&german]);
    }
}

#[test]
fn a_flag_is_no_value_of_another() {
    for flag in [
        "--from",
        "--to",
        "--sigma",
        "--mass",
        "--spring-mass",
        "--rate",
        "--unit",
        "--table",
        "--value",
        "--noise",
    ] {
        let command = if flag == "--noise" { "plan" } else { "fit" };
        names(&refusal(&[command, flag, "--details"]), &[flag, "has no value"]);
    }
}

#[test]
fn flags_of_a_fit_are_refused_by_their_names() {
    for (flag, value, allowed) in [
        ("--sigma", "0", "a length (m, "),
        ("--sigma", "1 kg", "an acceleration (m/s^2, "),
        ("--rate", "0 Hz", "a frequency (Hz, 1/s), a finite number greater than 0"),
        ("--from", "1 kg", "a time (s, "),
    ] {
        // The file is not read: it is none.
        names(&refusal(&["fit", "r.csv", flag, value]), &[flag, value, allowed]);
    }
    let reversed = ["fit", "r.csv", "--from", "5", "--to", "2"];
    names(&refusal(&reversed), &["--from is 5 s and --to is 2 s"]);
    names(
        &refusal(&[&reversed[..], &["--lang", "de"]].concat()),
        &["--from ist 5 s und --to ist 2 s"],
    );
    let noise = refusal(&["plan", "--noise", "0.01 g"]);
    names(&noise, &["a length (m, ", "a velocity (m/s, ", "an acceleration (m/s^2, "]);
    let velocity = refusal(&["plan", "--noise", "0.01 g", "--quantity", "velocity"]);
    assert!(velocity.contains("a velocity") && !velocity.contains("a length"), "{velocity}");
}

#[test]
fn a_bare_number_is_noted_and_a_vague_one_refused() {
    let vague = refusal(&["fit", "r.csv", "--mass", "250 ± 126 g"]);
    names(&vague, &["--mass", "250 ± 126 g", "more than half of the value"]);
    for (flag, written, said) in [
        ("--mass", "250±1", "--mass has no unit: 250 kg is taken."),
        ("--stiffness", "12.0", "--stiffness has no unit: 12 N/m is taken."),
        ("--spring-mass", "0.03(1)", "--spring-mass has no unit: 0.03 kg is taken."),
        ("--normal-force", "2", "--normal-force has no unit: 2 N is taken."),
    ] {
        let workplace = Workplace::new();
        names(&workplace.run(&["fit", "r.csv", flag, written]).err, &[said]);
    }
    let with_unit = Workplace::new().run(&["fit", "r.csv", "--mass", "250 ± 125 g"]);
    assert!(!with_unit.err.contains("no unit"), "{}", with_unit.err);
}
