//! Fits, in every form.

mod summary;
mod verdict;

use std::io;

use federpendel_fit::read::Read;
use federpendel_fit::{FitReport, Quantity};
use federpendel_text::Catalogue;
use federpendel_text::plot::{Plot, RecordingData};

use super::targets::Targets;
use super::{Format, json, plot, say_written, to_stdout, whole};
use crate::failure::Failure;
pub(super) use verdict::sentences;

/// A recording and its fit.
pub(crate) struct Fitted {
    /// What it is called.
    pub name: String,
    /// The recording, and where it comes from.
    pub read: Read,
    /// What was found.
    pub report: FitReport,
    /// What the fit says at the values of the window.
    pub curve: Vec<f64>,
}

impl Fitted {
    pub(crate) fn new(name: String, read: Read, report: FitReport) -> Self {
        let window = report.window.first..report.window.end;
        let values = &read.recording.values[window];
        // The residuals are value minus model.
        let curve =
            values.iter().zip(&report.residuals).map(|(value, left)| value - left).collect();
        Fitted { name, read, report, curve }
    }

    /// The unit of lengths that belongs to what was recorded.
    pub(super) fn length_unit(&self) -> String {
        let unit = &self.report.unit;
        let suffix = match self.report.quantity {
            Quantity::Position => "",
            Quantity::Velocity => "/s",
            Quantity::Acceleration => "/s^2",
        };
        match (unit.strip_suffix(suffix), unit.is_empty()) {
            (_, true) => "1".to_owned(),
            (Some(length), _) => length.to_owned(),
            // A unit of the recording's own, as volts of a sensor of velocity.
            (None, _) => format!("{unit}·{}", suffix.trim_start_matches('/')),
        }
    }

    /// The unit of a parameter.
    pub(super) fn unit(&self, parameter: &str) -> String {
        let length = self.length_unit();
        let per = |divisor: &str| format!("{length}/{divisor}");
        match parameter {
            "coulomb_acceleration" | "static_acceleration" => per("s^2"),
            // A pure number stays one.
            "newton_rate" if length == "1" => length,
            "newton_rate" => format!("1/{length}"),
            "position0" => length,
            "velocity0" => per("s"),
            "equilibrium" => self.report.unit.clone(),
            _ => "1/s".to_owned(),
        }
    }

    fn plots(&self, catalogue: &Catalogue) -> [Plot; 2] {
        let (id, symbol) = match self.report.quantity {
            Quantity::Position => ("fit-quantity-position", "x"),
            Quantity::Velocity => ("fit-quantity-velocity", "v"),
            Quantity::Acceleration => ("fit-quantity-acceleration", "a"),
        };
        let quantity = catalogue.text(id);
        let variables =
            [("name", self.name.as_str().into()), ("quantity", quantity.as_str().into())];
        let title = catalogue.format("fit-title", &variables);
        let data = RecordingData {
            title: &title,
            quantity: &quantity,
            symbol,
            unit: &self.report.unit,
            times: &self.read.recording.times,
            values: &self.read.recording.values,
            first: self.report.window.first,
            fitted: &self.curve,
        };
        [Plot::recording(catalogue, &data), Plot::residuals(catalogue, &data)]
    }
}

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
