//! Fits, in every form.

mod picture;
mod summary;

pub use picture::Picture;

use std::io;

use federpendel_report::html;
use federpendel_report::recording::{Fitted, document};
use federpendel_text::Catalogue;

use super::targets::Targets;
use super::{Format, json, plot, say_written, to_stdout, whole};
use crate::failure::Failure;

/// Writes fits to all targets: the files appear together and whole, then standard output.
pub(crate) fn write_fits(
    fits: &[Fitted],
    picture: Picture,
    targets: &Targets,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    let pictures = targets.has(Format::Svg) || targets.has(Format::Png);
    if pictures && fits.len() != 1 {
        let variables = [("count", fits.len().into())];
        return Err(Failure::Input(catalogue.format("fit-pictures-of-one", &variables)));
    }
    whole::write(&targets.files, catalogue, |format, out| match (format, fits) {
        (Format::Svg | Format::Png, [fit]) => {
            plot::write(&picture.plot(fit, catalogue), format, targets.background, out)
        }
        (Format::Html, _) => {
            // Only a mistake in the catalogue or the template can fail here, which tests have found.
            let page = html::page(&document(fits, catalogue), catalogue);
            out.write_all(page.map_err(io::Error::other)?.as_bytes())
        }
        (Format::Json, _) => json::write_fits(fits, catalogue, out),
        _ => Err(io::ErrorKind::Unsupported.into()),
    })?;
    say_written(targets, catalogue);
    to_stdout(
        |out| match targets.stdout {
            Format::Json => json::write_fits(fits, catalogue, out),
            _ => fits
                .iter()
                .try_for_each(|fit| summary::write(fit, picture, targets, catalogue, out)),
        },
        catalogue,
    )
}
