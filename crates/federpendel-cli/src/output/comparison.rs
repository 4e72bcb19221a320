//! A comparison of methods, in every form.

mod csv;
mod picture;
mod summary;

pub use picture::Picture;

use std::io::{self, Write};

use super::{Format, Report, Style, json, plot};
use crate::comparison::Comparison;
use crate::record::Record;

/// A comparison, and what its pictures show.
pub(crate) struct ComparisonReport<'a> {
    /// The comparison.
    pub comparison: &'a Comparison,
    /// What its pictures show.
    pub picture: Picture,
}

impl Report for ComparisonReport<'_> {
    fn record(&self) -> &Record {
        &self.comparison.record
    }

    fn render(&self, format: Format, style: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
        let plot = || self.picture.plot(self.comparison, style.catalogue);
        match format {
            Format::Summary => summary::write(self.comparison, &plot(), style, out),
            Format::Csv => csv::write(self.comparison, style.dialect, out),
            Format::Json => json::write_comparison(self.comparison, out),
            Format::Svg | Format::Png => plot::write(&plot(), format, style.background, out),
            Format::Html => Err(io::ErrorKind::Unsupported.into()),
        }
    }
}
