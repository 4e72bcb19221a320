//! Several columns under a head.

use std::io::{self, Write};

use console::{Alignment, measure_text_width, pad_str, style};

/// Writes the rows as columns, those numbered in `right` against their right edge; the last ones are left out where the
/// terminal is too narrow for them.
pub(in crate::output) fn write_columns<const N: usize>(
    head: &[String; N],
    rows: &[[String; N]],
    right: &[usize],
    columns: usize,
    out: &mut dyn Write,
) -> io::Result<()> {
    let width = |column: usize| {
        let cells = rows.iter().chain([head]).map(|row| measure_text_width(&row[column]));
        cells.max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..N).map(width).collect();
    let mut shown = 0;
    let mut used = 0;
    while shown < N && used + 2 + widths[shown] <= columns.max(40) {
        used += 2 + widths[shown];
        shown += 1;
    }
    let line = |row: &[String; N]| {
        let cells = row.iter().zip(&widths).take(shown).enumerate();
        let cells = cells.map(|(column, (cell, width))| {
            let side = if right.contains(&column) { Alignment::Right } else { Alignment::Left };
            format!("  {}", pad_str(cell, *width, side, None))
        });
        cells.collect::<String>().trim_end().to_owned()
    };
    writeln!(out, "{}", style(line(head)).dim())?;
    rows.iter().try_for_each(|row| writeln!(out, "{}", line(row)))
}
