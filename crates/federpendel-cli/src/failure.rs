//! How the program ends when it cannot do what was asked.

use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::builder::StyledStr;
use console::style;
use federpendel_text::Catalogue;

/// Why nothing, or no more, was written.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The input is bad; the sentence says what is allowed. Exit status 2.
    Input(String),
    /// The system refuses; the sentence says what. Exit status 1.
    System(String),
    /// Nothing is asked for; the help says what can be. Exit status 2.
    NoCommand(StyledStr),
    /// The reader of our output has seen enough. Quiet, and no failure to the shell.
    BrokenPipe,
}

/// Writes a line to standard error; where that is closed or full nobody is left to be told.
pub(crate) fn note(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// The system's own error within those that tell of a file of ours that is not to stay.
fn innermost(error: &io::Error) -> &io::Error {
    let mut found = error;
    let mut source = error.get_ref().map(|inner| inner as &dyn Error);
    while let Some(inner) = source {
        found = inner.downcast_ref().unwrap_or(found);
        source = inner.source();
    }
    found
}

impl Failure {
    /// A failure to read or write `name`.
    pub(crate) fn system(catalogue: &Catalogue, name: &str, error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Failure::BrokenPipe;
        }
        let error = innermost(error);
        let problem = match error.kind() {
            io::ErrorKind::NotFound => catalogue.text("cli-not-found"),
            io::ErrorKind::PermissionDenied => catalogue.text("cli-permission-denied"),
            io::ErrorKind::IsADirectory => catalogue.text("cli-is-a-folder"),
            io::ErrorKind::ReadOnlyFilesystem => catalogue.text("cli-read-only"),
            io::ErrorKind::StorageFull => catalogue.text("cli-storage-full"),
            io::ErrorKind::NotADirectory => catalogue.text("cli-is-no-folder"),
            io::ErrorKind::InvalidFilename => catalogue.text("cli-name-too-long"),
            // The system's own words, without the name of a file of ours that is not to stay.
            _ => match error.raw_os_error() {
                Some(code) => io::Error::from_raw_os_error(code).to_string(),
                None => error.to_string(),
            },
        };
        let variables = [("name", name.into()), ("problem", problem.into())];
        Failure::System(catalogue.format("cli-system-refuses", &variables))
    }

    /// Bad input to the core.
    pub(crate) fn core(catalogue: &Catalogue, error: &federpendel::Error) -> Self {
        Failure::Input(catalogue.error(error))
    }

    /// What it says.
    pub(crate) fn sentence(&self) -> String {
        match self {
            Failure::Input(sentence) | Failure::System(sentence) => sentence.clone(),
            Failure::NoCommand(_) | Failure::BrokenPipe => String::new(),
        }
    }

    /// Says it on standard error and gives the exit status.
    pub(crate) fn report(&self, catalogue: &Catalogue) -> ExitCode {
        let (sentence, status) = match self {
            Failure::Input(sentence) => (sentence, 2),
            Failure::System(sentence) => (sentence, 1),
            Failure::NoCommand(help) => {
                let colours = console::colors_enabled_stderr();
                let text = if colours { help.ansi().to_string() } else { help.to_string() };
                note(text.trim_end());
                return ExitCode::from(2);
            }
            Failure::BrokenPipe => return ExitCode::SUCCESS,
        };
        let label = style(catalogue.text("cli-error")).for_stderr().red().bold();
        note(&format!("{label}: {sentence}"));
        ExitCode::from(status)
    }
}
