//! Bad input: exit status 2, one message that names the field, its value and what is allowed, and
//! nothing written; status 1 for what the system refuses.

mod common;

use common::{Finished, Workplace};

/// Runs `simulate` with `arguments` and an output file; asserts that it is refused and leaves nothing.
fn refused(status: i32, arguments: &[&str], file: Option<&[u8]>) -> String {
    let workplace = Workplace::new();
    let mut words = vec!["simulate"];
    if let Some(file) = file {
        workplace.write("my.toml", file);
        words.push("my.toml");
    }
    words.extend(arguments);
    words.extend(["-o", "motion.csv", "-o", "motion.json"]);
    let Finished { status: found, out, err } = workplace.run(&words);
    assert_eq!((found, out.as_str()), (Some(status), ""), "{arguments:?}: {err}");
    assert_eq!(err.lines().count(), 1, "{err}");
    let left: Vec<_> = workplace.files().into_iter().filter(|name| name != "my.toml").collect();
    assert!(left.is_empty(), "{arguments:?} left {left:?}");
    err
}

fn flags_say(arguments: &[&str], parts: &[&str]) {
    let message = refused(2, arguments, None);
    for part in parts {
        assert!(message.contains(part), "{message:?} lacks {part:?}");
    }
}

fn file_says(file: &str, parts: &[&str]) {
    let message = refused(2, &[], Some(file.as_bytes()));
    for part in parts {
        assert!(message.contains(part), "{message:?} lacks {part:?}");
    }
}

/// A good file with one line more.
fn with(section: &str, line: &str) -> String {
    let good =
        "[oscillator]\nmass = 1\nstiffness = 1\n[friction]\n[release]\nposition = 1\n[record]\n";
    let section = format!("[{section}]\n");
    assert!(good.contains(&section));
    good.replace(&section, &format!("{section}{line}\n"))
}

#[test]
fn units_and_numbers() {
    flags_say(&["--mass", "250 m"], &["--mass", "“250 m”", "a length", "a mass (kg, g"]);
    flags_say(&["--mass", "5 kgg"], &["--mass", "“kgg”", "“kg”"]);
    flags_say(
        &["--mass", "1,000 kg"],
        &["--mass", "1 or 1000; write 1.0 (or 1,0) for the one, 1000 for"],
    );
    let readings = "4.905 or 4905; write 4.905 (or 4,9050) for the one, 4905 for the other";
    flags_say(&["--position", "4,905 mm"], &["“4,905 mm”", readings]);
    for (written, position) in
        [("4.905 mm", "0.004905"), ("4,9050 mm", "0.004905"), ("4905", "4905")]
    {
        let arguments = ["simulate", "--format", "csv", "--samples", "2", "--position", written];
        let out = Workplace::new().run(&arguments).out;
        assert!(out.contains(&format!("\n0,{position},")), "{out}");
    }
    flags_say(&["--stiffness", "12 N/M"], &["the unit “N/M” is unknown, the nearest is “N/m”"]);
    flags_say(&["--mass", "1.000,5 kg"], &["1000.5"]);
    for number in ["nan", "inf", "-inf", "1e400", "1e-400", "", "kg", "1 2 kg"] {
        flags_say(&["--mass", number], &["--mass", &format!("“{number}”"), "a mass"]);
    }
    file_says(
        &with("oscillator", "gravity = nan"),
        &["my.toml:2:", "oscillator.gravity is “nan”:"],
    );
    file_says(
        &with("release", "velocity = \"3 kg\""),
        &["my.toml:6:", "release.velocity", "a mass"],
    );
}

#[test]
fn ranges() {
    for flag in ["--mass", "--stiffness", "--duration"] {
        for value in ["0", "-1"] {
            flags_say(&[flag, value], &[flag, value, "greater than 0"]);
        }
    }
    for flag in ["--damping", "--kinetic", "--density", "--drag-coefficient", "--area"] {
        flags_say(&[flag, "-0.1"], &[flag, "-0.1", "0 or greater"]);
    }
    flags_say(&["--newton-coefficient", "-2 g/m"], &["--newton-coefficient", "0 or greater"]);
    for samples in ["0", "1", "-4", "2.5"] {
        flags_say(&["--samples", samples], &["--samples", samples, "whole number, 2 or greater"]);
    }
    flags_say(&["--samples", "1e15"], &["--samples", "1e15", "at most", "samples fit"]);
    let scheme = |step| ["--method", "article-scheme", "--dt", step];
    flags_say(&scheme("0"), &["--dt", "greater than 0"]);
    flags_say(&scheme("-1 ms"), &["--dt", "-1 ms", "greater than 0"]);
    flags_say(&scheme("3 m"), &["--dt", "3 m", "a length", "a time"]);
    flags_say(&["--dt", "1 ms"], &["--dt", "article-scheme"]);
}

