//! Fits, in every form.

mod summary;

use std::io;

use federpendel_report::recording::Fitted;
use federpendel_text::Catalogue;

use super::targets::Targets;
use super::{Format, json, plot, say_written, to_stdout, whole};
use crate::failure::Failure;

/// Writes fits to all targets: the files appear together and whole, then standard output.
pub(crate) fn write_fits(
    fits: &[Fitted],
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
            let [mut plot, residuals] = fit.plots(catalogue);
            plot.lens = Some(Box::new(residuals));
            plot::write(&plot, format, targets.background, out)
        }
        (Format::Json, _) => json::write_fits(fits, catalogue, out),
        _ => Err(io::ErrorKind::Unsupported.into()),
    })?;
    say_written(targets, catalogue);
    to_stdout(
        |out| match targets.stdout {
            Format::Json => json::write_fits(fits, catalogue, out),
            _ => fits.iter().try_for_each(|fit| summary::write(fit, targets, catalogue, out)),
        },
        catalogue,
    )
}
