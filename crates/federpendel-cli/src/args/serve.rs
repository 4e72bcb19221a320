//! The arguments of `serve`.

use clap::ArgMatches;

use super::text;

/// The arguments of `serve`.
#[derive(Debug)]
pub struct Serve {
    /// The port, as written; none for any that is free.
    pub port: Option<String>,
    /// Whether the browser is opened.
    pub open: bool,
}

impl Serve {
    pub(super) fn new(matches: &ArgMatches) -> Self {
        Serve { port: text(matches, "port"), open: !matches.get_flag("no-open") }
    }
}
