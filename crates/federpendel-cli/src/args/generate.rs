//! What clap can write about the command line: completions and a manual page.

use std::io;

use clap::Command;
use clap_complete::Shell;
use clap_mangen::roff::{Roff, roman};
use federpendel_text::Catalogue;

use super::command::command;
use crate::failure::Failure;
use crate::output::to_stdout;

/// Writes the completions for `shell` to standard output.
pub(crate) fn completions(shell: Shell, catalogue: &Catalogue) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command(catalogue), "federpendel", &mut script);
    to_stdout(|out| out.write_all(&script), catalogue)
}

/// Writes the manual pages of the program and of each subcommand to standard output.
pub(crate) fn man(catalogue: &Catalogue) -> Result<(), Failure> {
    let mut whole = command(catalogue);
    whole.build();
    let mut pages = String::new();
    for command in std::iter::once(&whole).chain(whole.get_subcommands()) {
        let rendered = page(command, catalogue);
        pages += &rendered.map_err(|error| Failure::system(catalogue, "man", &error))?;
    }
    to_stdout(|out| out.write_all(pages.as_bytes()), catalogue)
}

/// The page of one command. The titles of sections are English in `clap_mangen`, so they are
/// translated in what it wrote; its section of examples, which it fills, is written here instead.
fn page(command: &Command, catalogue: &Catalogue) -> io::Result<String> {
    let mut bytes = Vec::new();
    clap_mangen::Man::new(command.clone()).render(&mut bytes)?;
    let titles = [
        (".SH NAME", "man-name"),
        (".SH SYNOPSIS", "man-synopsis"),
        (".SH DESCRIPTION", "man-description"),
        (".SH VERSION", "man-version"),
    ];
    let mut text = String::new();
    let mut replaced = false;
    for line in String::from_utf8_lossy(&bytes).lines() {
        replaced = replaced && !line.starts_with(".SH ");
        if line == ".SH EXTRA" {
            let examples = command.get_after_help().map(ToString::to_string);
            text += &after(&examples.unwrap_or_default(), catalogue);
            replaced = true;
        } else if !replaced {
            let title = titles.iter().find(|(title, _)| *title == line);
            let translated = title.map(|(_, id)| format!(".SH {}", catalogue.text(id)));
            text += &translated.unwrap_or_else(|| line.to_owned());
            text.push('\n');
        }
    }
    Ok(text)
}

/// The section behind the options: sentences filled, indented lines as they are.
fn after(text: &str, catalogue: &Catalogue) -> String {
    let mut roff = Roff::new();
    roff.control("SH", [catalogue.text("man-extra").as_str()]);
    let mut filled = true;
    for line in text.lines() {
        let indented = line.starts_with("  ");
        if line.is_empty() {
            roff.control("PP", []);
        } else if indented == filled {
            roff.control(if indented { "nf" } else { "fi" }, []);
            filled = !indented;
        }
        if !line.is_empty() {
            roff.text([roman(line)]);
        }
    }
    if !filled {
        roff.control("fi", []);
    }
    roff.to_roff()
}
