//! SVG and PNG through kuva, which only this module and those below it know: axes, legend, dashes.

#[cfg(feature = "png")]
use kuva::RasterBackend;
use kuva::backend::svg::SvgBackend;
use kuva::plot::BandPlot;
use kuva::plot::legend::LegendPosition;
use kuva::render::annotations::TextAnnotation;
use kuva::render::plots::Plot as Drawn;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};

use super::colour::{self, Background, Paint, Palette};
#[cfg(feature = "png")]
use super::dash;
use super::frame::{ADVANCE, Frame, LABEL_SIZE};
use super::{LENS_SHARE, Size, compact, escape, layers, legend};
use crate::plot::Plot;

/// A picture that could not be drawn.
#[cfg(feature = "png")]
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct DrawError(String);

/// Room that a marker needs, px.
const MARKER_ROOM: f64 = 9.0;
/// Where the name of the vertical axis begins, px.
const LABEL_LEFT: f64 = 12.0;
/// Up to how many times its size a drawing on a page is enlarged.
const ENLARGED: f64 = 1.3;

/// `plot` as an SVG document with its title and description for screen readers.
pub fn svg(plot: &Plot, size: Size, background: Background) -> String {
    let palette = Palette::Fixed(background);
    let scene = scene(plot, size, palette);
    let (width, height) = (scene.width, scene.height);
    let attributes =
        format!("xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\"");
    element(plot, &scene, &attributes, ["title", "description"].map(str::to_owned), palette)
}

/// `plot` as an SVG element to stand within an HTML page, as wide as there is room for it, up to somewhat more
/// than `size`; [`Size::figure`] suits. Its colours are the page's custom properties, see
/// [`palette`](super::palette), so that one drawing serves light, dark and print; its title is for screen readers
/// only, since the page has a caption. `id` begins the ids in it: letters, digits and hyphens, unlike those of
/// other drawings on the page.
pub fn inline(plot: &Plot, size: Size, id: &str) -> String {
    let untitled = Plot { title: String::new(), ..plot.clone() };
    let mut scene = scene(&untitled, size, Palette::Page);
    scene.background_color = None;
    compact::paths(&mut scene);
    compact::ids(&mut scene, id);
    let attributes = format!("style=\"max-width:{}px\"", (ENLARGED * scene.width).round());
    let ids = ["title", "description"].map(|part| format!("{id}-{part}"));
    element(plot, &scene, &attributes, ids, Palette::Page)
}

/// The SVG element of a scene, with these attributes and the ids of its title and description.
fn element(
    plot: &Plot,
    scene: &Scene,
    attributes: &str,
    ids: [String; 2],
    palette: Palette,
) -> String {
    let drawing = SvgBackend::new().render_scene(scene);
    // kuva writes neither a viewBox nor alternative text, so its opening tag is replaced.
    let (_, rest) = drawing.split_once('>').unwrap_or(("", drawing.as_str()));
    let (width, height) = (scene.width, scene.height);
    let (title, description) = (escape(&plot.title), escape(&plot.description));
    let [title_id, description_id] = ids;
    format!(
        "<svg {attributes} viewBox=\"0 0 {width} {height}\" role=\"img\" \
         aria-labelledby=\"{title_id} {description_id}\" lang=\"{}\" font-family=\"sans-serif\" \
         fill=\"{}\"><title id=\"{title_id}\">{title}</title>\
         <desc id=\"{description_id}\">{description}</desc>{rest}\n",
        plot.language.tag(),
        colour::css(Paint::Text, palette),
    )
}

/// `plot` as a PNG file with `scale` device pixels per CSS pixel. Fonts are built in.
///
/// # Errors
/// [`DrawError`] if the picture is too large to be made.
#[cfg(feature = "png")]
pub fn png(
    plot: &Plot,
    size: Size,
    background: Background,
    scale: f32,
) -> Result<Vec<u8>, DrawError> {
    let mut scene = scene(plot, size, Palette::Fixed(background));
    dash::spell_out(&mut scene);
    RasterBackend::new().with_scale(scale).render_scene(&scene).map_err(DrawError)
}

