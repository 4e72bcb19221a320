//! A recording with its fit.

use federpendel_fit::read::Read;
use federpendel_fit::{FitReport, Given, Physical, Quantity, physical};
use federpendel_text::Catalogue;
use federpendel_text::plot::{Plot, RecordingData};

/// A recording and its fit.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// What it is called.
    pub name: String,
    /// The recording, and where it comes from.
    pub read: Read,
    /// What was found.
    pub report: FitReport,
    /// What the fit says at the values of the window.
    pub curve: Vec<f64>,
    /// What it says in physical numbers, if anything was measured beside it.
    pub physical: Option<Physical>,
}

impl Fitted {
    /// A recording called `name`, and its fit.
    pub fn new(name: String, read: Read, report: FitReport) -> Self {
        let window = report.window.first..report.window.end;
        let values = &read.recording.values[window];
        // The residuals are value minus model.
        let curve =
            values.iter().zip(&report.residuals).map(|(value, left)| value - left).collect();
        Fitted { name, read, report, curve, physical: None }
    }

    /// With the physical numbers that follow from what was measured beside it; none of a motion that no mix
    /// describes.
    pub fn beside(mut self, given: &Given) -> Self {
        if self.report.adequacy.adequate {
            self.physical = physical(&self.report, given, self.read.value.is_angle());
        }
        self
    }

    /// The recorded values with the fit over them, and what the fit leaves.
    pub fn plots(&self, catalogue: &Catalogue) -> [Plot; 2] {
        let (id, symbol) = match self.report.quantity {
            Quantity::Position => ("fit-quantity-position", "x"),
            Quantity::Velocity => ("fit-quantity-velocity", "v"),
            Quantity::Acceleration => ("fit-quantity-acceleration", "a"),
        };
        let quantity = catalogue.text(id);
        // Without its folders, which would fill the line.
        let name = self.name.rsplit(['/', '\\']).next().unwrap_or_default();
        let variables = [("name", name.into()), ("quantity", quantity.as_str().into())];
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
