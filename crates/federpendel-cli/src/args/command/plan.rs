//! `plan` described to clap.

use clap::{Arg, Command};
use federpendel_text::Catalogue;

use super::{about_an_experiment, choice, common, named, usage, with_file};
use crate::args::QUANTITIES;

pub(super) fn plan(catalogue: &Catalogue) -> Command {
    let command = Command::new("plan")
        .about(catalogue.text("cli-plan"))
        .override_usage(usage("plan", "[EXPERIMENT.toml]".to_owned(), catalogue))
        .after_help(with_file("cli-plan-examples", catalogue))
        .args(options(catalogue));
    common(about_an_experiment(command, catalogue), catalogue)
        // The rate says how many values there are.
        .mut_arg("samples", |samples| samples.hide(true))
}

fn options(catalogue: &Catalogue) -> [Arg; 6] {
    let heading = catalogue.text("cli-heading-options");
    let named = |name, value, help| named(name, value, help, catalogue);
    [
        named("noise", "cli-value-quantity", "cli-plan-noise"),
        named("rate", "cli-value-quantity", "cli-plan-rate"),
        choice("quantity", QUANTITIES.map(|(name, _)| name), catalogue)
            .help(catalogue.text("cli-plan-quantity")),
        named("min-amplitude", "cli-value-quantity", "cli-plan-min-amplitude"),
        named("max-amplitude", "cli-value-quantity", "cli-plan-max-amplitude"),
        named("laws", "cli-value-names", "cli-plan-laws"),
    ]
    .map(|arg| arg.help_heading(heading.clone()))
}
