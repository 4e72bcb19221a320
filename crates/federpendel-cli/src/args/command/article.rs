//! The command `article`.

use clap::{Arg, ArgAction, Command};
use federpendel_text::Catalogue;

use super::{choice, common, details, experiment, file, usage, with_file};
use crate::output::Format;

pub(super) fn article(catalogue: &Catalogue) -> Command {
    let command = Command::new("article")
        .about(catalogue.text("cli-article"))
        .override_usage(usage("article", "[EXPERIMENT.toml]".to_owned(), catalogue))
        .after_help(with_file("cli-article-examples", catalogue))
        .args(output(catalogue));
    common(experiment(command, catalogue), catalogue)
}

fn output(catalogue: &Catalogue) -> [Arg; 5] {
    let heading = catalogue.text("cli-heading-options");
    [
        file(&Format::OF_REPORTS, "cli-article-output", catalogue),
        choice("format", Format::REPORTS_ON_STDOUT.map(Format::name), catalogue)
            .help(catalogue.text("cli-article-format")),
        Arg::new("worksheet")
            .long("worksheet")
            .action(ArgAction::SetTrue)
            .help(catalogue.text("cli-article-worksheet")),
        Arg::new("claims")
            .long("claims")
            .value_name(catalogue.text("cli-value-numbers"))
            .help(catalogue.text("cli-article-claims")),
        details("cli-article-details", catalogue),
    ]
    .map(|arg| arg.help_heading(heading.clone()))
}
