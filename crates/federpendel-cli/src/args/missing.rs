//! Quantity flags without a value. clap lets a quantity begin with a hyphen, for “-5cm”, and so takes
//! the next flag for one.

use std::ffi::{OsStr, OsString};

use clap::Command;

use crate::experiment::Field;

/// The first quantity flag that another flag follows where its value should be.
pub(super) fn value(arguments: &[OsString], command: &Command) -> Option<String> {
    let shorts: Vec<char> = std::iter::once(command)
        .chain(command.get_subcommands())
        .flat_map(Command::get_arguments)
        .filter_map(clap::Arg::get_short)
        .collect();
    let mut words = arguments.iter().skip(1).map(OsString::as_os_str).peekable();
    while let Some(word) = words.next().filter(|word| *word != "--") {
        if !takes_quantity(word) {
            continue;
        }
        let next = words.next().and_then(OsStr::to_str).unwrap_or_default();
        let short = next.strip_prefix('-').and_then(|rest| rest.chars().next());
        if short.is_some_and(|short| short == '-' || shorts.contains(&short)) {
            return word.to_str().map(str::to_owned);
        }
    }
    None
}

fn takes_quantity(word: &OsStr) -> bool {
    let name = word.to_str().and_then(|word| word.strip_prefix("--"));
    let others = ["dt", "tolerance", "width", "noise", "rate", "min-amplitude", "max-amplitude"];
    name.is_some_and(|name| {
        others.contains(&name) || Field::ALL.iter().any(|field| field.flag() == name)
    })
}
