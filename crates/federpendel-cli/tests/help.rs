//! Help and manual pages: complete, in the user's language, as wide as the terminal.

mod common;

use common::Workplace;
use federpendel_cli::experiment::Field;

#[test]
fn help_can_be_asked_for_in_every_way() {
    let workplace = Workplace::new();
    for (asked, plain) in [
        (&["help"][..], &["--help"][..]),
        (&["help", "simulate"], &["simulate", "--help"]),
        (&["--lang", "de", "help", "man"], &["man", "--help", "--lang", "de"]),
    ] {
        let (found, expected) = (workplace.run(asked), workplace.run(plain));
        assert_eq!((found.status, &found.out), (Some(0), &expected.out), "{asked:?}");
    }
    let bare = workplace.run(&[]);
    assert_eq!((bare.status, bare.out.as_str()), (Some(2), ""));
    assert_eq!(bare.err, workplace.run(&["--help"]).out);
}

#[test]
fn help_shows_a_whole_experiment_file() {
    for asked in [&["simulate", "--help"][..], &["man"]] {
        let text = Workplace::new().run(asked).out;
        // The manual page escapes hyphens, which keys have none of.
        for key in Field::ALL.iter().flat_map(|field| field.path().split('.')) {
            assert!(text.contains(key), "{asked:?} lacks {key}");
        }
    }
}

#[test]
fn help_is_as_wide_as_the_terminal_within_limits() {
    let widest = |columns: &str| {
        let mut command = assert_cmd::Command::cargo_bin("federpendel").expect("the program");
        let command = command.args(["simulate", "--help", "--lang", "de"]).env("COLUMNS", columns);
        let out = String::from_utf8(command.output().expect("a run").stdout).expect("UTF-8");
        let prose = out.split("Beispiele:").next().unwrap_or_default().to_owned();
        prose.lines().map(|line| line.chars().count()).max().unwrap_or(0)
    };
    assert!((50..=60).contains(&widest("60")), "{}", widest("60"));
    assert!((90..=100).contains(&widest("300")), "{}", widest("300"));
    assert_eq!(widest("10"), widest("40"));
}

#[test]
fn the_manual_speaks_german_and_keeps_its_examples_in_lines() {
    let text = Workplace::new().run(&["man", "--lang", "de"]).out;
    for title in ["BEZEICHNUNG", "ÜBERSICHT", "BESCHREIBUNG", "BEISPIELE"] {
        assert!(text.contains(&format!("\n.SH {title}\n")), "{title}: {text}");
    }
    assert!(!text.contains(".SH EXTRA") && !text.contains(".SH NAME"), "{text}");
    let unfilled = text.split(".nf\n").nth(1).and_then(|rest| rest.split(".fi").next());
    assert!(unfilled.is_some_and(|lines| lines.starts_with("  federpendel simulate\n")), "{text}");
    assert_eq!(text.matches("\n.nf\n").count(), text.matches("\n.fi\n").count());
}
