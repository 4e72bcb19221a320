//! The axes of a picture and the series between them, as kuva takes them.

use std::sync::Arc;

use kuva::plot::{BandPlot, LinePlot, ScatterPlot};
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot as Drawn;

use super::Size;
use super::colour::{self, Paint, Palette};
use super::legend::{line_style, marker_shape};
use super::marks;
use crate::plot::clip::clip;
use crate::plot::thin::thin;
use crate::plot::{Marker, Plot, Role, Scale, Series, Span, Style, ticks};

/// Width of an ordinary line, px.
const LINE_WIDTH: f64 = 2.0;
/// Size of the names of the axes, px.
pub(super) const LABEL_SIZE: u32 = 14;
/// Width of a sign on average, over the size of the font.
pub(super) const ADVANCE: f64 = 0.6;
/// Where the edge of an area turns more often than once in so many px, it would blacken the area.
const DENSEST_EDGE: f64 = 10.0;
/// Most ticks along the vertical axis.
const MOST_TICKS: usize = 8;
/// Room along the horizontal axis for a tick and its label, px.
const TICK_ROOM: f64 = 80.0;
/// About how much of the width and of the height lies between the axes.
const BETWEEN_AXES: (f64, f64) = (0.9, 0.62);
/// Size of tick labels and of the legend on a page, which narrow screens scale down, px.
const PAGE_TEXT: u32 = 13;

/// The axes of a picture.
pub(super) struct Frame {
    pub x: Span,
    pub y: Span,
}

impl Frame {
    /// The axes of a plot drawn in this size.
    pub fn of(plot: &Plot, size: Size) -> Self {
        let (x, y) = (plot.x_span(), plot.y_span());
        if !plot.equal_scales {
            return Frame { x, y };
        }
        let (across, down) = BETWEEN_AXES;
        let (x, y) = Span::equal(x, y, across * size.width, down * size.height);
        Frame { x, y }
    }

    /// A point as it is handed to kuva.
    pub fn place(&self, point: (f64, f64)) -> (f64, f64) {
        (point.0 / unit(&self.x), point.1 / unit(&self.y))
    }

    pub fn drawn(&self, series: &Series, size: Size, palette: Palette) -> Vec<Drawn> {
        let colour = colour::css(Paint::Series(series.role), palette);
        if let Some(lower) = &series.lower {
            return self.area(series, lower, size, palette);
        }
        let width = match series.style {
            Style::Line { width, .. } => width,
            Style::Markers(_) | Style::Marked { .. } => 1.0,
        };
        let mut drawn: Vec<Drawn> = Vec::new();
        if let Some(dash) = series.style.dash() {
            let line = |piece: Vec<(f64, f64)>| {
                LinePlot::new()
                    .with_data(piece.into_iter().map(|point| self.place(point)))
                    .with_color(colour.clone())
                    .with_stroke_width(LINE_WIDTH * width)
                    .with_line_style(line_style(dash))
                    .into()
            };
            let points = thin(&series.points, &self.x, size.width as usize);
            drawn.extend(clip(&points, &self.x, &self.y).into_iter().map(line));
        }
        if let Some(marker) = series.style.marker() {
            let number = if let Role::Comparison(n) = series.role { n } else { 0 };
            let size = if series.style.dash().is_some() { 3.5 } else { 4.0 };
            let points = marks(series, number, &self.x, &self.y);
            let markers = ScatterPlot::new()
                .with_data(points.into_iter().map(|point| self.place(point)))
                .with_color(colour.clone())
                .with_marker(marker_shape(marker))
                .with_size(if marker == Marker::Diamond { 1.5 * size } else { size });
            drawn.push(markers.into());
        }
        drawn
    }

    /// An area, with its upper edge drawn so that it ends where a neighbour of like lightness begins.
    fn area(&self, series: &Series, lower: &[f64], size: Size, palette: Palette) -> Vec<Drawn> {
        let upper = series.points.iter().map(|point| self.place(*point));
        let (x, y): (Vec<_>, Vec<_>) = upper.clone().unzip();
        let area = BandPlot::new(x, lower.iter().map(|y| y / unit(&self.y)), y)
            .with_color(colour::css(Paint::Series(series.role), palette))
            .with_opacity(1.0);
        if extremes(&series.points) > size.width / DENSEST_EDGE {
            return vec![area.into()];
        }
        let edge = LinePlot::new()
            .with_data(upper)
            .with_color(colour::css(Paint::Text, palette))
            .with_stroke_width(0.4 * LINE_WIDTH);
        vec![area.into(), edge.into()]
    }

    pub fn layout(&self, plot: &Plot, size: Size, palette: Palette) -> Layout {
        let format = |span: Span, most: usize, language| {
            let label = move |value| ticks::label(value * unit(&span), &span, most, language);
            TickFormat::Custom(Arc::new(label))
        };
        let (most_x, most_y) = ((size.width / TICK_ROOM).clamp(2.0, 9.0) as usize, MOST_TICKS);
        let (x, y) = (self.x, self.y);
        let ((left, bottom), (right, top)) =
            (self.place((x.low, y.low)), self.place((x.high, y.high)));
        let mut layout = Layout::new((left, right), (bottom, top))
            .with_width(size.width)
            .with_height(size.height)
            .with_x_label(plot.x.label.clone())
            .with_subtitle(plot.y.label.clone())
            .with_subtitle_size(LABEL_SIZE)
            .with_label_size(LABEL_SIZE)
            .with_x_axis_min(left)
            .with_x_axis_max(right)
            .with_y_axis_min(bottom)
            .with_y_axis_max(top)
            .with_x_tick_format(format(x, most_x, plot.language))
            .with_y_tick_format(format(y, most_y, plot.language))
            .with_theme(colour::theme(palette));
        if !plot.title.is_empty() {
            let fits = title_size(&plot.title, size.width);
            layout = layout.with_title(plot.title.clone()).with_title_size(fits);
        }
        if palette == Palette::Page {
            layout = layout.with_tick_size(PAGE_TEXT).with_body_size(PAGE_TEXT);
        }
        if plot.equal_scales {
            layout = layout.with_equal_aspect();
        }
        layout = match x.scale {
            Scale::Linear => layout.with_x_tick_step(ticks::step(&x, most_x)),
            Scale::Logarithmic => layout.with_log_x(),
        };
        match y.scale {
            Scale::Linear => layout.with_y_tick_step(ticks::step(&y, most_y)),
            Scale::Logarithmic => layout.with_log_y(),
        }
    }
}

/// How often a curve turns.
fn extremes(points: &[(f64, f64)]) -> f64 {
    let turns = |three: &&[(f64, f64)]| (three[1].1 - three[0].1) * (three[2].1 - three[1].1) < 0.0;
    points.windows(3).filter(turns).count() as f64
}

/// As large as titles are, or as fits a picture of this width, px.
fn title_size(title: &str, width: f64) -> u32 {
    let fits = 0.97 * width / (ADVANCE * title.chars().count().max(1) as f64);
    (fits as u32).clamp(9, 18)
}

/// The unit in which values along a logarithmic axis are handed to kuva, which shows nothing below 1e-10.
fn unit(span: &Span) -> f64 {
    match span.scale {
        Scale::Linear => 1.0,
        Scale::Logarithmic => 10f64.powf(span.low.log10().floor()),
    }
}
