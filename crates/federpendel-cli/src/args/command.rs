//! The command line described to clap, in the user's language.

mod article;
mod beside;
mod fit;
mod generate;
mod plan;
mod score;
mod serve;

use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::builder::styling::{AnsiColor, Styles};
use clap::{Arg, ArgAction, Command, value_parser};
use federpendel::parameter::{self, ParameterInfo};
use federpendel_text::{Catalogue, Language};

use super::{ComparisonPicture, DARK, Dialect, Format, LIGHT, Method, MotionPicture};
use crate::comparison::Candidate;
use crate::experiment::{EXAMPLE, Field};

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// Narrowest and widest help text, columns.
const HELP_WIDTHS: (usize, usize) = (40, 100);

/// The whole command line.
pub(super) fn command(catalogue: &Catalogue) -> Command {
    Command::new("federpendel")
        .version(env!("CARGO_PKG_VERSION"))
        .about(catalogue.text("cli-about"))
        .after_help(catalogue.text("cli-examples"))
        .override_usage(usage("", catalogue.text("cli-value-command"), catalogue))
        .subcommand_value_name(catalogue.text("cli-value-command"))
        .subcommand_help_heading(catalogue.text("cli-heading-commands"))
        .subcommand_required(true)
        .disable_help_subcommand(true)
        .disable_version_flag(true)
        .arg(
            Arg::new("version")
                .long("version")
                .short('V')
                .action(ArgAction::Version)
                .help_heading(catalogue.text("cli-heading-options"))
                .help(catalogue.text("cli-version")),
        )
        .subcommand(simulate(catalogue))
        .subcommand(compare(catalogue))
        .subcommand(article::article(catalogue))
        .subcommand(fit::fit(catalogue))
        .subcommand(plan::plan(catalogue))
        .subcommand(score::score(catalogue))
        .subcommand(serve::serve(catalogue))
        .subcommand(generate::completions(catalogue))
        .subcommand(generate::manual(catalogue))
        .styles(STYLES)
        .term_width(help_width())
        .help_template(template(catalogue))
        .disable_help_flag(true)
        .arg(help(catalogue))
        .arg(language(catalogue))
}

/// As wide as the terminal, or else as the environment says.
fn help_width() -> usize {
    let (least, most) = HELP_WIDTHS;
    let terminal = console::Term::stdout().size_checked().map(|(_, columns)| columns.into());
    let said = || std::env::var("COLUMNS").ok()?.trim().parse().ok();
    terminal.or_else(said).unwrap_or(most).clamp(least, most)
}

fn template(catalogue: &Catalogue) -> String {
    let usage = catalogue.text("cli-heading-usage");
    format!("{{about-with-newline}}\n{usage}: {{usage}}\n\n{{all-args}}{{after-help}}\n")
}