#[test]
fn what_does_not_go_together() {
    flags_say(&["--static", "0.01"], &["--static", "0.01", "at least", "0.02"]);
    file_says(&with("friction", "coulomb = { static = 0.1 }"), &[":5:", "kinetic is missing"]);
    file_says(
        &with("friction", "newton = { density = 1, area = 1 }"),
        &["friction.newton.density", "friction.newton.drag_coefficient is missing"],
    );
    file_says(
        &with("friction", "newton = { density = 1, coefficient = 1 }"),
        &["friction.newton.density", "friction.newton.coefficient", "only one"],
    );
    flags_say(
        &["--area", "3 cm²"],
        &["--area is “3 cm²”", "--density, --drag-coefficient and --area, or --newton-coefficient"],
    );
    file_says(
        &with("friction", "newton = { area = 1 }"),
        &["needs density, drag_coefficient and area, or coefficient alone"],
    );
    flags_say(&["--gravity", "9.81", "--normal-force", "3"], &["--gravity", "--normal-force"]);
    file_says(
        &with("oscillator", "gravity = 1\nnormal_force = 2"),
        &["oscillator.gravity", "oscillator.normal_force", "only one"],
    );
    flags_say(&["--gravity", "0"], &["--gravity", "normal force greater than 0"]);
    flags_say(&["--normal-force", "0"], &["--normal-force", "normal force greater than 0"]);
    flags_say(&["--mass", "1e-307"], &["stiffness/mass"]);
    flags_say(&["--stiffness", "1e-300", "--mass", "1e300"], &["stiffness/mass"]);
    flags_say(&["--method", "article-printed", "--damping", "1"], &["article"]);
}

#[test]
fn unknown_words() {
    flags_say(&["--masss", "1"], &["--masss", "--mass?"]);
    flags_say(&["--format", "xml"], &["--format", "xml", "summary, csv, json"]);
    flags_say(&["--method", "articel-scheme"], &["“articel-scheme”", "article-scheme?"]);
    flags_say(&["--format", "jsn"], &["“jsn”; did you mean json?"]);
    flags_say(&["--csv-dialect", "germna"], &["german?"]);
    flags_say(&["other.toml", "more.toml"], &["“more.toml”", "only one experiment file is"]);
    for (command, near) in [("simulat", Some("simulate?")), ("Man", Some("man?")), ("run", None)] {
        let Finished { status, err, .. } = Workplace::new().run(&[command]);
        assert_eq!(status, Some(2));
        assert!(
            err.contains(near.unwrap_or(
                "simulate, compare, article, fit, plan, score, serve, completions, man"
            )),
            "{err}"
        );
    }
    flags_say(&["--lang", "fr"], &["--lang", "fr", "en, de"]);
    file_says(
        &with("oscillator", "mas = 1"),
        &["my.toml:2:", "oscillator.mas", "oscillator.mass?"],
    );
    file_says(&with("record", "[relase]"), &["relase", "release?", "oscillator, friction"]);
    file_says(&with("friction", "newten = 1"), &["friction.newten", "friction.newton?"]);
    file_says("mass = 1", &["oscillator.mass?"]);
}

#[test]
fn a_flag_is_no_value_of_the_flag_before_it() {
    for flag in ["--mass", "--position", "--samples"] {
        for next in ["--stiffness", "--", "-o", "-omotion.svg", "-h", "--help"] {
            flags_say(&[flag, next, "20"], &[&format!("error: {flag} has no value")]);
        }
    }
    flags_say(&["--method", "article-scheme", "--dt", "--details"], &["--dt has no value"]);
    flags_say(&["--position", "-5 kg"], &["--position", "“-5 kg”", "a mass"]);
    for position in ["-5cm", "-5 cm", "-.05", "-0,05 m"] {
        let workplace = Workplace::new();
        let finished =
            workplace.run(&["simulate", "--position", position, "--format", "csv", "--mass", "1"]);
        assert_eq!(finished.status, Some(0), "{}", finished.err);
        assert!(finished.out.contains("\n0,-0.05,0,"), "{}", finished.out);
    }
}

