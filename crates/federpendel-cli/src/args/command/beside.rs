//! What was measured beside a recording, described to clap.

use clap::{Arg, ArgAction};
use federpendel_text::Catalogue;

pub(super) fn arguments(catalogue: &Catalogue) -> [Arg; 6] {
    let quantity = |name: &'static str, help: &str| {
        Arg::new(name)
            .long(name)
            .value_name(catalogue.text("cli-value-quantity"))
            .allow_hyphen_values(true)
            .help(catalogue.text(help))
    };
    [
        quantity("mass", "physical-help-mass"),
        quantity("stiffness", "physical-help-stiffness"),
        quantity("spring-mass", "physical-help-spring-mass"),
        quantity("normal-force", "physical-help-normal-force"),
        Arg::new("horizontal")
            .long("horizontal")
            .action(ArgAction::SetTrue)
            .help(catalogue.text("physical-help-horizontal")),
        quantity("gravity", "physical-help-gravity"),
    ]
    .map(|arg| arg.help_heading(catalogue.text("physical-help-heading")))
}
