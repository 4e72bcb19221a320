//! SVG and PNG through kuva: the only module that knows it.

use std::sync::Arc;

use kuva::RasterBackend;
use kuva::backend::svg::SvgBackend;
use kuva::plot::legend::{LegendEntry, LegendPosition, LegendShape};
use kuva::plot::scatter::MarkerShape;
use kuva::plot::{BandPlot, LinePlot, LineStyle, ScatterPlot};
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot as Drawn;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};
use kuva::render::theme::Theme;

use super::colour::{self, Background};
use super::{dash, layers};
use crate::plot::thin::thin;
use crate::plot::{Dash, Marker, Plot, Scale, Series, Span, Style, ticks};

/// Size of a picture in CSS pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Default for Size {
    fn default() -> Self {
        Size { width: 800.0, height: 500.0 }
    }
}

/// A picture that could not be drawn.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct DrawError(String);

/// Width of an ordinary line, px.
const LINE_WIDTH: f64 = 2.0;
/// Room that a marker needs, px.
const MARKER_ROOM: f64 = 9.0;
/// Size of the names of the axes, px.
const LABEL_SIZE: u32 = 14;
/// Where the name of the vertical axis begins, px.
const LABEL_LEFT: f64 = 12.0;
/// Most ticks along each axis.
const MOST_TICKS: (usize, usize) = (9, 8);

/// `plot` as an SVG document with its title and description for screen readers.
pub fn svg(plot: &Plot, size: Size, background: Background) -> String {
    let scene = scene(plot, size, background);
    let (width, height) = (scene.width, scene.height);
    let drawing = SvgBackend::new().render_scene(&scene);
    // kuva writes neither a viewBox nor alternative text, so its opening tag is replaced.
    let (_, rest) = drawing.split_once('>').unwrap_or(("", drawing.as_str()));
    let (title, description) = (escape(&plot.title), escape(&plot.description));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" aria-labelledby=\"title description\" \
         lang=\"{}\" font-family=\"sans-serif\" fill=\"{}\">\
         <title id=\"title\">{title}</title><desc id=\"description\">{description}</desc>{rest}\n",
        plot.language.tag(),
        theme(background).text_color,
    )
}

/// `plot` as a PNG file with `scale` device pixels per CSS pixel. Fonts are built in.
///
/// # Errors
/// [`DrawError`] if the picture is too large to be made.
pub fn png(
    plot: &Plot,
    size: Size,
    background: Background,
    scale: f32,
) -> Result<Vec<u8>, DrawError> {
    let mut scene = scene(plot, size, background);
    dash::spell_out(&mut scene);
    RasterBackend::new().with_scale(scale).render_scene(&scene).map_err(DrawError)
}

fn scene(plot: &Plot, size: Size, background: Background) -> Scene {
    let (x, y) = (plot.x_span(), plot.y_span());
    let room = (size.width / MARKER_ROOM) as usize;
    let bands = plot.bands.iter().map(|band| {
        let height = |value: f64| value.clamp(y.low, y.high);
        let (low, high) = (height(band.low), height(band.high));
        BandPlot::new([x.low, x.high], [low, low], [high, high])
            .with_color(colour::band(background))
            .with_opacity(1.0)
            .into()
    });
    let layers = layers(plot, room);
    let series = layers.iter().map(|series| drawn(series, &x, size, background));
    let drawn: Vec<Drawn> = bands.chain(series).collect();
    let mut scene = render_multiple(drawn, layout(plot, &x, &y, size, background));
    name_vertical_axis(&mut scene, &plot.y.label);
    scene
}

/// Moves the subtitle, in which the layout has reserved room for the name of the vertical axis, to
/// the left above that axis: upright it is easier to read than along the axis.
fn name_vertical_axis(scene: &mut Scene, label: &str) {
    for element in &mut scene.elements {
        if let Primitive::Text { x, content, size, anchor, color, .. } = element
            && content == label
        {
            (*x, *size, *anchor, *color) = (LABEL_LEFT, LABEL_SIZE, TextAnchor::Start, None);
            return;
        }
    }
}

