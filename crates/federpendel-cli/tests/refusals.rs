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
fn a_seed_is_a_whole_number() {
    for seed in ["abc", "-1", "1.5", "18446744073709551616"] {
        let asked = ["simulate", "--noise", "1mm", "--seed", seed, "-o", "z.csv"];
        let english = format!("--seed is “{seed}”; allowed is a whole number from 0");
        names(&refusal(&asked), &[&english]);
        let german = format!("--seed ist „{seed}“; erlaubt ist eine ganze Zahl von 0");
        names(&refusal(&[&asked[..], &["--lang", "de"]].concat()), &[&german]);
    }
}
