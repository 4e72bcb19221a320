//! The arguments of `fit`.

use std::path::PathBuf;

use clap::ArgMatches;
use federpendel_fit::{Intervals, Loss, Quantity};

use super::beside::beside;
use super::{FitPicture, Results, results, text};
use crate::fit::{INTERVALS, LOSSES};
use crate::quantity::inputs::Beside;

/// What a recording can hold, by the names on the command line.
pub(crate) const QUANTITIES: [(&str, Quantity); 3] = [
    ("position", Quantity::Position),
    ("velocity", Quantity::Velocity),
    ("acceleration", Quantity::Acceleration),
];

/// The arguments of `fit`.
#[derive(Debug)]
pub struct Fit {
    /// Files with recordings.
    pub recordings: Vec<PathBuf>,
    /// The column of times, as written.
    pub time: Option<String>,
    /// The column of values, as written.
    pub value: Option<String>,
    /// What the values are.
    pub quantity: Option<Quantity>,
    /// The unit of the values, as written.
    pub unit: Option<String>,
    /// The rate of even times, as written.
    pub rate: Option<String>,
    /// The run, as written.
    pub run: Option<String>,
    /// The sheet of a workbook or the file of an archive, as written.
    pub table: Option<String>,
    /// The laws that may act, as written.
    pub laws: Option<String>,
    /// When the fitted part begins, as written.
    pub from: Option<String>,
    /// When it ends, as written.
    pub to: Option<String>,
    /// Standard deviation of a value, as written.
    pub sigma: Option<String>,
    /// How intervals are found.
    pub intervals: Intervals,
    /// How residuals count.
    pub loss: Loss,
    /// What was measured beside the recordings.
    pub beside: Beside,
    /// What pictures show.
    pub picture: FitPicture,
    /// Where results go.
    pub results: Results,
}

impl Fit {
    pub(super) fn new(matches: &ArgMatches) -> Self {
        Self {
            recordings: matches.get_many("recordings").into_iter().flatten().cloned().collect(),
            time: text(matches, "time"),
            value: text(matches, "value"),
            quantity: named(matches, "quantity", &QUANTITIES),
            unit: text(matches, "unit"),
            rate: text(matches, "rate"),
            run: text(matches, "run"),
            table: text(matches, "table"),
            laws: text(matches, "laws"),
            from: text(matches, "from"),
            to: text(matches, "to"),
            sigma: text(matches, "sigma"),
            intervals: named(matches, "intervals", &INTERVALS).unwrap_or_default(),
            loss: named(matches, "loss", &LOSSES).unwrap_or_default(),
            beside: beside(matches),
            picture: text(matches, "plot")
                .and_then(|name| FitPicture::named(&name))
                .unwrap_or_default(),
            results: results(matches),
        }
    }
}

/// What the name given to `argument` stands for in `table`.
fn named<T: Copy>(matches: &ArgMatches, argument: &str, table: &[(&str, T)]) -> Option<T> {
    let written = text(matches, argument)?;
    table.iter().find(|(name, _)| *name == written).map(|(_, value)| *value)
}
