//! A first screen of the report: one picture, one sentence, the claims that do not hold.

use std::io::{self, Write};

use console::style;
use federpendel_report::article::{check_claim, picture, result};
use federpendel_report::{Verdict, plain};
use federpendel_text::Catalogue;

use super::super::plot::write_terminal;
use super::super::summary::{Table, room, wrap};
use super::super::targets::Targets;
use super::ArticleReport;

/// Rows besides the picture.
const ROWS_BESIDES: usize = 12;

/// Fewest rows of the picture.
const FEWEST_ROWS: usize = 14;

pub(super) fn write(
    report: &ArticleReport<'_>,
    targets: &Targets,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let (columns, rows) = room(ROWS_BESIDES);
    let plot = picture(report.laboratory, catalogue).map_err(io::Error::other)?;
    write_terminal(&plot, (columns, rows.max(FEWEST_ROWS)), out)?;
    for line in wrap(&result(report.checks, catalogue), columns) {
        writeln!(out, "{line}")?;
    }
    writeln!(out)?;
    if targets.details {
        return details(report, columns, catalogue, out);
    }
    verdicts(report, catalogue).write(columns, out)?;
    if targets.files.is_empty() {
        writeln!(out)?;
        for line in wrap(&catalogue.text("article-hint"), columns) {
            writeln!(out, "{}", style(line).dim())?;
        }
    }
    Ok(())
}

/// Numbers in order, runs of them as ranges: “8 24–26 32”.
fn ranges(numbers: &[usize]) -> String {
    let runs = numbers.chunk_by(|a, b| a + 1 == *b);
    let written = runs.map(|run| match run {
        [first, .., last] if run.len() > 2 => format!("{first}–{last}"),
        _ => run.iter().map(usize::to_string).collect::<Vec<_>>().join(" "),
    });
    written.collect::<Vec<_>>().join(" ")
}

/// The numbers of the claims of each verdict.
fn verdicts<'a>(report: &ArticleReport<'_>, catalogue: &'a Catalogue) -> Table<'a> {
    let mut table = Table::new(catalogue);
    for verdict in [Verdict::Fails, Verdict::HoldsHere, Verdict::NotApplicable] {
        let of_it = report.checks.all().filter(|check| check.verdict == verdict);
        let numbers: Vec<usize> = of_it.map(|check| check.number).collect();
        if !numbers.is_empty() {
            table.row(&format!("report-verdict-{}", verdict.name()), ranges(&numbers));
        }
    }
    table
}

/// Every claim with its numbers.
fn details(
    report: &ArticleReport<'_>,
    columns: usize,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    for check in report.checks.all() {
        let claim = check_claim(check, catalogue);
        let place =
            if claim.equation.is_empty() { String::new() } else { format!("{} ", claim.equation) };
        let verdict = catalogue.text(&format!("report-verdict-{}", check.verdict.name()));
        let head = format!("{}. {place}{}", claim.number, plain::text(&claim.claim));
        for line in wrap(&head, columns) {
            writeln!(out, "{line}")?;
        }
        let mut table = Table::new(catalogue);
        table.row("report-computed", plain::text(&claim.computed.join("; ")));
        table.row("report-expected", plain::text(&claim.expected.join("; ")));
        table.row("report-verdict", verdict);
        if let Some(finding) = &claim.finding {
            table.row("report-finding", plain::text(finding));
        }
        table.write(columns, out)?;
        writeln!(out)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_numbers_are_ranges() {
        assert_eq!(ranges(&[8, 24, 25, 26, 32, 36, 37]), "8 24–26 32 36 37");
        assert_eq!(ranges(&[]), "");
    }
}
