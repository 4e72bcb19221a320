//! Plots, described once: what is shown, in which units, and how it is told apart. A description
//! knows nothing of pixels or terminals; [`draw`] turns it into a picture.

mod after_rest;
mod averaged;
mod axis;
mod beside;
mod clip;
mod convergence;
mod courses;
mod decrement;
pub mod draw;
mod energy;
mod errors;
mod losses;
mod motion;
mod overlay;
mod phase;
mod recording;
mod roots;
mod series;
mod significance;
mod span;
mod thin;
mod ticks;
mod work;

pub use averaged::{AveragedLaw, swings};
pub use axis::{Axis, Scale};
pub use convergence::{ConvergenceData, MethodRungs};
pub use courses::{Course, CoursesData};
pub use decrement::DecrementData;
pub use energy::EnergyData;
pub use errors::{ErrorsData, MethodErrors};
pub use losses::{Losses, LossesData};
pub use motion::MotionData;
pub use overlay::{MethodCurve, OverlayData};
pub use phase::PhaseData;
pub use recording::RecordingData;
pub use roots::RootsData;
pub use series::{Dash, Marker, Role, Series, Style};
pub use significance::{SignificanceCurve, SignificanceData};

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
    /// Short texts within the plot.
    pub notes: Vec<Note>,
    /// Whether one unit is as long on both axes, so that a circle looks like one.
    pub equal_scales: bool,
    /// A part of the same plot seen closer, drawn below it; its series are those of the plot.
    pub lens: Option<Box<Plot>>,
    /// The plot in a few sentences: its alternative text.
    pub description: String,
    /// Language of the numbers on the axes.
    pub language: Language,
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

/// A short text within the plot.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// What it says.
    pub text: String,
    /// The point (x, y) above whose middle it stands, in the units of the axes.
    pub point: (f64, f64),
}

impl Plot {
    /// An empty plot.
    pub fn new(catalogue: &Catalogue, title: String, x: Axis, y: Axis) -> Self {
        let (series, bands, notes, equal_scales, lens, description) = Default::default();
        let language = catalogue.language();
        Self { title, x, y, series, bands, notes, equal_scales, lens, description, language }
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

    /// Adds a short text whose point is in SI units.
    pub fn add_note(&mut self, text: impl Into<String>, point: (f64, f64)) {
        let point = (point.0 / self.x.unit_size, point.1 / self.y.unit_size);
        self.notes.push(Note { text: text.into(), point });
    }

    /// What the horizontal axis spans: the points, edge to edge unless that would cut a marker.
    fn x_span(&self) -> Span {
        let values =
            self.series.iter().flat_map(|series| series.points.iter().map(|point| point.0));
        let span = self.x.span(values);
        let mut markers = self.series.iter().filter(|series| series.marks_every_point());
        let on_edge = |point: &(f64, f64)| {
            span.fraction(point.0).is_some_and(|fraction| !(0.01..=0.99).contains(&fraction))
        };
        let cut =
            self.x.limits.is_none() && markers.any(|series| series.points.iter().any(on_edge));
        if cut { span.with_room(0.02) } else { span }
    }

    /// What the vertical axis spans: the points with some room, and the bands that are not so wide
    /// that the points would be lost in them.
    fn y_span(&self) -> Span {
        let points = self.series.iter().flat_map(|series| {
            let lower = series.lower.iter().flatten().copied();
            let shown = series.points.iter().filter(|point| self.x.shows(point.0));
            shown.map(|point| point.1).chain(lower)
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
            (_, Role::Sticking | Role::Guide) => 0,
            (_, Role::Exact) => 1,
            // Above it, so that a broken line is seen on the curve with which it agrees.
            (_, Role::Comparison(_)) => 2,
            (_, Role::Kinetic | Role::Potential) => 2,
            (_, Role::Stokes | Role::Coulomb | Role::Newton) => 2,
            // Where the curve is so dense that it fills its range, the envelope is seen on its edge.
            (_, Role::Envelope) => 3,
            (_, Role::TurningPoints | Role::Swings) => 4,
            (_, Role::Release | Role::Rest | Role::Experiment) => 5,
        });
        layers
    }
}
