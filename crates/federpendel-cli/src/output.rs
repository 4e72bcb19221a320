//! Where results go, and in which form: one file of this folder for each.

mod article;
mod comparison;
mod csv;
mod fit;
mod json;
mod motion;
mod plan;
mod plot;
mod score;
mod summary;
mod targets;
mod whole;

pub(crate) use article::ArticleReport;
pub(crate) use comparison::ComparisonReport;
pub use comparison::Picture as ComparisonPicture;
pub use csv::Dialect;
pub use fit::Picture as FitPicture;
pub(crate) use fit::write_fits;
pub(crate) use motion::MotionReport;
pub use motion::Picture as MotionPicture;
pub(crate) use plan::write_plan;
pub(crate) use score::write_score;
pub(crate) use targets::Targets;

use std::io::{self, BufWriter, Write};

use federpendel_text::Catalogue;
use federpendel_text::plot::draw::Background;

use crate::failure::{Failure, note};
use crate::progress::Progress;
use crate::record::{MOST_POINTS, Record};

/// A form of output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// One plot, one sentence, a short table, for a person.
    Summary,
    /// A table of samples.
    Csv,
    /// Everything, for a program.
    Json,
    /// A picture that can be enlarged.
    Svg,
    /// A picture of pixels.
    Png,
    /// A page for a browser.
    Html,
}

impl Format {
    /// The forms that a file with a motion can have.
    pub const IN_FILES: [Format; 4] = [Format::Csv, Format::Json, Format::Svg, Format::Png];
    /// The forms that standard output can get.
    pub const ON_STDOUT: [Format; 3] = [Format::Summary, Format::Csv, Format::Json];
    /// The forms that a file with a report can have.
    pub const OF_REPORTS: [Format; 2] = [Format::Json, Format::Html];
    /// The forms that a file with fits can have.
    pub const OF_FITS: [Format; 5] =
        [Format::Json, Format::Html, Format::Csv, Format::Svg, Format::Png];
    /// The forms of a report on standard output.
    pub const REPORTS_ON_STDOUT: [Format; 2] = [Format::Summary, Format::Json];

    /// Its name on the command line, and the extension of its files.
    pub fn name(self) -> &'static str {
        match self {
            Format::Summary => "summary",
            Format::Csv => "csv",
            Format::Json => "json",
            Format::Svg => "svg",
            Format::Png => "png",
            Format::Html => "html",
        }
    }

    /// The extensions of files of these forms, for a person.
    pub fn extensions(forms: &[Format]) -> String {
        let names: Vec<_> = forms.iter().map(|format| format!(".{}", format.name())).collect();
        names.join(", ")
    }

    /// The form of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ON_STDOUT.into_iter().chain(Self::IN_FILES).find(|format| format.name() == name)
    }
}

/// What a form of output may depend on besides the record.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Style<'a> {
    catalogue: &'a Catalogue,
    dialect: Dialect,
    details: bool,
    background: Background,
}

/// Something that can be written in every form.
pub(crate) trait Report {
    /// The motion that it is about.
    fn record(&self) -> &Record;

    /// Writes it in one form.
    fn render(&self, format: Format, style: Style<'_>, out: &mut dyn Write) -> io::Result<()>;
}

/// Writes `report` to all targets: the files appear together and whole, then standard output.
pub(crate) fn write(
    report: &impl Report,
    targets: &Targets,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    guard_turning_points(report.record(), targets, catalogue)?;
    let Targets { dialect, details, background, .. } = *targets;
    let style = Style { catalogue, dialect, details, background };
    let progress = Progress::writing(catalogue);
    whole::write(&targets.files, catalogue, |format, out| report.render(format, style, out))?;
    drop(progress);
    say_written(targets, catalogue);
    to_stdout(|out| report.render(targets.stdout, style, out), catalogue)
}

/// Names the files that were written.
fn say_written(targets: &Targets, catalogue: &Catalogue) {
    for path in targets.files.iter().map(|(path, _)| crate::load::shown(path)) {
        note(&catalogue.format("cli-written", &[("name", path.into())]));
    }
}

/// JSON lists every turning point; a file that never ends helps nobody.
fn guard_turning_points(
    record: &Record,
    targets: &Targets,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    let forms = targets.files.iter().map(|(_, format)| *format).chain([targets.stdout]);
    let number = record.expected_turning_points();
    let lists_none = record.other.is_some() || number <= MOST_POINTS;
    if lists_none || forms.into_iter().all(|format| format != Format::Json) {
        return Ok(());
    }
    Err(Failure::Input(catalogue.format(
        "output-too-many-points",
        &[
            ("duration", catalogue.exact_quantity(record.duration, "s").into()),
            ("number", catalogue.number(number, 2).into()),
            ("limit", catalogue.number(MOST_POINTS, 2).into()),
        ],
    )))
}

/// Lets `write` write to standard output.
pub(crate) fn to_stdout(
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    write(&mut out)
        .and_then(|()| out.flush())
        .map_err(|error| Failure::system(catalogue, &catalogue.text("cli-stdout"), &error))
}