fn drawn(series: &Series, x: &Span, size: Size, background: Background) -> Drawn {
    let colour = colour::css(series.role, background);
    let points = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        points.iter().copied().filter(|point| point.0.is_finite() && point.1.is_finite()).collect()
    };
    if let Some(lower) = &series.lower {
        let (x, upper): (Vec<_>, Vec<_>) = series.points.iter().copied().unzip();
        return BandPlot::new(x, lower.iter().copied(), upper)
            .with_color(colour)
            .with_opacity(0.8)
            .into();
    }
    match series.style {
        Style::Line { dash, width } => LinePlot::new()
            .with_data(points(&thin(&series.points, x, size.width as usize)))
            .with_color(colour)
            .with_stroke_width(LINE_WIDTH * width)
            .with_line_style(line_style(dash))
            .into(),
        Style::Markers(marker) => ScatterPlot::new()
            .with_data(points(&series.points))
            .with_color(colour)
            .with_marker(marker_shape(marker))
            .with_size(if marker == Marker::Diamond { 6.0 } else { 3.5 })
            .into(),
    }
}

fn layout(plot: &Plot, x: &Span, y: &Span, size: Size, background: Background) -> Layout {
    let format = |span: Span, most: usize, language| {
        TickFormat::Custom(Arc::new(move |value| ticks::label(value, &span, most, language)))
    };
    let (most_x, most_y) = MOST_TICKS;
    let mut layout = Layout::new((x.low, x.high), (y.low, y.high))
        .with_width(size.width)
        .with_height(size.height)
        .with_title(plot.title.clone())
        .with_x_label(plot.x.label.clone())
        .with_subtitle(plot.y.label.clone())
        .with_subtitle_size(LABEL_SIZE)
        .with_label_size(LABEL_SIZE)
        .with_x_axis_min(x.low)
        .with_x_axis_max(x.high)
        .with_y_axis_min(y.low)
        .with_y_axis_max(y.high)
        .with_x_tick_format(format(*x, most_x, plot.language))
        .with_y_tick_format(format(*y, most_y, plot.language))
        .with_theme(theme(background))
        .with_legend_position(LegendPosition::OutsideBottomColumns)
        .with_legend_box(false)
        .with_legend_entries(legend(plot, size, background));
    layout = match x.scale {
        Scale::Linear => layout.with_x_tick_step(ticks::step(x, most_x)),
        Scale::Logarithmic => layout.with_log_x(),
    };
    match y.scale {
        Scale::Linear => layout.with_y_tick_step(ticks::step(y, most_y)),
        Scale::Logarithmic => layout.with_log_y(),
    }
}

fn legend(plot: &Plot, size: Size, background: Background) -> Vec<LegendEntry> {
    let room = (size.width / MARKER_ROOM) as usize;
    let shown = |series: &&Series| !series.name.is_empty() && super::has_room(series, room);
    let series = plot.series.iter().filter(shown).map(|series| {
        let (shape, dasharray) = match series.style {
            _ if series.lower.is_some() => (LegendShape::Rect, None),
            // Shorter, so that there is room for a gap.
            Style::Line { dash: Dash::LongDashed, .. } => (LegendShape::Line, Some("6 3".into())),
            Style::Line { dash, .. } => (LegendShape::Line, line_style(dash).dasharray()),
            Style::Markers(marker) => (LegendShape::Marker(marker_shape(marker)), None),
        };
        let color = colour::css(series.role, background).to_owned();
        LegendEntry { label: series.name.clone(), color, shape, dasharray }
    });
    let bands = plot.bands.iter().map(|band| LegendEntry {
        label: band.name.clone(),
        color: colour::band(background).to_owned(),
        shape: LegendShape::Rect,
        dasharray: None,
    });
    series.chain(bands).collect()
}

fn theme(background: Background) -> Theme {
    let theme = match background {
        Background::Light => Theme { grid_color: "#e6e6e6".into(), ..Theme::light() },
        Background::Dark => Theme { grid_color: "#3a3a3a".into(), ..Theme::dark() },
    };
    Theme { font_family: Some("sans-serif".into()), ..theme }
}

fn line_style(dash: Dash) -> LineStyle {
    match dash {
        Dash::Solid => LineStyle::Solid,
        Dash::Dashed => LineStyle::Custom("5 3.5".into()),
        Dash::LongDashed => LineStyle::Custom("9 6".into()),
        Dash::Dotted => LineStyle::Custom("2 3".into()),
    }
}

fn marker_shape(marker: Marker) -> MarkerShape {
    match marker {
        Marker::Circle => MarkerShape::Circle,
        Marker::Diamond => MarkerShape::Diamond,
        Marker::Square => MarkerShape::Square,
        Marker::Triangle => MarkerShape::Triangle,
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
