//! `federpendel article`: parse, check the article's claims, export.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use federpendel_report::article::{Checks, Laboratory};
use federpendel_text::Catalogue;

use crate::args::{Article, Results};
use crate::failure::Failure;
use crate::load;
use crate::output::{ArticleReport, Format, Targets};

pub(crate) fn run(arguments: &Article, catalogue: &Catalogue) -> Result<(), Failure> {
    let results = with_solutions(arguments, catalogue);
    let targets = Targets::of(&arguments.subject, &results, &Format::OF_REPORTS, catalogue)?;
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

/// Where results go; behind each page of a worksheet the page with its solutions, so that what holds for files holds for
/// it too.
fn with_solutions(arguments: &Article, catalogue: &Catalogue) -> Results {
    let mut results = arguments.results.clone();
    if arguments.worksheet {
        let suffix = catalogue.text("article-solutions-file");
        let pair = |path: &PathBuf| {
            let page = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("html"));
            let solutions = page.then(|| beside(path, &suffix));
            [Some(path.clone()), solutions].into_iter().flatten()
        };
        results.outputs = results.outputs.iter().flat_map(pair).collect();
    }
    results
}

/// `folder/name.html` with `suffix` behind the name.
fn beside(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.file_stem().unwrap_or_default().to_os_string();
    name.push(suffix);
    if let Some(extension) = path.extension() {
        name.push(".");
        name.push(extension);
    }
    path.with_file_name(name)
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
