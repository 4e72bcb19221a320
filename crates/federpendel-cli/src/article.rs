//! `federpendel article`: parse, check the article's claims, export.

use federpendel_report::article::{Checks, Laboratory};
use federpendel_text::Catalogue;

use crate::args::Article;
use crate::failure::Failure;
use crate::load;
use crate::output::{ArticleReport, Format, Targets};

pub(crate) fn run(arguments: &Article, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets =
        Targets::check(&arguments.subject, &arguments.results, &Format::OF_REPORTS, catalogue)?;
    let experiment = load::experiment(&arguments.subject, 0, catalogue)?;
    let refused = |error| Failure::core(catalogue, &error);
    let laboratory = Laboratory::new(
        experiment.oscillator,
        experiment.normal_force,
        experiment.release,
        experiment.duration,
        experiment.drag_coefficient,
    );
    let laboratory = laboratory.map_err(refused)?;
    let checks = Checks::of(&laboratory).map_err(refused)?;
    let report =
        ArticleReport { laboratory: &laboratory, checks: &checks, worksheet: arguments.worksheet };
    report.write(&targets, catalogue)
}
