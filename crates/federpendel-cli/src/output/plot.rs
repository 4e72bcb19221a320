//! Pictures in every form.

use std::io::{self, Write};

use federpendel_text::plot::Plot;
use federpendel_text::plot::draw::{Background, Size, png, svg, terminal};

use super::Format;

/// Device pixels per CSS pixel of a PNG, for sharp prints and screens.
const SCALE: f32 = 2.0;

/// Writes `plot` as a PNG, or as an SVG for any other form.
pub(super) fn write(
    plot: &Plot,
    format: Format,
    background: Background,
    out: &mut dyn Write,
) -> io::Result<()> {
    let size = Size::of(plot);
    if format == Format::Png {
        let picture = png(plot, size, background, SCALE).map_err(io::Error::other)?;
        out.write_all(&picture)
    } else {
        out.write_all(svg(plot, size, background).as_bytes())
    }
}

/// Writes `plot` as text of this size.
pub(super) fn write_terminal(
    plot: &Plot,
    (columns, rows): (usize, usize),
    out: &mut dyn Write,
) -> io::Result<()> {
    out.write_all(terminal(plot, columns, rows, console::colors_enabled()).as_bytes())
}
