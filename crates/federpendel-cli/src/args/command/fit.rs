//! The command `fit`.

use std::path::PathBuf;

use clap::{Arg, Command, value_parser};
use federpendel_text::Catalogue;

use super::{beside, choice, common, details, file, named, picture, usage};
use crate::args::{DARK, FitPicture, LIGHT, QUANTITIES};
use crate::fit::{INTERVALS, LOSSES};
use crate::output::{Dialect, Format};

pub(super) fn fit(catalogue: &Catalogue) -> Command {
    let command = Command::new("fit")
        .about(catalogue.text("cli-fit"))
        .override_usage(usage("fit", catalogue.text("cli-value-recordings"), catalogue))
        .after_help(catalogue.text("cli-fit-examples"))
        .arg(
            Arg::new("recordings")
                .value_name(catalogue.text("cli-value-recordings"))
                .required(true)
                .num_args(1..)
                .value_parser(value_parser!(PathBuf))
                .help_heading(catalogue.text("cli-heading-arguments"))
                .help(catalogue.text("cli-fit-recordings")),
        )
        .args(options(catalogue))
        .args(beside::arguments(catalogue));
    common(command, catalogue)
}

fn options(catalogue: &Catalogue) -> Vec<Arg> {
    let heading = catalogue.text("cli-heading-options");
    let named = |name, value, help| named(name, value, help, catalogue);
    let arguments = vec![
        named("time", "cli-value-column", "cli-fit-time"),
        named("value", "cli-value-column", "cli-fit-value"),
        choice("quantity", QUANTITIES.map(|(name, _)| name), catalogue)
            .help(catalogue.text("cli-fit-quantity")),
        named("unit", "cli-value-unit", "cli-fit-unit"),
        named("rate", "cli-value-quantity", "cli-fit-rate"),
        named("run", "cli-value-name", "cli-fit-run"),
        named("table", "cli-value-name", "cli-fit-table"),
        named("laws", "cli-value-names", "cli-fit-laws"),
        named("from", "cli-value-quantity", "cli-fit-from"),
        named("to", "cli-value-quantity", "cli-fit-to"),
        named("sigma", "cli-value-number", "cli-fit-sigma"),
        file(&Format::OF_FITS, "cli-fit-output", catalogue),
        choice("format", Format::ON_STDOUT.map(Format::name), catalogue)
            .help(catalogue.text("cli-fit-format")),
        choice("intervals", INTERVALS.map(|(name, _)| name), catalogue)
            .help(catalogue.text("cli-fit-intervals")),
        choice("loss", LOSSES.map(|(name, _)| name), catalogue)
            .help(catalogue.text("cli-fit-loss")),
        choice("csv-dialect", Dialect::ALL.map(Dialect::name), catalogue)
            .help(catalogue.text("cli-csv-dialect")),
        choice("theme", [LIGHT, DARK], catalogue).help(catalogue.text("cli-theme")),
        picture(FitPicture::ALL.map(FitPicture::name), "cli-plot-fit", catalogue),
        details("cli-details", catalogue),
    ];
    arguments.into_iter().map(|arg| arg.help_heading(heading.clone())).collect()
}
