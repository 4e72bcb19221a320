//! Flags without a value. clap lets a quantity begin with a hyphen, for “-5cm”, and so takes the next flag for one.

use std::ffi::{OsStr, OsString};

use clap::{Arg, Command};

/// The first flag whose value may begin with a hyphen that another flag follows where its value should be.
pub(super) fn value(arguments: &[OsString], command: &Command) -> Option<String> {
    let commands = std::iter::once(command).chain(command.get_subcommands());
    let known: Vec<&Arg> = commands.flat_map(Command::get_arguments).collect();
    let shorts: Vec<char> = known.iter().filter_map(|arg| arg.get_short()).collect();
    let takes_any = |word: &OsStr| {
        let name = word.to_str().and_then(|word| word.strip_prefix("--"));
        let mut flags = known.iter().filter(|arg| arg.is_allow_hyphen_values_set());
        name.is_some() && flags.any(|arg| arg.get_long() == name)
    };
    let mut words = arguments.iter().skip(1).map(OsString::as_os_str).peekable();
    while let Some(word) = words.next().filter(|word| *word != "--") {
        if !takes_any(word) {
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
