//! The legend of a picture, and how lines and markers look in it and on the axes.

use kuva::plot::LineStyle;
use kuva::plot::legend::{LegendEntry, LegendShape};
use kuva::plot::scatter::MarkerShape;

use super::colour::{self, Paint, Palette};
use crate::plot::{Dash, Marker, Plot, Role, Series, Style};

/// The entries of the legend, `room` markers wide.
pub(super) fn entries(plot: &Plot, room: usize, palette: Palette) -> Vec<LegendEntry> {
    let shown = |series: &&Series| !series.name.is_empty() && super::has_room(series, room);
    let series = plot.series.iter().filter(shown).map(|series| {
        let (shape, dasharray) = match series.style {
            _ if series.lower.is_some() || series.role == Role::Sticking => {
                (LegendShape::Rect, None)
            }
            // Shorter, so that there is room for a gap.
            Style::Line { dash: Dash::LongDashed, .. } => (LegendShape::Line, Some("6 3".into())),
            Style::Line { dash, .. } => (LegendShape::Line, line_style(dash).dasharray()),
            Style::Markers(marker) | Style::Marked { marker, .. } => {
                (LegendShape::Marker(marker_shape(marker)), None)
            }
        };
        let color = colour::css(Paint::Series(series.role), palette);
        LegendEntry { label: series.name.clone(), color, shape, dasharray }
    });
    let bands = plot.bands.iter().map(|band| LegendEntry {
        label: band.name.clone(),
        color: colour::css(Paint::Band, palette),
        shape: LegendShape::Rect,
        dasharray: None,
    });
    series.chain(bands).collect()
}

/// How kuva draws a line.
pub(super) fn line_style(dash: Dash) -> LineStyle {
    match dash {
        Dash::Solid => LineStyle::Solid,
        Dash::Dashed => LineStyle::Custom("5 3.5".into()),
        Dash::LongDashed => LineStyle::Custom("9 6".into()),
        Dash::Dotted => LineStyle::Custom("2 3".into()),
    }
}

/// The shape by which kuva draws a marker. It has no hollow ones, so these are told by their colour.
pub(super) fn marker_shape(marker: Marker) -> MarkerShape {
    match marker {
        Marker::Circle | Marker::Ring => MarkerShape::Circle,
        Marker::Diamond => MarkerShape::Diamond,
        Marker::Square | Marker::Frame => MarkerShape::Square,
        Marker::Triangle => MarkerShape::Triangle,
        Marker::TriangleDown => MarkerShape::TriangleDown,
        Marker::Cross => MarkerShape::Cross,
        Marker::Plus => MarkerShape::Plus,
        Marker::Star => MarkerShape::Star,
        Marker::Pentagon => MarkerShape::Pentagon,
        Marker::Hexagon => MarkerShape::Hexagon,
    }
}
