//! Two columns: what it is, how much.

use std::io::{self, Write};

use console::{Alignment, measure_text_width, pad_str, style};
use federpendel_text::Catalogue;

pub(super) struct Table<'a> {
    catalogue: &'a Catalogue,
    rows: Vec<(String, String)>,
}

impl<'a> Table<'a> {
    pub(super) fn new(catalogue: &'a Catalogue) -> Self {
        Self { catalogue, rows: Vec::new() }
    }

    /// A row whose name is the sentence `id`.
    pub(super) fn row(&mut self, id: &str, value: String) {
        self.named(self.catalogue.text(id), value);
    }

    /// A row with a name made elsewhere.
    pub(super) fn named(&mut self, name: String, value: String) {
        self.rows.push((name, value));
    }

    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let width = self.rows.iter().map(|(name, _)| measure_text_width(name)).max().unwrap_or(0);
        for (name, value) in &self.rows {
            let name = pad_str(name, width, Alignment::Left, None);
            writeln!(out, "  {}  {value}", style(name).dim())?;
        }
        Ok(())
    }
}
