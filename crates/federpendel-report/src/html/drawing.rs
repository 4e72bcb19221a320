//! Plots within the page.

use federpendel_text::plot::Plot;
use federpendel_text::plot::draw::{Background, Size, inline, palette};
use minijinja::Value;
use serde::Serialize;

use super::math::Html;

/// Colours of plots, as declarations of a style sheet.
#[derive(Serialize)]
pub struct Palettes {
    light: Html,
    dark: Html,
}

impl Palettes {
    pub fn new() -> Self {
        let declarations = |background| Value::from_safe_string(palette(background));
        Self { light: declarations(Background::Light), dark: declarations(Background::Dark) }
    }
}

/// `plot` as an SVG element whose ids begin with `id`, since a page has many.
pub fn plot(plot: &Plot, id: &str) -> Html {
    Value::from_safe_string(inline(plot, Size::figure(plot), id))
}
