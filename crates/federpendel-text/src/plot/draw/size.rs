//! How large pictures are.

use crate::plot::Plot;

/// A figure on a page without its legend, and the height of a line of the legend, px.
const FIGURE: Size = Size { width: 560.0, height: 340.0 };
const FIGURE_LINE: f64 = 18.0;
/// How much higher a plot with a lens is.
const WITH_LENS: f64 = 1.6;
/// Share of the height that a lens takes, which carries the legend too.
pub(super) const LENS_SHARE: f64 = 0.52;

/// Size of a picture in CSS pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Width.
    pub width: f64,
    /// Height.
    pub height: f64,
}

impl Size {
    /// A size that suits `plot`: one with a lens needs more height.
    pub fn of(plot: &Plot) -> Self {
        let size = Size::default();
        Size {
            height: if plot.lens.is_some() { WITH_LENS * size.height } else { size.height },
            ..size
        }
    }

    /// A size that suits `plot` as a figure on a page: less wide, so that its texts are still read where a
    /// narrow screen scales it down, and higher the longer its legend is.
    pub fn figure(plot: &Plot) -> Self {
        let named = plot.series.iter().filter(|series| !series.name.is_empty()).count();
        let legend = FIGURE_LINE * (named + plot.bands.len()).div_ceil(2) as f64;
        let height = match plot.lens {
            None => FIGURE.height + legend,
            // The legend stands below the lens, which has but its share of the height.
            Some(_) => WITH_LENS * FIGURE.height + legend / LENS_SHARE,
        };
        Size { height: height.round(), ..FIGURE }
    }
}

impl Default for Size {
    fn default() -> Self {
        Size { width: 800.0, height: 500.0 }
    }
}
