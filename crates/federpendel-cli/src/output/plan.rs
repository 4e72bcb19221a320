//! Plans, in every form.

mod summary;

use std::io::{self, Write};

use federpendel_fit::plan::{Plan, Row};
use federpendel_text::Catalogue;

use super::csv::{Dialect, table};
use super::{Format, Style, Targets, json, plot, say_written, to_stdout, whole};
use crate::failure::Failure;

/// Writes a plan to all targets: the files appear together and whole, then standard output.
pub(crate) fn write_plan(
    plan: &Plan,
    targets: &Targets,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    let Targets { dialect, details, background, .. } = *targets;
    let style = Style { catalogue, dialect, details, background };
    whole::write(&targets.files, catalogue, |format, out| render(plan, format, style, out))?;
    say_written(targets, catalogue);
    to_stdout(|out| render(plan, targets.stdout, style, out), catalogue)
}

fn render(plan: &Plan, format: Format, style: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
    let picture = || federpendel_report::plan::plot(style.catalogue, plan);
    match format {
        Format::Summary => summary::write(plan, &picture(), style, out),
        Format::Csv => csv(plan, style.dialect, out),
        Format::Json => json::write_plan(plan, style.catalogue, out),
        Format::Svg | Format::Png => plot::write(&picture(), format, style.background, out),
        Format::Html => Err(io::ErrorKind::Unsupported.into()),
    }
}

/// One row for each amplitude. What is not known is as unsure as can be: its significance is zero, its standard error
/// infinite.
fn csv(plan: &Plan, dialect: Dialect, out: &mut dyn Write) -> io::Result<()> {
    let mut header = vec!["Amplitude (m)".to_owned()];
    for law in plan.prospects.iter().map(|prospect| prospect.law) {
        let (name, unit) = (law.parameter(), law.unit());
        header.push(format!("{name} duration (s)"));
        header.push(format!("{name} stderr ({unit})"));
        header.push(format!("{name} significance"));
    }
    let row = |row: &Row| {
        let known =
            plan.prospects.iter().flat_map(|prospect| match row.laws[prospect.law as usize] {
                Some(known) => [known.duration, known.stderr, known.significance],
                None => [row.longest, f64::INFINITY, 0.0],
            });
        std::iter::once(row.amplitude).chain(known).collect::<Vec<_>>()
    };
    table(&header, plan.rows.iter().map(row), dialect, out)
}
