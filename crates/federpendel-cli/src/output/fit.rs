//! Fits, in every form.

mod csv;
mod details;
mod names;
mod picture;
mod summary;

pub use picture::Picture;

use std::io::{self, Write};

use federpendel_report::html;
use federpendel_report::recording::document;
use federpendel_text::Catalogue;

use super::targets::Targets;
use super::{Format, json, plot, say_written, to_stdout, whole};
use crate::failure::Failure;
use crate::fit::Fits;
pub(super) use names::{law_names, quantity_name, stop_name};

/// Writes fits to all targets: the files appear together and whole, then standard output.
pub(crate) fn write_fits(
    fits: &Fits,
    picture: Picture,
    targets: &Targets,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    let pictures = targets.has(Format::Svg) || targets.has(Format::Png);
    if pictures && fits.fitted.len() != 1 {
        let variables = [("count", fits.fitted.len().into())];
        return Err(Failure::Input(catalogue.format("fit-pictures-of-one", &variables)));
    }
    let render =
        |format, out: &mut dyn Write| render(fits, format, (picture, targets), catalogue, out);
    whole::write(&targets.files, catalogue, render)?;
    say_written(targets, catalogue);
    to_stdout(|out| render(targets.stdout, out), catalogue)
}

fn render(
    fits: &Fits,
    format: Format,
    (picture, targets): (Picture, &Targets),
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    match (format, &fits.fitted[..]) {
        (Format::Svg | Format::Png, [fit]) => {
            plot::write(&picture.plot(fit, catalogue), format, targets.background, out)
        }
        (Format::Html, _) => {
            // Only a mistake in the catalogue or the template can fail here, which tests have found.
            let failed: Vec<_> = fits.failed.iter().map(|one| one.failure.sentence()).collect();
            let page = html::page(&document(&fits.fitted, &failed, catalogue), catalogue);
            out.write_all(page.map_err(io::Error::other)?.as_bytes())
        }
        (Format::Json, _) => json::write_fits(fits, catalogue, out),
        (Format::Csv, _) => csv::write(fits, targets.dialect, catalogue, out),
        (Format::Summary, [fit]) => summary::write(fit, picture, targets, catalogue, out),
        (Format::Summary, many) => summary::write_many(many, picture, targets, catalogue, out),
        _ => Err(io::ErrorKind::Unsupported.into()),
    }
}
