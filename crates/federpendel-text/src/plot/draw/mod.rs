//! Back ends that draw a [`Plot`]: SVG and PNG through one scene, and text for a
//! terminal.

mod braille;
mod colour;
mod dash;
mod scene;
mod terminal;

pub use colour::Background;
pub use scene::{DrawError, Size, png, svg};
pub use terminal::terminal;

use super::{Plot, Series, Style};

/// Whether the series can be shown `room` markers wide: more markers than that would hide what they mark.
fn has_room(series: &Series, room: usize) -> bool {
    matches!(series.style, Style::Line { .. }) || series.points.len() <= room
}

/// The series in drawing order, without those whose markers would lie on top of each other.
fn layers(plot: &Plot, room: usize) -> Vec<&Series> {
    plot.layers().into_iter().filter(|series| has_room(series, room)).collect()
}