#[test]
fn odd_files() {
    for (file, part) in [
        (&b""[..], "empty"),
        (b"# nothing\r\n", "empty"),
        (b"[oscillator]\n# \xff", "UTF-8"),
        (b"[oscillator", "my.toml:1:"),
        (&[b' '; (1 << 20) + 1], "1048576"),
        (&[b"a=".as_slice(), &[b'['; 100_000]].concat(), "my.toml:1:"),
    ] {
        let message = refused(2, &[], Some(file));
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn files_that_are_not_toml() {
    let quotes = "must stand in quotes: mass = \"300 g\"";
    file_says(
        &with("oscillator", "mass = 300 g"),
        &["my.toml:2: mass = 300 g is not TOML", quotes],
    );
    file_says(
        &with("friction", "coulomb = { kinetic = 0,02 }"),
        &[":5: kinetic = 0,02 is", "\"0,02\""],
    );
    file_says(&with("oscillator", "mass = 2"), &["my.toml:3:", "mass stands twice"]);
    file_says(&with("record", "duration \"3 s\""), &["my.toml:8:", "“=” and a value"]);
    file_says("a = 1\na.b = 2", &["my.toml:2:", "(the reader says: cannot extend"]);
    for (line, part) in [
        ("mass = 300 g", ":2: mass = 300 g ist kein TOML; eine Zahl mit Einheit oder Dezimalkomma"),
        ("mass = 1", "mass steht zweimal da"),
        ("mass = \"300 g", "das schließende Anführungszeichen"),
        ("[oscillator", "fehlt die schließende Klammer; richtig wäre: [oscillator]"),
        ("mass = „250 g“", "nur gerade: mass = \"250 g\""),
        ("gravity =", "Hinter „=“ steht kein Wert"),
    ] {
        let file = with("oscillator", line);
        let message = refused(2, &["--lang", "de"], Some(file.as_bytes()));
        assert!(message.starts_with("Fehler: my.toml:") && message.contains(part), "{message}");
        assert!(!message.contains("expected"), "{message}");
    }
}

#[test]
fn outputs() {
    flags_say(&["-o", "motion.txt"], &["motion.txt", ".csv, .json, .svg, .png"]);
    flags_say(&["-o", "motion"], &["motion", ".csv"]);
    flags_say(&["-o", "./motion.csv"], &["motion.csv", "already"]);
    let workplace = Workplace::new();
    workplace.folder("folder.csv");
    let finished = workplace.run(&["simulate", "-o", "a.csv", "-o", "folder.csv"]);
    assert_eq!(finished.status, Some(2));
    assert!(finished.err.contains("“folder.csv” is a folder"), "{}", finished.err);
    assert_eq!(workplace.files(), ["folder.csv"]);
}

#[test]
fn what_the_system_refuses() {
    let message = refused(1, &["-o", "nowhere/motion.svg"], None);
    assert!(message.contains("“nowhere/motion.svg”: the folder “nowhere” is"), "{message}");
    let finished = Workplace::new().run(&["simulate", "nowhere.toml"]);
    assert_eq!(finished.status, Some(1));
    assert!(finished.err.contains("nowhere.toml"), "{}", finished.err);
}

#[test]
fn every_refusal_speaks_german_too() {
    for (arguments, part) in [
        (&["--mass", "250 m"][..], "eine Länge; erlaubt ist eine Masse"),
        (&["--masss", "1"], "war --mass gemeint?"),
        (&["--static", "0,01"], "--static ist „0,01“; erlaubt ist mindestens"),
        (&["--samples", "1e15"], "passen höchstens"),
        (&["-o", "motion.txt"], "--output „motion.txt“ hat eine unbekannte Dateiendung"),
    ] {
        let message = refused(2, &[&["--lang", "de"], arguments].concat(), None);
        assert!(message.starts_with("Fehler: ") && message.contains(part), "{message}");
    }
}

/// Where standard error takes nothing the exit status still tells, and results still come.
#[cfg(target_os = "linux")]
#[test]
fn a_standard_error_that_is_full_changes_nothing_else() {
    let full = || std::fs::File::options().write(true).open("/dev/full").expect("a full device");
    let program = assert_cmd::cargo::cargo_bin("federpendel");
    let run = |arguments: &[&str]| {
        let mut command = std::process::Command::new(&program);
        let folder = tempfile::tempdir().expect("a folder");
        command.current_dir(folder.path()).args(arguments).stderr(full()).output().expect("a run")
    };
    assert_eq!(run(&["simulate", "--mass", "0"]).status.code(), Some(2));
    let written = run(&["simulate", "-o", "motion.csv"]);
    assert_eq!(written.status.code(), Some(0));
    assert!(!written.stdout.is_empty());
}
