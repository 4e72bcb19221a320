//! Where a recording comes from: a file, standard input, a pipe with a name.

mod common;

use assert_cmd::Command;
use common::Workplace;

/// What a fit of this file writes, fed with these bytes.
fn fit(workplace: &Workplace, file: &str, bytes: &[u8]) -> (Option<i32>, String, String) {
    let mut command = Command::cargo_bin("federpendel").expect("the program");
    command.current_dir(workplace.path()).env("LC_ALL", "C").write_stdin(bytes);
    let output = command.args(["fit", file, "--format", "csv"]).output().expect("a run");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

/// All but the name of the file, which stands first.
fn without_name(table: &str) -> Vec<&str> {
    table.lines().filter_map(|line| Some(line.split_once(',')?.1)).collect()
}

#[test]
fn standard_input_reads_as_the_file_does() {
    let workplace = Workplace::new();
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/recordings/");
    for name in ["vernier.csv", "phyphox-deutsch.zip"] {
        let bytes = std::fs::read(examples.to_owned() + name).expect(name);
        workplace.write(name, &bytes);
        let (status, file, _) = fit(&workplace, name, b"");
        assert_eq!(status, Some(0), "{name}");
        assert!(file.lines().count() > 1, "{file}");
        let inputs = if cfg!(target_os = "linux") { &["-", "/dev/stdin"][..] } else { &["-"] };
        for input in inputs {
            let (status, table, error) = fit(&workplace, input, &bytes);
            assert_eq!((status, without_name(&table)), (Some(0), without_name(&file)), "{error}");
        }
    }
}

#[test]
fn what_the_system_does_not_read_is_said_and_is_no_bad_input() {
    let workplace = Workplace::new();
    workplace.folder("folder.csv");
    for (name, problem) in [("folder.csv", "this is a folder"), ("none.csv", "none.csv")] {
        let (status, table, error) = fit(&workplace, name, b"");
        assert_eq!((status, table.as_str()), (Some(1), ""), "{error}");
        assert!(error.contains(name) && error.contains(problem), "{error}");
    }
    let (status, table, error) = fit(&workplace, "-", b"");
    assert_eq!((status, table.as_str()), (Some(2), ""), "{error}");
}
