//! clap's refusals in the user's language.

use std::ffi::OsString;
use std::path::Path;

use clap::ValueEnum;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap_complete::Shell;
use federpendel_text::Catalogue;

use crate::words::nearest;

/// The commands, as they are listed.
const COMMANDS: [&str; 9] =
    ["simulate", "compare", "article", "fit", "plan", "score", "serve", "completions", "man"];

/// Commands that take one file, each with the sentence that refuses a second one.
const SECOND_FILE: [(&str, &str); 5] = [
    ("simulate", "cli-second-file"),
    ("compare", "cli-second-file"),
    ("article", "cli-second-file"),
    ("plan", "cli-second-file"),
    ("score", "cli-second-samples"),
];

/// One sentence that names what is wrong with `arguments` and what is allowed.
pub(super) fn sentence(
    error: &clap::Error,
    arguments: &[OsString],
    catalogue: &Catalogue,
) -> String {
    // The command is the first word that is one: `man compare` is about `man`.
    let command = arguments.iter().find(|word| COMMANDS.iter().any(|command| *word == command));
    let takes_one = |(name, _): &&(&str, &str)| command.is_some_and(|command| command == name);
    let second_file = SECOND_FILE.iter().find(takes_one).map(|(_, id)| *id);
    let context = |kind| words(error.get(kind));
    let argument = flag_only(&context(ContextKind::InvalidArg));
    let value = context(ContextKind::InvalidValue);
    let say = |id: &str| {
        let variables = [
            ("argument", argument.as_str().into()),
            ("value", value.as_str().into()),
            ("allowed", allowed(error).into()),
        ];
        catalogue.format(id, &variables)
    };
    match error.kind() {
        ErrorKind::UnknownArgument if !argument.starts_with('-') && second_file.is_some() => {
            say(second_file.unwrap_or_default())
        }
        ErrorKind::UnknownArgument => match context(ContextKind::SuggestedArg) {
            near if near.is_empty() => say("cli-unknown-argument"),
            near => catalogue.format(
                "cli-unknown-argument-near",
                &[("argument", argument.as_str().into()), ("nearest", near.into())],
            ),
        },
        ErrorKind::InvalidSubcommand => {
            unknown_command(catalogue, &context(ContextKind::InvalidSubcommand))
        }
        ErrorKind::InvalidValue if value.is_empty() => say("cli-missing-value"),
        ErrorKind::InvalidValue => match nearest(&value, allowed(error).split(", ")) {
            None => say("cli-invalid-value"),
            Some(near) => catalogue.format(
                "cli-invalid-value-near",
                &[
                    ("argument", argument.as_str().into()),
                    ("value", value.as_str().into()),
                    ("nearest", near.into()),
                    ("allowed", allowed(error).into()),
                ],
            ),
        },
        ErrorKind::ArgumentConflict => say("cli-given-twice"),
        ErrorKind::MissingRequiredArgument if command.is_some_and(|command| command == "fit") => {
            catalogue.text("cli-missing-recording")
        }
        ErrorKind::MissingRequiredArgument => catalogue.format(
            "cli-missing-argument",
            &[("argument", argument.as_str().into()), ("allowed", shells().into())],
        ),
        ErrorKind::ValueValidation => say("cli-no-seed"),
        ErrorKind::TooManyValues => say("cli-no-value-allowed"),
        ErrorKind::InvalidUtf8 => catalogue.text("cli-argument-not-utf8"),
        _ => error.render().to_string().trim().trim_start_matches("error: ").to_owned(),
    }
}

fn unknown_command(catalogue: &Catalogue, word: &str) -> String {
    let file = Path::new(word);
    if file.is_file() {
        // An experiment is simulated, all else may be a recording.
        let experiment = file.extension().is_some_and(|extension| extension == "toml");
        let command = if experiment { "simulate" } else { "fit" };
        let variables = [("file", word.into()), ("command", command.into())];
        return catalogue.format("cli-file-without-command", &variables);
    }
    match nearest(word, COMMANDS) {
        None => catalogue.format(
            "cli-unknown-command",
            &[("argument", word.into()), ("allowed", COMMANDS.join(", ").into())],
        ),
        Some(near) => catalogue.format(
            "cli-unknown-command-near",
            &[("argument", word.into()), ("nearest", near.into())],
        ),
    }
}

fn words(value: Option<&ContextValue>) -> String {
    match value {
        Some(ContextValue::String(word)) => word.clone(),
        Some(ContextValue::Strings(words)) => words.join(", "),
        Some(other) => other.to_string(),
        None => String::new(),
    }
}

/// The words allowed for a value.
fn allowed(error: &clap::Error) -> String {
    words(error.get(ContextKind::ValidValue))
}

/// The shells; besides recordings theirs is the only argument that must be given.
fn shells() -> String {
    Shell::value_variants().iter().map(Shell::to_string).collect::<Vec<_>>().join(", ")
}

/// `--mass <QUANTITY>` without the name of its value.
fn flag_only(argument: &str) -> String {
    argument.split(" <").next().unwrap_or(argument).to_owned()
}
