//! Two columns: what it is, how much.

use std::io::{self, Write};

use console::{Alignment, measure_text_width, pad_str, style};
use federpendel_text::Catalogue;

use super::wrap::wrap;

/// Spaces before each row, and between its two columns.
const GAP: usize = 2;

/// Fewest columns for values; where names leave less, values stand below them.
const NARROWEST: usize = 22;

/// Rows of two columns.
pub(in crate::output) struct Table<'a> {
    catalogue: &'a Catalogue,
    rows: Vec<(String, String)>,
}

impl<'a> Table<'a> {
    pub(in crate::output) fn new(catalogue: &'a Catalogue) -> Self {
        Self { catalogue, rows: Vec::new() }
    }

    /// A row whose name is the sentence `id`.
    pub(in crate::output) fn row(&mut self, id: &str, value: String) {
        self.named(self.catalogue.text(id), value);
    }

    /// A row with a name made elsewhere.
    pub(in crate::output) fn named(&mut self, name: String, value: String) {
        self.rows.push((name, value));
    }

    /// Writes it at most `columns` wide.
    pub(in crate::output) fn write(&self, columns: usize, out: &mut dyn Write) -> io::Result<()> {
        let names = self.rows.iter().map(|(name, _)| measure_text_width(name));
        let width = names.max().unwrap_or(0);
        let left = columns.saturating_sub(width + 2 * GAP);
        let widest = self.rows.iter().map(|(_, value)| measure_text_width(value)).max();
        if left < NARROWEST.min(widest.unwrap_or(0)) {
            return self.write_stacked(columns, out);
        }
        for (name, value) in &self.rows {
            let name = pad_str(name, width, Alignment::Left, None);
            let lines = wrap(value, left).join(&format!("\n{}", " ".repeat(width + 2 * GAP)));
            writeln!(out, "  {}  {lines}", style(name).dim())?;
        }
        Ok(())
    }

    /// Names and values in turn.
    fn write_stacked(&self, columns: usize, out: &mut dyn Write) -> io::Result<()> {
        let lines = |text: &str, indent: usize| {
            let gap = format!("\n{}", " ".repeat(indent));
            wrap(text, columns.saturating_sub(indent)).join(&gap)
        };
        for (name, value) in &self.rows {
            writeln!(out, "  {}", style(lines(name, GAP)).dim())?;
            writeln!(out, "    {}", lines(value, 2 * GAP))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use federpendel_text::Language;

    #[test]
    fn no_line_is_wider_than_asked_for() {
        let catalogue = Catalogue::new(Language::German);
        let mut table = Table::new(&catalogue);
        table.row("summary-energy", "100 mJ beim Loslassen, 36,1 µJ am Ende".to_owned());
        table.row("summary-heat-coulomb", "99,963 mJ".to_owned());
        for columns in [30, 40, 50, 60, 80, 120] {
            let mut out = Vec::new();
            table.write(columns, &mut out).unwrap();
            let text = console::strip_ansi_codes(&String::from_utf8(out).unwrap()).into_owned();
            assert!(text.lines().all(|line| measure_text_width(line) <= columns), "{text}");
            let words: Vec<_> = text.split_whitespace().collect();
            assert!(words.join(" ").contains("36,1 µJ am Ende"), "{text}");
        }
    }
}