fn scene(plot: &Plot, size: Size, palette: Palette) -> Scene {
    let Some(lens) = &plot.lens else { return panel(plot, size, palette, true) };
    let below = Size { height: LENS_SHARE * size.height, ..size };
    let above = Size { height: size.height - below.height, ..size };
    let mut scene = panel(plot, above, palette, false);
    let lens = panel(lens, below, palette, true);
    scene.height = size.height;
    scene.width = scene.width.max(lens.width);
    scene.elements.push(Primitive::GroupStart {
        transform: Some(format!("translate(0,{})", above.height)),
        title: None,
        extra_attrs: None,
    });
    scene.elements.extend(lens.elements);
    scene.defs.extend(lens.defs);
    scene.elements.push(Primitive::GroupEnd);
    scene
}

/// Axes with what is drawn between them.
fn panel(plot: &Plot, size: Size, palette: Palette, with_legend: bool) -> Scene {
    let frame = Frame::of(plot, size);
    let room = (size.width / MARKER_ROOM) as usize;
    let bands = plot.bands.iter().map(|band| {
        let height = |value: f64| value.clamp(frame.y.low, frame.y.high);
        let corners = [band.low, band.high]
            .map(|y| [frame.x.low, frame.x.high].map(|x| frame.place((x, height(y)))));
        BandPlot::new(
            corners[0].map(|at| at.0),
            corners[0].map(|at| at.1),
            corners[1].map(|at| at.1),
        )
        .with_color(colour::css(Paint::Band, palette))
        .with_opacity(1.0)
        .into()
    });
    let layers = layers(plot, room);
    let series = layers.iter().flat_map(|series| frame.drawn(series, size, palette));
    let drawn: Vec<Drawn> = bands.chain(series).collect();
    let mut layout = frame.layout(plot, size, palette);
    if with_legend {
        layout = layout
            .with_legend_position(LegendPosition::OutsideBottomColumns)
            .with_legend_box(false)
            .with_legend_entries(legend::entries(plot, room, palette));
    }
    for note in &plot.notes {
        let (x, y) = frame.place(note.point);
        layout = layout.with_annotation(TextAnnotation::new(note.text.clone(), x, y));
    }
    let mut scene = render_multiple(drawn, layout);
    name_vertical_axis(&mut scene, &plot.y.label);
    keep_inside(&mut scene, size.width);
    make_room(&mut scene);
    scene
}

/// Moves everything to the right if a label along the vertical axis would begin left of the picture, as “5 × 10⁻¹⁷”
/// does: kuva leaves room for its own labels.
fn make_room(scene: &mut Scene) {
    let left_of = |element: &Primitive| match element {
        Primitive::Text { x, content, size, anchor: TextAnchor::End, .. } => {
            ADVANCE * f64::from(*size) * content.chars().count() as f64 - x
        }
        _ => 0.0,
    };
    let missing = scene.elements.iter().map(left_of).fold(0.0, f64::max);
    if missing <= 0.0 {
        return;
    }
    let shift = Primitive::GroupStart {
        transform: Some(format!("translate({missing:.1},0)")),
        title: None,
        extra_attrs: None,
    };
    scene.elements.insert(0, shift);
    scene.elements.push(Primitive::GroupEnd);
    scene.width += missing;
}

/// Moves labels of the last tick, which may stand on the edge of the picture, fully into it.
fn keep_inside(scene: &mut Scene, width: f64) {
    for element in &mut scene.elements {
        if let Primitive::Text { x, content, size, anchor: TextAnchor::Middle, .. } = element {
            let half = 0.5 * ADVANCE * f64::from(*size) * content.chars().count() as f64;
            if 2.0 * half < width {
                *x = x.clamp(half, width - half);
            }
        }
    }
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
