//! What `simulate` writes as a table.

use std::io::{self, Write};

pub use federpendel_text::table::Dialect;
use federpendel_text::table::{HEADER, samples};
pub(super) use federpendel_text::table::{cell, records, table};

use crate::record::Record;
use crate::sensor::Sensor;

/// Writes the samples of a motion.
pub(super) fn write(record: &Record, dialect: Dialect, out: &mut dyn Write) -> io::Result<()> {
    samples(record.samples(), dialect, out)
}

/// Writes what a sensor records of a motion.
pub(super) fn write_recording(
    record: &Record,
    sensor: &Sensor,
    dialect: Dialect,
    out: &mut dyn Write,
) -> io::Result<()> {
    let header = [HEADER[0], sensor.column()].map(str::to_owned);
    table(&header, sensor.record(record.samples()), dialect, out)
}
