//! `federpendel score`: the samples of any program held against a reference problem.

mod measure;
mod problem;
mod rest;
mod samples;

pub(crate) use measure::{Errors, Score};
pub(crate) use problem::Problem;
pub(crate) use rest::AfterRest;
pub(crate) use samples::{Column, Fault, LARGEST_FILE, LARGEST_NUMBER};

use std::path::Path;

use federpendel_text::{Catalogue, excerpt};

use crate::args::Score as Arguments;
use crate::failure::Failure;
use crate::load;
use crate::output::{self, to_stdout};
use crate::words::{nearest, samples_fault};
use samples::Samples;

pub(crate) fn run(arguments: &Arguments, catalogue: &Catalogue) -> Result<(), Failure> {
    let refuse = |id: &str| Failure::Input(catalogue.text(id));
    let lists = arguments.list.is_some() || arguments.times;
    if lists && (arguments.samples.is_some() || arguments.format.is_some()) {
        return Err(refuse("score-lists-alone"));
    }
    if let Some(part) = &arguments.list {
        if arguments.times || arguments.problem.is_some() {
            return Err(refuse("score-lists-alone"));
        }
        return list(part, catalogue);
    }
    let name = arguments.problem.as_deref().ok_or_else(|| refuse("score-no-problem"))?;
    let problem = named(name, catalogue)?;
    if arguments.times {
        return to_stdout(
            |out| problem.samples.iter().try_for_each(|stored| writeln!(out, "{}", stored.written)),
            catalogue,
        );
    }
    let path = arguments.samples.as_deref().ok_or_else(|| refuse("score-no-samples"))?;
    let score = score(problem, path, catalogue)?;
    output::write_score(&score, arguments.format, catalogue)
}

/// Reads the samples and holds them against the problem.
fn score<'a>(
    problem: Problem<'a>,
    path: &Path,
    catalogue: &Catalogue,
) -> Result<Score<'a>, Failure> {
    let file = crate::load::shown(path);
    let bytes = load::read(path, LARGEST_FILE, catalogue)?;
    let samples = Samples::read(&bytes)
        .map_err(|fault| Failure::Input(samples_fault(catalogue, &fault, &file)))?;
    Score::new(problem, &samples).map_err(|error| {
        let variables = [("file", file.into()), ("reason", catalogue.error(&error).into())];
        Failure::Input(catalogue.format("score-beyond", &variables))
    })
}

fn named(name: &str, catalogue: &Catalogue) -> Result<Problem<'static>, Failure> {
    let mut problems = Problem::all();
    if let Some(at) = problems.iter().position(|problem| problem.name == name) {
        return Ok(problems.swap_remove(at));
    }
    let written = ("name", excerpt(name).into());
    let near = nearest(name, problems.iter().map(|problem| problem.name));
    Err(Failure::Input(match near {
        None => catalogue.format("score-unknown-problem", &[written]),
        Some(near) => {
            catalogue.format("score-unknown-problem-near", &[written, ("nearest", near.into())])
        }
    }))
}

/// Prints the problems in which `part` stands: name, mix, description.
fn list(part: &str, catalogue: &Catalogue) -> Result<(), Failure> {
    let mut problems = Problem::all();
    problems.retain(|problem| problem.holds(part));
    let width = problems.iter().map(|problem| problem.name.len()).max();
    let Some(width) = width else {
        let variables = [("part", excerpt(part).into())];
        return Err(Failure::Input(catalogue.format("score-none-listed", &variables)));
    };
    let mixes = problems.iter().map(|problem| problem.mix.len()).max().unwrap_or(0);
    to_stdout(
        |out| {
            problems.iter().try_for_each(|problem| {
                let Problem { name, mix, description, .. } = problem;
                writeln!(out, "{name:width$}  {mix:mixes$}  {description}")
            })
        },
        catalogue,
    )
}
