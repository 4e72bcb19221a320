//! A folder of its own for each run of the program.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

/// An empty folder in which the program runs.
pub struct Workplace(TempDir);

/// What a run left behind.
#[allow(dead_code, reason = "each test file uses some")]
pub struct Finished {
    /// Exit status.
    pub status: Option<i32>,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

#[allow(dead_code, reason = "each test file uses some")]
impl Workplace {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn write(&self, name: &str, bytes: &[u8]) {
        fs::write(self.path().join(name), bytes).expect("a file");
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub fn folder(&self, name: &str) {
        fs::create_dir(self.path().join(name)).expect("a folder");
    }

    /// The names of all files, hidden ones included.
    pub fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path()).expect("the folder");
        let mut names: Vec<_> = entries
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    /// Runs the program in English, whatever the environment says.
    pub fn run(&self, arguments: &[&str]) -> Finished {
        let mut command = Command::cargo_bin("federpendel").expect("the program");
        for variable in ["LC_ALL", "LC_MESSAGES", "LANG", "LANGUAGE"] {
            command.env_remove(variable);
        }
        let output = command.current_dir(self.path()).args(arguments).output().expect("a run");
        Finished {
            status: output.status.code(),
            out: String::from_utf8_lossy(&output.stdout).into_owned(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

/// A JSON document that fits the schema of this name.
#[allow(dead_code, reason = "each test file uses some")]
pub fn document(text: &str, schema: &str) -> Value {
    let document: Value = serde_json::from_str(text).expect("JSON");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schemas").join(schema);
    let schema = serde_json::from_str(&fs::read_to_string(path).expect("a schema"));
    let schema = jsonschema::validator_for(&schema.expect("JSON")).expect("a schema");
    let problems: Vec<_> = schema.iter_errors(&document).map(|error| error.to_string()).collect();
    assert!(problems.is_empty(), "{problems:?}");
    document
}
