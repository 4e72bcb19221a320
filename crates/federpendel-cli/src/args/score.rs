//! The arguments of `score`.

use std::path::PathBuf;

use clap::ArgMatches;

use super::{Format, text};

/// The arguments of `score`.
#[derive(Debug)]
pub struct Score {
    /// The file of samples, “-” for standard input.
    pub samples: Option<PathBuf>,
    /// The name of the problem.
    pub problem: Option<String>,
    /// What stands in the problems to list; empty for all; none for no list.
    pub list: Option<String>,
    /// Whether the stored times are asked for.
    pub times: bool,
    /// What standard output gets.
    pub format: Option<Format>,
}

impl Score {
    pub(super) fn new(matches: &ArgMatches) -> Self {
        Score {
            samples: matches.get_one::<PathBuf>("samples").cloned(),
            problem: text(matches, "problem"),
            list: text(matches, "list"),
            times: matches.get_flag("times"),
            format: text(matches, "format").and_then(|name| Format::named(&name)),
        }
    }
}
