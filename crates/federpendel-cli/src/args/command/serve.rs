//! `serve` described to clap.

use clap::{Arg, ArgAction, Command};
use federpendel_text::Catalogue;

use super::{common, usage};

pub(super) fn serve(catalogue: &Catalogue) -> Command {
    let options = catalogue.text("cli-heading-options");
    let arguments = [
        Arg::new("port")
            .long("port")
            .value_name(catalogue.text("cli-value-number"))
            .allow_hyphen_values(true)
            .help(catalogue.text("cli-serve-port")),
        Arg::new("no-open")
            .long("no-open")
            .action(ArgAction::SetTrue)
            .help(catalogue.text("cli-serve-no-open")),
    ];
    let command = Command::new("serve")
        .about(catalogue.text("cli-serve"))
        .override_usage(usage("serve", String::new(), catalogue))
        .after_help(catalogue.text("cli-serve-examples"))
        .args(arguments.map(|arg| arg.help_heading(options.clone())));
    common(command, catalogue)
}