/// `federpendel simulate [OPTIONS] operands`.
fn usage(command: &str, operands: String, catalogue: &Catalogue) -> String {
    let options = catalogue.text("cli-value-options");
    let words = ["federpendel".to_owned(), command.to_owned(), format!("[{options}]"), operands];
    words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

/// What every subcommand has.
fn common(command: Command, catalogue: &Catalogue) -> Command {
    command.disable_help_flag(true).arg(help(catalogue)).help_template(template(catalogue))
}

fn help(catalogue: &Catalogue) -> Arg {
    Arg::new("help")
        .long("help")
        .short('h')
        .action(ArgAction::Help)
        .help_heading(catalogue.text("cli-heading-options"))
        .help(catalogue.text("cli-help"))
}

fn language(catalogue: &Catalogue) -> Arg {
    let tags = Language::ALL.map(Language::tag);
    Arg::new("lang")
        .long("lang")
        .value_name("LANG")
        .global(true)
        .value_parser(PossibleValuesParser::new(tags))
        .hide_possible_values(true)
        .help_heading(catalogue.text("cli-heading-options"))
        .help(catalogue.text("cli-lang"))
}

fn simulate(catalogue: &Catalogue) -> Command {
    let command = Command::new("simulate")
        .about(catalogue.text("cli-simulate"))
        .override_usage(usage("simulate", "[EXPERIMENT.toml]".to_owned(), catalogue))
        .after_help(with_file("cli-simulate-examples", catalogue))
        .args(method(catalogue))
        .args(noise(catalogue))
        .arg(picture(MotionPicture::ALL.map(MotionPicture::name), "cli-plot-motion", catalogue));
    common(about_an_experiment(command, catalogue), catalogue)
}

fn compare(catalogue: &Catalogue) -> Command {
    let command = Command::new("compare")
        .about(catalogue.text("cli-compare"))
        .override_usage(usage("compare", "[EXPERIMENT.toml]".to_owned(), catalogue))
        .after_help(with_file("cli-compare-examples", catalogue))
        .args(against(catalogue))
        .arg(picture(
            ComparisonPicture::ALL.map(ComparisonPicture::name),
            "cli-plot-comparison",
            catalogue,
        ));
    common(about_an_experiment(command, catalogue), catalogue)
}

/// The experiment and where results go: what `simulate`, `compare` and `plan` share.
fn about_an_experiment(command: Command, catalogue: &Catalogue) -> Command {
    experiment(command.args(output(catalogue)), catalogue)
}

/// The experiment and its overrides.
fn experiment(command: Command, catalogue: &Catalogue) -> Command {
    command
        .arg(
            Arg::new("experiment")
                .value_name("EXPERIMENT.toml")
                .value_parser(value_parser!(PathBuf))
                .help_heading(catalogue.text("cli-heading-arguments"))
                .help(catalogue.text("cli-experiment")),
        )
        .args(Field::ALL.iter().map(|field| {
            quantity(field.flag(), field.info(), catalogue)
                .help_heading(catalogue.text("cli-heading-overrides"))
        }))
}

/// Examples of calls, then what a file looks like.
fn with_file(examples: &str, catalogue: &Catalogue) -> String {
    let calls = catalogue.text(examples);
    let file: Vec<_> = EXAMPLE.lines().filter(|line| !line.is_empty()).collect();
    let file = file.join("\n  ");
    format!("{calls}\n\n{}\n\n  {file}", catalogue.text("cli-experiment-file"))
}

fn method(catalogue: &Catalogue) -> [Arg; 2] {
    let heading = catalogue.text("cli-heading-options");
    let methods = Method::ALL.map(Method::name).join(", ");
    [
        choice("method", Method::ALL.map(Method::name), catalogue)
            .help_heading(heading.clone())
            .help(catalogue.format("cli-method", &[("methods", methods.into())])),
        quantity("dt".to_owned(), &parameter::TIME_STEP, catalogue)
            .help_heading(heading)
            .help(catalogue.text("cli-dt")),
    ]
}

/// A sensor in place of the samples as they are.
fn noise(catalogue: &Catalogue) -> [Arg; 2] {
    let heading = catalogue.text("cli-heading-options");
    [
        Arg::new("noise")
            .long("noise")
            .value_name(catalogue.text("cli-value-quantity"))
            .allow_hyphen_values(true)
            .help(catalogue.text("cli-noise")),
        Arg::new("seed")
            .long("seed")
            .value_name(catalogue.text("cli-value-number"))
            // “-1” is a bad seed, not an unknown flag.
            .allow_negative_numbers(true)
            // The only value that clap reads as a number: its refusal stands for that of a seed.
            .value_parser(value_parser!(u64))
            .help(catalogue.text("cli-seed")),
    ]
    .map(|arg| arg.help_heading(heading.clone()))
}

/// Which methods, and how finely they integrate.
fn against(catalogue: &Catalogue) -> [Arg; 4] {
    let heading = catalogue.text("cli-heading-options");
    let names: Vec<_> = Candidate::all().into_iter().map(Candidate::name).collect();
    let fineness = |info: &ParameterInfo, help: &str| {
        quantity(info.name.to_owned(), info, catalogue).help(catalogue.text(help))
    };
    [
        Arg::new("against")
            .long("against")
            .value_name(catalogue.text("cli-value-names"))
            .help(catalogue.format("cli-against", &[("methods", names.join(", ").into())])),
        fineness(&parameter::TIME_STEP, "cli-compare-dt"),
        fineness(&parameter::TOLERANCE, "cli-tolerance"),
        fineness(&parameter::WIDTH, "cli-width"),
    ]
    .map(|arg| arg.help_heading(heading.clone()))
}

/// What pictures show.
fn picture<const N: usize>(names: [&'static str; N], help: &str, catalogue: &Catalogue) -> Arg {
    let list = [("plots", names.join(", ").into())];
    choice("plot", names, catalogue)
        .help_heading(catalogue.text("cli-heading-options"))
        .help(catalogue.format(help, &list))
}

fn output(catalogue: &Catalogue) -> [Arg; 5] {
    let heading = catalogue.text("cli-heading-options");
    [
        file(&Format::IN_FILES, "cli-output", catalogue),
        choice("format", Format::ON_STDOUT.map(Format::name), catalogue)
            .help(catalogue.text("cli-format")),
        choice("csv-dialect", Dialect::ALL.map(Dialect::name), catalogue)
            .help(catalogue.text("cli-csv-dialect")),
        choice("theme", [LIGHT, DARK], catalogue).help(catalogue.text("cli-theme")),
        details("cli-details", catalogue),
    ]
    .map(|arg| arg.help_heading(heading.clone()))
}

/// Files to write, in one of these forms.
fn file(forms: &[Format], help: &str, catalogue: &Catalogue) -> Arg {
    Arg::new("output")
        .long("output")
        .short('o')
        .value_name(catalogue.text("cli-value-file"))
        .action(ArgAction::Append)
        .value_parser(value_parser!(PathBuf))
        .help(catalogue.format(help, &[("forms", Format::extensions(forms).into())]))
}

fn details(help: &str, catalogue: &Catalogue) -> Arg {
    Arg::new("details").long("details").action(ArgAction::SetTrue).help(catalogue.text(help))
}

/// A flag that takes a value, "-5cm" included, with the sentences for its value and its help.
fn named(name: &'static str, value: &str, help: &str, catalogue: &Catalogue) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(catalogue.text(value))
        .allow_hyphen_values(true)
        .help(catalogue.text(help))
}

/// A flag with one of a few words; its help names them.
fn choice<const N: usize>(
    name: &'static str,
    words: [&'static str; N],
    catalogue: &Catalogue,
) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(catalogue.text("cli-value-name"))
        .value_parser(PossibleValuesParser::new(words))
        .hide_possible_values(true)
}

/// A flag that takes a quantity, "-5cm" included.
fn quantity(name: String, info: &ParameterInfo, catalogue: &Catalogue) -> Arg {
    let text = catalogue.parameter(info);
    let symbol = text.symbol;
    let unit = if text.unit.is_empty() { String::new() } else { format!(" [{}]", text.unit) };
    Arg::new(name.clone())
        .long(name)
        .value_name(catalogue.text("cli-value-quantity"))
        .allow_hyphen_values(true)
        .help(format!("{}, {symbol}{unit}", text.description))
}
