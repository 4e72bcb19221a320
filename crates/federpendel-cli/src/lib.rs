//! The command line of federpendel, as a library so that its parsers can be tested and fuzzed.

pub mod args;
mod article;
mod beside;
mod compare;
mod comparison;
pub mod experiment;
mod failure;
mod fit;
mod load;
mod output;
mod plan;
mod progress;
mod record;
mod score;
mod sensor;
mod serve;
mod simulate;
pub mod words;

pub use federpendel_quantity as quantity;

use std::ffi::OsString;
use std::process::ExitCode;

use federpendel_text::Catalogue;

use args::Request;
use failure::Failure;

/// Runs the program on its arguments, the program's own name first.
pub fn run(arguments: &[OsString]) -> ExitCode {
    let catalogue = Catalogue::new(args::language(arguments, |name| std::env::var(name).ok()));
    let performed =
        args::parse(arguments, &catalogue).and_then(|request| perform(&request, &catalogue));
    match performed {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(&catalogue),
    }
}

fn perform(request: &Request, catalogue: &Catalogue) -> Result<(), Failure> {
    match request {
        Request::Simulate(arguments) => simulate::run(arguments, catalogue),
        Request::Compare(arguments) => compare::run(arguments, catalogue),
        Request::Article(arguments) => article::run(arguments, catalogue),
        Request::Fit(arguments) => fit::run(arguments, catalogue),
        Request::Plan(arguments) => plan::run(arguments, catalogue),
        Request::Score(arguments) => score::run(arguments, catalogue),
        Request::Serve(arguments) => serve::run(arguments, catalogue),
        Request::Completions(shell) => args::completions(*shell, catalogue),
        Request::Man => args::man(catalogue),
        Request::Print(text) => output::to_stdout(|out| out.write_all(text.as_bytes()), catalogue),
    }
}
