//! Plots within the page.

use federpendel_text::plot::Plot;
use federpendel_text::plot::draw::{Background, Size, svg};
use minijinja::Value;

use super::math::Html;

/// `plot` as an SVG element whose ids begin with `id`, since a page has many.
pub fn plot(plot: &Plot, id: &str) -> Html {
    let drawing = svg(plot, Size::of(plot), Background::Light)
        .replace("\"title description\"", &format!("\"{id}-title {id}-description\""))
        .replace("id=\"title\"", &format!("id=\"{id}-title\""))
        .replace("id=\"description\"", &format!("id=\"{id}-description\""));
    Value::from_safe_string(drawing)
}
