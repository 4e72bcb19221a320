//! `federpendel article`: parse, check the article's claims, export.

use std::collections::BTreeSet;

use federpendel_report::article::{Checks, Laboratory};
use federpendel_text::Catalogue;

use crate::args::Article;
use crate::failure::Failure;
use crate::load;
use crate::output::{ArticleReport, Format, Targets};

pub(crate) fn run(arguments: &Article, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets =
        Targets::check(&arguments.subject, &arguments.results, &Format::OF_REPORTS, catalogue)?;
    let pages = targets.has(Format::Html);
    for (asked, id) in [
        (arguments.worksheet, "cli-article-no-page"),
        (arguments.claims.is_some(), "cli-article-claims-without-page"),
    ] {
        if asked && !pages {
            return Err(Failure::Input(catalogue.text(id)));
        }
    }
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
    let claims = chosen(arguments.claims.as_deref(), checks.all().count(), catalogue)?;
    let report = ArticleReport {
        laboratory: &laboratory,
        checks: &checks,
        worksheet: arguments.worksheet,
        claims,
    };
    report.write(&targets, catalogue)
}

/// The numbers in a list like `43-47,54`; none for all of them.
fn chosen(
    written: Option<&str>,
    last: usize,
    catalogue: &Catalogue,
) -> Result<Option<BTreeSet<usize>>, Failure> {
    let Some(written) = written else { return Ok(None) };
    let number = |text: &str| text.trim().parse().ok().filter(|number| (1..=last).contains(number));
    let mut numbers = BTreeSet::new();
    for part in written.split(',') {
        let (from, until) = part.split_once(['-', '–']).unwrap_or((part, part));
        match (number(from), number(until)) {
            (Some(from), Some(until)) if from <= until => numbers.extend(from..=until),
            _ => {
                let variables = [("value", written.into()), ("last", last.into())];
                return Err(Failure::Input(catalogue.format("cli-article-no-claim", &variables)));
            }
        }
    }
    Ok(Some(numbers))
}
