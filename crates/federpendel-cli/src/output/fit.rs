//! Fits, in every form.

mod csv;
mod details;
mod names;
mod summary;

use std::io::{self, Write};

use federpendel_text::Catalogue;

use super::targets::Targets;
use super::{Format, json, plot, say_written, to_stdout, whole};
use crate::failure::Failure;
use crate::fit::Fits;
pub(super) use names::{law_names, quantity_name, stop_name};

/// Writes fits to all targets: the files appear together and whole, then standard output.
pub(crate) fn write_fits(
    fits: &Fits,
    targets: &Targets,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    let pictures = targets.has(Format::Svg) || targets.has(Format::Png);
    if pictures && fits.fitted.len() != 1 {
        let variables = [("count", fits.fitted.len().into())];
        return Err(Failure::Input(catalogue.format("fit-pictures-of-one", &variables)));
    }
    let render = |format, out: &mut dyn Write| render(fits, format, targets, catalogue, out);
    whole::write(&targets.files, catalogue, render)?;
    say_written(targets, catalogue);
    to_stdout(|out| render(targets.stdout, out), catalogue)
}

fn render(
    fits: &Fits,
    format: Format,
    targets: &Targets,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    match (format, &fits.fitted[..]) {
        (Format::Svg | Format::Png, [fit]) => {
            let [mut plot, residuals] = fit.plots(catalogue);
            plot.lens = Some(Box::new(residuals));
            plot::write(&plot, format, targets.background, out)
        }
        (Format::Json, _) => json::write_fits(fits, catalogue, out),
        (Format::Csv, fitted) => csv::write(fitted, targets.dialect, catalogue, out),
        (Format::Summary, [fit]) => summary::write(fit, targets, catalogue, out),
        (Format::Summary, many) => {
            many.iter().try_for_each(|fit| summary::write_short(fit, targets, catalogue, out))
        }
        _ => Err(io::ErrorKind::Unsupported.into()),
    }
}
