//! What is drawn, how, and what it stands for.

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

/// Most points of a line that has a marker on each; on a line of more they would hide it.
const MOST_MARKED: usize = 28;

impl Series {
    /// Whether a marker stands on every point.
    pub(crate) fn marks_every_point(&self) -> bool {
        match self.style {
            Style::Line { .. } => false,
            Style::Markers(_) => true,
            Style::Marked { .. } => self.points.len() <= MOST_MARKED,
        }
    }
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
    /// A line of ordinary width with markers: on every point where they are few, else on some.
    Marked {
        /// Solid or broken.
        dash: Dash,
        /// What stands on the line.
        marker: Marker,
    },
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
    /// A thin solid line.
    pub const THIN: Style = Style::Line { dash: Dash::Solid, width: 0.5 };

    /// The line of method `n` of several: together with the colour of [`Role::Comparison`] twelve are
    /// told apart, and without colour still by marker and dash.
    pub fn comparison(n: usize) -> Style {
        const DASHES: [Dash; 4] = [Dash::Solid, Dash::LongDashed, Dash::Dashed, Dash::Dotted];
        // Shifted, so that markers that some back ends draw alike come with unlike dashes.
        let dash = DASHES[(n + n / DASHES.len()) % DASHES.len()];
        Style::Marked { dash, marker: Marker::ALL[n % Marker::ALL.len()] }
    }

    /// How its line is broken, if it has one.
    pub(crate) fn dash(self) -> Option<Dash> {
        match self {
            Style::Line { dash, .. } | Style::Marked { dash, .. } => Some(dash),
            Style::Markers(_) => None,
        }
    }

    /// Its marker, if it has one.
    pub(crate) fn marker(self) -> Option<Marker> {
        match self {
            Style::Line { .. } => None,
            Style::Markers(marker) | Style::Marked { marker, .. } => Some(marker),
        }
    }
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
    /// A triangle on its corner.
    TriangleDown,
    /// A diagonal cross.
    Cross,
    /// An upright cross.
    Plus,
    /// A star of five points.
    Star,
    /// A pentagon.
    Pentagon,
    /// A hexagon.
    Hexagon,
    /// A ring.
    Ring,
    /// A square that is not filled.
    Frame,
}

impl Marker {
    /// All of them, in an order in which neighbours differ most.
    const ALL: [Marker; 12] = [
        Marker::Circle,
        Marker::Square,
        Marker::Triangle,
        Marker::Cross,
        Marker::Diamond,
        Marker::Plus,
        Marker::TriangleDown,
        Marker::Star,
        Marker::Ring,
        Marker::Frame,
        Marker::Pentagon,
        Marker::Hexagon,
    ];
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
    /// Single swings.
    Swings,
    /// Where the mass is released.
    Release,
    /// Where and when the mass comes to rest.
    Rest,
    /// The user's own experiment among others.
    Experiment,
    /// Where the mass sticks.
    Sticking,
    /// Kinetic energy.
    Kinetic,
    /// Potential energy.
    Potential,
    /// What Stokes friction does.
    Stokes,
    /// What Coulomb friction does.
    Coulomb,
    /// What Newton friction does.
    Newton,
    /// Lines by which a curve is read.
    Guide,
    /// Something held beside it, numbered from zero.
    Comparison(usize),
}
