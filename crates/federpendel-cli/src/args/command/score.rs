//! `score` described to clap.

use std::path::PathBuf;

use clap::{Arg, ArgAction, Command, value_parser};
use federpendel_text::Catalogue;

use super::{Format, choice, common, usage};

pub(super) fn score(catalogue: &Catalogue) -> Command {
    let options = catalogue.text("cli-heading-options");
    let command = Command::new("score")
        .about(catalogue.text("cli-score"))
        .override_usage(usage("score", "SAMPLES.csv --problem NAME".to_owned(), catalogue))
        .after_help(catalogue.text("cli-score-examples"))
        .arg(
            Arg::new("samples")
                .value_name("SAMPLES.csv")
                .value_parser(value_parser!(PathBuf))
                .help_heading(catalogue.text("cli-heading-arguments"))
                .help(catalogue.text("cli-score-samples")),
        )
        .args(arguments(catalogue).map(|arg| arg.help_heading(options.clone())));
    common(command, catalogue)
}

fn arguments(catalogue: &Catalogue) -> [Arg; 4] {
    [
        Arg::new("problem")
            .long("problem")
            .value_name(catalogue.text("cli-value-name"))
            .help(catalogue.text("cli-score-problem")),
        choice("format", [Format::Summary, Format::Json].map(Format::name), catalogue)
            .help(catalogue.text("cli-score-format")),
        Arg::new("list")
            .long("list")
            .value_name(catalogue.text("cli-value-text"))
            .num_args(0..=1)
            .default_missing_value("")
            .help(catalogue.text("cli-score-list")),
        Arg::new("times")
            .long("times")
            .action(ArgAction::SetTrue)
            .help(catalogue.text("cli-score-times")),
    ]
}
