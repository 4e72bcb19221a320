//! A recording with its fit.

use federpendel_fit::read::Read;
use federpendel_fit::{Edge, FitReport, Given, Physical, Quantity, physical};
use federpendel_text::Catalogue;
use federpendel_text::plot::{Plot, RecordingData};

use super::note::read_note;

/// Swings that gain more than this share of their amplitude grow.
const GROWTH: f64 = 0.05;

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

    /// What was assumed, left out and put in order in reading it.
    pub fn notes(&self, catalogue: &Catalogue) -> Vec<String> {
        self.read.notes.iter().map(|note| read_note(catalogue, note)).collect()
    }

    /// Whether the swings of the fitted part grow: most of them gain amplitude, and all together more than noise would make
    /// of it. Where it is too short for one, those before it tell.
    pub fn grows(&self) -> bool {
        let (swings, _) = self.report.swings(&self.read.recording, usize::MAX);
        let Some(first) = swings.first() else { return self.report.window.begins == Edge::Driven };
        let gaining = swings.iter().filter(|swing| swing.loss < 0.0).count();
        let gained: f64 = swings.iter().map(|swing| -swing.loss).sum();
        3 * gaining > 2 * swings.len() && gained > GROWTH * first.amplitude
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
