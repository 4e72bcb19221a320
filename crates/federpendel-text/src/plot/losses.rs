//! What each swing of several motions costs: every law of friction shows by the shape of its line.

use federpendel::Oscillator;

use super::averaged::{AveragedLaw, curve, formula, swings};
use super::{Axis, Dash, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plot of the losses of amplitude shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct LossesData<'a> {
    /// The motions, in the order of the legend; up to four are told apart without colour.
    pub motions: &'a [Losses<'a>],
}

/// One of the motions.
#[derive(Debug, Clone, Copy)]
pub struct Losses<'a> {
    /// Its name.
    pub name: &'a str,
    /// What it stands for: the law of friction that acts, or a number among others.
    pub role: Role,
    /// The oscillator, for the averaged law.
    pub oscillator: &'a Oscillator,
    /// Displacement at the turning points in order, of either sign, m; a release from rest is one.
    pub amplitudes: &'a [f64],
}

/// Most swings that are marked of each motion.
const MOST_MARKERS: usize = 24;

/// Markers of the swings and dashes of the laws, in the order of the legend.
const LOOKS: [(Marker, Dash); 4] = [
    (Marker::Circle, Dash::Solid),
    (Marker::Square, Dash::LongDashed),
    (Marker::Triangle, Dash::Dotted),
    (Marker::Diamond, Dash::Dashed),
];

impl Plot {
    /// |xₙ| − |xₙ₊₁| of each swing against (|xₙ| + |xₙ₊₁|)/2 for several motions, each with the loss that
    /// averaging gives: level for Coulomb friction, a straight line through zero for Stokes, a parabola for
    /// Newton friction.
    pub fn losses(catalogue: &Catalogue, data: &LossesData<'_>) -> Self {
        let all = || data.motions.iter().flat_map(|motion| swings(motion.amplitudes));
        let largest = all().fold(0.0, |most: f64, swing| most.max(swing.0));
        let most = all().fold(0.0, |most: f64, swing| most.max(swing.1));
        let amplitude =
            Axis::new(catalogue, &catalogue.text("plot-mean-amplitude"), "A", "m", largest);
        let lost = Axis::new(catalogue, &catalogue.text("plot-loss"), "ΔA", "m", most);
        let title = catalogue.text("plot-losses-title");
        let mut plot = Plot::new(catalogue, title, amplitude.from_zero(), lost.from_zero());
        plot.description = description(catalogue, data, &plot.title);
        for (motion, (marker, dash)) in data.motions.iter().zip(LOOKS.into_iter().cycle()) {
            let swings = swings(motion.amplitudes);
            let stride = swings.len().div_ceil(MOST_MARKERS).max(1);
            let reach = swings.iter().fold(0.0, |most: f64, swing| most.max(swing.0));
            let parts = AveragedLaw::of(motion.oscillator).parts(catalogue, "m");
            let name = format!("{}: {}", motion.name, formula(&parts));
            let style = Style::Markers(marker);
            plot.add(name, motion.role, style, swings.into_iter().step_by(stride));
            let style = Style::Line { dash, width: 1.0 };
            plot.add("", motion.role, style, curve(&parts, reach));
        }
        if largest == 0.0 {
            let text = catalogue.text("plot-decrement-empty");
            plot.series.clear();
            plot.notes.push(super::Note { text, point: (0.0, 0.0) });
        }
        plot
    }
}

fn description(catalogue: &Catalogue, data: &LossesData<'_>, title: &str) -> String {
    let length = |value: Option<f64>| catalogue.quantity(value.unwrap_or(0.0), "m", DIGITS).into();
    let motion = |motion: &Losses<'_>| {
        let swings = swings(motion.amplitudes);
        let losses = || swings.iter().map(|swing| swing.1);
        let parts = AveragedLaw::of(motion.oscillator).parts(catalogue, "m");
        let variables = [
            ("name", motion.name.into()),
            ("swings", swings.len().into()),
            ("least", length(losses().reduce(f64::min))),
            ("most", length(losses().reduce(f64::max))),
            ("largest", length(swings.iter().map(|swing| swing.0).reduce(f64::max))),
            ("formula", formula(&parts).into()),
        ];
        catalogue.format("plot-losses-motion", &variables)
    };
    let motions: Vec<_> = data.motions.iter().map(motion).collect();
    let variables = [("title", title.into()), ("motions", motions.join(" ").into())];
    catalogue.format("plot-losses-description", &variables)
}
