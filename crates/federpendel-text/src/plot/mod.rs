//! Plots, described once: what is shown, in which units, and how it is told apart. A description
//! knows nothing of pixels or terminals; [`draw`] turns it into a picture.

pub mod draw;
mod motion;
mod span;
mod thin;
mod ticks;

pub use motion::MotionData;

use crate::catalogue::Catalogue;
use crate::language::Language;
use span::Span;

/// A plot: axes, series and bands, and what to say to somebody who cannot see it.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Title, above the plot.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// What is drawn, in the order of the legend.
    pub series: Vec<Series>,
    /// Shaded ranges of y, behind the series.
    pub bands: Vec<Band>,
    /// The plot in a few sentences: its alternative text.
    pub description: String,
    /// Language of the numbers on the axes.
    pub language: Language,
}

/// An axis: the quantity it shows and the unit of the numbers along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Name and symbol of the quantity and its unit, as they are written along the axis.
    pub label: String,
    /// Size of one unit of the axis in SI units: 0.001 if it shows millimetres.
    pub unit_size: f64,
    /// How values are laid out.
    pub scale: Scale,
    /// Whether zero is shown even where no point is near it; not on a logarithmic axis.
    pub with_zero: bool,
}

/// How values are laid out along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Scale {
    /// Equal differences are equally far apart.
    #[default]
    Linear,
    /// Equal ratios are equally far apart. Values that are not positive are left out.
    Logarithmic,
}

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend; one without a name is not listed there.
    pub name: String,
    /// Points (x, y) in the units of the axes.
    pub points: Vec<(f64, f64)>,
    /// Where the area down to a lower curve is filled: that curve's y at each point. Areas stacked on
    /// one another show shares of a sum.
    pub lower: Option<Vec<f64>>,
    /// How it is drawn.
    pub style: Style,
    /// What it stands for; its colour follows from that.
    pub role: Role,
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Style {
    /// A line through the points, `width` times as wide as an ordinary one.
    Line {
        /// Solid or broken.
        dash: Dash,
        /// Width, in widths of an ordinary line.
        width: f64,
    },
    /// A marker on every point.
    Markers(Marker),
}

impl Style {
    /// A solid line of ordinary width.
    pub const SOLID: Style = Style::Line { dash: Dash::Solid, width: 1.0 };
    /// A thinner, dashed line.
    pub const DASHED: Style = Style::Line { dash: Dash::Dashed, width: 0.75 };
    /// A line of long pieces: above a [`Style::WIDE`] one both are seen where they agree.
    pub const LONG_DASHED: Style = Style::Line { dash: Dash::LongDashed, width: 1.0 };
    /// A solid line wide enough to be seen on both sides of one above it.
    pub const WIDE: Style = Style::Line { dash: Dash::Solid, width: 2.25 };
    /// A dotted line of ordinary width.
    pub const DOTTED: Style = Style::Line { dash: Dash::Dotted, width: 1.0 };
}

/// Solid or broken: lines are not told apart by colour alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Pieces of middling length.
    Dashed,
    /// Long pieces.
    LongDashed,
    /// Short pieces.
    Dotted,
}

/// The shape of a marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Marker {
    /// A disc.
    Circle,
    /// A square on its corner, larger than the disc.
    Diamond,
    /// A square.
    Square,
    /// A triangle.
    Triangle,
}

/// What a series stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// The exact motion.
    Exact,
    /// The envelope of the exact motion.
    Envelope,
    /// Turning points of the exact motion.
    TurningPoints,
    /// Where and when the mass comes to rest.
    Rest,
    /// Something held beside it, numbered from zero.
    Comparison(usize),
}

/// A shaded range of y.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Name in the legend.
    pub name: String,
    /// Lower edge, in the unit of the axis.
    pub low: f64,
    /// Upper edge, in the unit of the axis.
    pub high: f64,
}

