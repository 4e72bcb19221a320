//! Recordings: read, fitted, said in words.

use federpendel_fit::read::{Clock, Read, recordings};
use federpendel_fit::{Quantity, fit};
use federpendel_report::recording::{
    Fitted, about_rows, fit_error, parameter_rows, physical_rows, physical_sentences, read_note,
    residual_row, sections, sentences,
};
use federpendel_text::Catalogue;
use serde::Serialize;

use crate::asked::{Asked, Offer, Wanted, columns, refused_file};
use crate::decrement::Decrement;
use crate::{Experiment, Refusal, section, simulated};

/// Largest file that a page reads, bytes: it shares the browser's memory with everything else.
pub const LARGEST: usize = 100 << 20;

/// A fit, with what was read beside it.
#[derive(Debug)]
pub struct Recorded {
    fitted: Fitted,
    notes: Vec<String>,
}

/// A fit as the page shows it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Shown {
    /// What the recording is called.
    pub name: String,
    /// `position`, `velocity` or `acceleration`.
    pub quantity: &'static str,
    /// Unit of the values; empty where the file names none.
    pub unit: String,
    /// Number of the first value that was fitted.
    pub first: usize,
    /// Number of values that were fitted.
    pub count: usize,
    /// The verdict in sentences.
    pub sentences: Vec<String>,
    /// What was fitted and found, as names and values.
    pub rows: Vec<(String, String)>,
    /// How the file was read.
    pub notes: Vec<String>,
    /// What each swing costs, lengths in the unit of the recording.
    pub decrement: Decrement,
    /// Unit of those lengths.
    pub length: String,
    /// The motion that was fitted, as an experiment; none where no mix describes it or its lengths have no unit.
    pub experiment: Option<Experiment>,
    /// Why there is no experiment, if the reader can do something about it.
    pub no_experiment: Option<String>,
    /// Columns that may be the values.
    pub value_columns: Vec<Offer>,
    /// Columns that may be the times.
    pub time_columns: Vec<Offer>,
    /// The whole report, as HTML.
    pub report: String,
}

/// Reads a file and fits all recordings in it, as asked.
///
/// # Errors
/// Why a field or the file is refused, or why no recording in it can be fitted; what fails beside others stands in their
/// notes.
pub fn fits(
    bytes: &[u8],
    name: &str,
    asked: &Asked,
    catalogue: &Catalogue,
) -> Result<Vec<Recorded>, Refusal> {
    if bytes.len() > LARGEST {
        let limit = [("place", name.to_owned().into()), ("limit", LARGEST.to_string().into())];
        return Err(Refusal::new("file", catalogue.format("samples-too-large", &limit)));
    }
    let wanted = asked.read(catalogue)?;
    let reads =
        recordings(bytes, &wanted.choice).map_err(|error| refused_file(catalogue, &error, name))?;
    let (mut fitted, mut failed) = (Vec::new(), Vec::new());
    for read in reads {
        let name = match &read.run {
            Some(run) => format!("{name} ({run})"),
            None => name.to_owned(),
        };
        match recorded(read, name.clone(), &wanted, catalogue) {
            Ok(one) => fitted.push(one),
            Err(error) => failed.push(fit_error(catalogue, &error, &name)),
        }
    }
    match fitted.first_mut() {
        None => {
            let why = failed.into_iter().next().unwrap_or_default();
            Err(Refusal::new(asked.field_of_fit(), why))
        }
        Some(first) => {
            first.notes.extend(failed);
            Ok(fitted)
        }
    }
}

fn recorded(
    read: Read,
    name: String,
    wanted: &Wanted,
    catalogue: &Catalogue,
) -> Result<Recorded, federpendel_fit::FitError> {
    let notes = read.notes.iter().map(|note| read_note(catalogue, note)).collect();
    let report = fit(&read.recording, &wanted.options)?;
    let fitted = Fitted::new(name, read, report).beside(&wanted.given);
    Ok(Recorded { fitted, notes })
}

impl Recorded {
    /// The fit as the page shows it.
    pub fn shown(&self, catalogue: &Catalogue) -> Shown {
        let fit = &self.fitted;
        let report = &fit.report;
        let clock = match &fit.read.clock {
            Clock::Column(column) => Some(column),
            Clock::Rate(_) => None,
        };
        Shown {
            name: fit.name.clone(),
            quantity: match report.quantity {
                Quantity::Position => "position",
                Quantity::Velocity => "velocity",
                Quantity::Acceleration => "acceleration",
            },
            unit: report.unit.clone(),
            first: report.window.first,
            count: fit.curve.len(),
            sentences: [sentences(fit, catalogue), physical_sentences(fit, catalogue)].concat(),
            rows: rows(fit, catalogue),
            notes: self.notes.clone(),
            decrement: Decrement::shown(&fit.decrement(catalogue)),
            length: report.length_unit(),
            experiment: simulated::experiment(fit),
            no_experiment: simulated::absent(fit, catalogue),
            value_columns: columns(&fit.read, None),
            time_columns: columns(&fit.read, clock),
            report: section::html(&sections(fit, catalogue)),
        }
    }

    /// All times and values of the recording, then what the fit says and what it leaves in the part that was fitted, one
    /// behind the other.
    pub fn numbers(&self) -> Vec<f64> {
        let recording = &self.fitted.read.recording;
        let parts = [
            &recording.times,
            &recording.values,
            &self.fitted.curve,
            &self.fitted.report.residuals,
        ];
        parts.into_iter().flatten().copied().collect()
    }
}

/// What was fitted and found; of a motion that no mix describes the coefficients are not known.
fn rows(fit: &Fitted, catalogue: &Catalogue) -> Vec<(String, String)> {
    let mut rows = about_rows(fit, catalogue);
    if fit.report.adequacy.adequate {
        rows.extend(parameter_rows(fit, catalogue));
        rows.extend(physical_rows(fit, catalogue));
        rows.extend(residual_row(fit, catalogue));
        rows.push(["fit-row-plus-minus", "fit-plus-minus"].map(|id| catalogue.text(id)).into());
    }
    rows
}
