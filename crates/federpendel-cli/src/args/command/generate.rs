//! `completions` and `man` described to clap.

use clap::{Arg, Command, value_parser};
use clap_complete::Shell;
use federpendel_text::Catalogue;

use super::{common, usage};

pub(super) fn completions(catalogue: &Catalogue) -> Command {
    let command = Command::new("completions")
        .about(catalogue.text("cli-completions"))
        .override_usage(usage("completions", "SHELL".to_owned(), catalogue))
        .after_help(catalogue.text("cli-completions-examples"))
        .arg(
            Arg::new("shell")
                .value_name("SHELL")
                .required(true)
                .value_parser(value_parser!(Shell))
                .hide_possible_values(true)
                .help_heading(catalogue.text("cli-heading-arguments"))
                .help(catalogue.text("cli-shell")),
        );
    common(command, catalogue)
}

pub(super) fn manual(catalogue: &Catalogue) -> Command {
    let command = Command::new("man")
        .about(catalogue.text("cli-man"))
        .override_usage(usage("man", String::new(), catalogue))
        .after_help(catalogue.text("cli-man-examples"));
    common(command, catalogue)
}