impl Axis {
    /// An axis of the quantity `name` with its `symbol`, whose SI unit is `unit` (`1` for a pure
    /// number), shown in a unit that suits values up to `magnitude` (SI).
    pub fn new(
        catalogue: &Catalogue,
        name: &str,
        symbol: &str,
        unit: &str,
        magnitude: f64,
    ) -> Self {
        let (unit, unit_size) = crate::number::axis_unit(magnitude, unit);
        let unit = crate::number::typeset_unit(unit);
        let name_and_symbol = [("name", name.into()), ("symbol", symbol.into())];
        let label = if unit.is_empty() {
            catalogue.format("plot-axis-pure", &name_and_symbol)
        } else {
            let [name, symbol] = name_and_symbol;
            catalogue.format("plot-axis", &[name, symbol, ("unit", unit.into())])
        };
        Self { label, unit_size, scale: Scale::Linear, with_zero: false }
    }

    /// The same axis with equal ratios equally far apart.
    pub fn logarithmic(self) -> Self {
        Self { scale: Scale::Logarithmic, with_zero: false, ..self }
    }

    /// The same axis with zero on it even where no point is near it.
    pub fn from_zero(self) -> Self {
        Self { with_zero: self.scale == Scale::Linear, ..self }
    }

    /// What the axis spans to show `values`.
    fn span(&self, values: impl Iterator<Item = f64>) -> Span {
        Span::of(values.chain(self.with_zero.then_some(0.0)), self.scale)
    }
}

impl Plot {
    /// An empty plot.
    pub fn new(catalogue: &Catalogue, title: String, x: Axis, y: Axis) -> Self {
        let language = catalogue.language();
        let (series, bands, description) = (Vec::new(), Vec::new(), String::new());
        Self { title, x, y, series, bands, description, language }
    }

    /// Adds a series whose points are in SI units.
    pub fn add(
        &mut self,
        name: impl Into<String>,
        role: Role,
        style: Style,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) {
        let (x_size, y_size) = (self.x.unit_size, self.y.unit_size);
        let points = points.into_iter().map(|(x, y)| (x / x_size, y / y_size)).collect();
        self.series.push(Series { name: name.into(), points, lower: None, style, role });
    }

    /// Adds a shaded range of y whose edges are in SI units.
    pub fn add_band(&mut self, name: impl Into<String>, low: f64, high: f64) {
        let size = self.y.unit_size;
        self.bands.push(Band { name: name.into(), low: low / size, high: high / size });
    }

    /// What the horizontal axis spans: the points, edge to edge unless that would cut a marker.
    fn x_span(&self) -> Span {
        let values =
            self.series.iter().flat_map(|series| series.points.iter().map(|point| point.0));
        let span = self.x.span(values);
        let mut markers =
            self.series.iter().filter(|series| matches!(series.style, Style::Markers(_)));
        let on_edge = |point: &(f64, f64)| {
            span.fraction(point.0).is_some_and(|fraction| !(0.01..=0.99).contains(&fraction))
        };
        let cut = markers.any(|series| series.points.iter().any(on_edge));
        if cut { span.with_room(0.02) } else { span }
    }

    /// What the vertical axis spans: the points with some room, and the bands that are not so wide
    /// that the points would be lost in them.
    fn y_span(&self) -> Span {
        let points = self.series.iter().flat_map(|series| {
            let lower = series.lower.iter().flatten().copied();
            series.points.iter().map(|point| point.1).chain(lower)
        });
        let span = self.y.span(points);
        let bands = self.bands.iter().flat_map(|band| [band.low, band.high]);
        span.including(bands, 3.0).with_room(0.05)
    }

    /// The series in the order in which they are drawn, the most important last.
    fn layers(&self) -> Vec<&Series> {
        let mut layers: Vec<_> = self.series.iter().collect();
        layers.sort_by_key(|series| match (&series.lower, series.role) {
            (Some(_), _) => 0,
            (_, Role::Exact) => 1,
            // Above it, so that a broken line is seen on the curve with which it agrees.
            (_, Role::Comparison(_)) => 2,
            // Where the curve is so dense that it fills its range, the envelope is seen on its edge.
            (_, Role::Envelope) => 3,
            (_, Role::TurningPoints) => 4,
            (_, Role::Rest) => 5,
        });
        layers
    }
}
