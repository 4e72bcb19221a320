//! The arguments of `plan`.

use clap::ArgMatches;
use federpendel_fit::Quantity;

use super::{QUANTITIES, Results, Subject, results, subject, text};

/// The arguments of `plan`.
#[derive(Debug)]
pub struct Plan {
    /// The experiment that is expected.
    pub subject: Subject,
    /// Standard deviation of a sensor's noise, as written.
    pub noise: Option<String>,
    /// Values per second, as written.
    pub rate: Option<String>,
    /// What is recorded.
    pub quantity: Option<Quantity>,
    /// The smallest amplitude, as written.
    pub min_amplitude: Option<String>,
    /// The largest, as written.
    pub max_amplitude: Option<String>,
    /// Laws that are fitted besides the expected ones, as written.
    pub laws: Option<String>,
    /// Where results go.
    pub results: Results,
}

impl Plan {
    pub(super) fn new(matches: &ArgMatches) -> Self {
        let quantity = text(matches, "quantity");
        let known = QUANTITIES.iter().find(|(name, _)| Some(*name) == quantity.as_deref());
        Plan {
            subject: subject(matches),
            noise: text(matches, "noise"),
            rate: text(matches, "rate"),
            quantity: known.map(|(_, quantity)| *quantity),
            min_amplitude: text(matches, "min-amplitude"),
            max_amplitude: text(matches, "max-amplitude"),
            laws: text(matches, "laws"),
            results: results(matches),
        }
    }
}
