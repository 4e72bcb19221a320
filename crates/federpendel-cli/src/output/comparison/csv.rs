//! Positions of all methods side by side, at the times of the record.

use std::io::{self, Write};

use super::super::csv::{Dialect, table};
use crate::comparison::Comparison;

/// The columns that every such table begins with.
const TIME: &str = "Time (s)";
const EXACT: &str = "exact Position (m)";

/// Writes the times, the exact positions, and those of every method that did not fail.
pub(super) fn write(
    comparison: &Comparison,
    dialect: Dialect,
    out: &mut dyn Write,
) -> io::Result<()> {
    let methods: Vec<_> = comparison.measured().collect();
    let names = methods.iter().map(|(candidate, _)| format!("{} Position (m)", candidate.name()));
    let header: Vec<String> = [TIME.into(), EXACT.into()].into_iter().chain(names).collect();
    let rows = comparison.record.exact.iter().enumerate().map(|(i, sample)| {
        let others = methods.iter().map(|(_, measured)| measured.states[i].position);
        [sample.time, sample.position].into_iter().chain(others).collect::<Vec<_>>()
    });
    table(&header, rows, dialect, out)
}
