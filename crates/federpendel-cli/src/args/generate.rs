//! What clap can write about the command line: completions and a manual page.

use clap_complete::Shell;
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
    let mut pages = Vec::new();
    let rendered = clap_mangen::Man::new(whole.clone()).render(&mut pages);
    let rendered = rendered.and_then(|()| {
        let mut subcommands = whole.get_subcommands().cloned();
        subcommands.try_for_each(|subcommand| clap_mangen::Man::new(subcommand).render(&mut pages))
    });
    rendered.map_err(|error| Failure::system(catalogue, "man", &error))?;
    to_stdout(|out| out.write_all(&pages), catalogue)
}
