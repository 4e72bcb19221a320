//! Back ends that draw a [`Plot`]: SVG and PNG through one scene, and text for a
//! terminal.

mod areas;
mod braille;
mod colour;
#[cfg(feature = "pictures")]
mod compact;
#[cfg(feature = "png")]
mod dash;
#[cfg(feature = "pictures")]
mod frame;
mod key;
#[cfg(feature = "pictures")]
mod legend;
#[cfg(feature = "pictures")]
mod path;
#[cfg(feature = "pictures")]
mod scene;
mod size;
mod terminal;

pub use colour::{Background, palette};
#[cfg(feature = "png")]
pub use scene::{DrawError, png};
#[cfg(feature = "pictures")]
pub use scene::{inline, svg};
#[cfg(feature = "pictures")]
use size::LENS_SHARE;
pub use size::Size;
pub use terminal::terminal;

use super::{Plot, Role, Series, Span, Style};

/// Markers on a line of many points.
const MARKS: usize = 7;

/// Whether the series can be shown `room` markers wide: more markers than that would hide what they mark.
fn has_room(series: &Series, room: usize) -> bool {
    let markers = matches!(series.style, Style::Markers(_)) && series.role != Role::Swings;
    !markers || series.points.len() <= room
}

/// The series in drawing order, without those whose markers would lie on top of each other.
fn layers(plot: &Plot, room: usize) -> Vec<&Series> {
    plot.layers().into_iter().filter(|series| has_room(series, room)).collect()
}

/// Where the markers of a series stand: on all of its points, or on some along a line of many. Those of
/// different series (`number`) stand at different places, so that they are seen where the lines agree.
fn marks(series: &Series, number: usize, x: &Span, y: &Span) -> Vec<(f64, f64)> {
    let place = |point: &(f64, f64)| Some((x.fraction(point.0)?, y.fraction(point.1)?));
    let shown = |point: &(f64, f64)| place(point).is_some_and(super::clip::inside);
    if series.marks_every_point() {
        return series.points.iter().copied().filter(shown).collect();
    }
    let shift = (5 * number % 12) as f64 / 12.0;
    let target = |mark: usize| x.at((mark as f64 + 0.04 + 0.92 * shift) / MARKS as f64);
    let nearest = |target: f64| {
        let after = series.points.partition_point(|point| point.0 < target);
        series.points.get(after).or(series.points.last()).copied()
    };
    let mut marks: Vec<_> = (0..MARKS).filter_map(|mark| nearest(target(mark))).collect();
    marks.dedup();
    marks.retain(shown);
    marks
}

#[cfg(feature = "pictures")]
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
