//! What each swing costs: loss of amplitude against amplitude, where the laws of friction show as intercept,
//! slope and curvature.

use super::averaged::{AveragedLaw, curve, formula, loss};
use super::{Axis, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plot of the loss of amplitude shows.
#[derive(Debug, Clone, Copy)]
pub struct DecrementData<'a> {
    /// The averaged law, which the swings should follow.
    pub law: AveragedLaw,
    /// Mean amplitude and loss of each swing.
    pub swings: &'a [(f64, f64)],
    /// Of how many swings each is the mean.
    pub mean_of: usize,
    /// The unit of amplitudes and losses; `1` where it is not known.
    pub length: &'a str,
}

/// Most swings that are marked: more would hide the law.
const MOST_MARKERS: usize = 48;

impl Plot {
    /// The loss of amplitude of each swing against its mean amplitude, with the averaged law and its parts.
    pub fn decrement(catalogue: &Catalogue, data: &DecrementData<'_>) -> Self {
        let DecrementData { law, swings, length, .. } = *data;
        let parts = law.parts(catalogue, length);
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let largest = most(&mut swings.iter().map(|swing| swing.0));
        let lost = most(&mut swings.iter().map(|swing| swing.1.abs())).max(loss(&parts, largest));
        let amplitude =
            Axis::new(catalogue, &catalogue.text("plot-mean-amplitude"), "A", length, largest);
        let lost = Axis::new(catalogue, &catalogue.text("plot-loss"), "ΔA", length, lost);
        let mix = catalogue.mix(law.mix());
        let title = catalogue.format("plot-decrement-title", &[("mix", mix.into())]);
        let mut plot = Plot::new(catalogue, title, amplitude.from_zero(), lost.from_zero());
        let formula = formula(&parts);
        if swings.is_empty() {
            let why = catalogue.text("plot-decrement-empty");
            plot.description = format!("{}: {why}.", plot.title);
            plot.notes.push(super::Note { text: why, point: (0.0, 0.0) });
            return plot;
        }
        plot.description = description(catalogue, &plot.title, data, largest, &formula);
        let markers = Style::Markers(Marker::Circle);
        let stride = swings.len().div_ceil(MOST_MARKERS);
        let name = match (data.mean_of, stride) {
            (1, 1) => catalogue.text("plot-decrement-swings"),
            (1, _) => catalogue.format("plot-decrement-some", &[("stride", stride.into())]),
            (count, _) => catalogue.format("measured-swings", &[("count", count.into())]),
        };
        plot.add(name, Role::Swings, markers, swings.iter().copied().step_by(stride));
        // A single part is all of the law.
        if let [part] = &parts[..] {
            let name = format!("{formula}: {}", part.name);
            plot.add(name, part.role, Style::WIDE, curve(&parts, largest));
            return plot;
        }
        if !parts.is_empty() {
            let name = catalogue.format("plot-decrement-law", &[("formula", formula.into())]);
            plot.add(name, Role::Exact, Style::WIDE, curve(&parts, largest));
        }
        for part in &parts {
            let points = curve(std::slice::from_ref(part), largest);
            plot.add(part.name.clone(), part.role, Style::LONG_DASHED, points);
        }
        plot
    }
}

fn description(
    catalogue: &Catalogue,
    title: &str,
    data: &DecrementData<'_>,
    largest: f64,
    formula: &str,
) -> String {
    let swings = data.swings;
    let length = |value: f64| catalogue.quantity(value, data.length, DIGITS).into();
    let extreme = |pick: fn(f64, f64) -> f64| {
        length(swings.iter().map(|swing| swing.1).reduce(pick).unwrap_or(0.0))
    };
    catalogue.format(
        "plot-decrement-description",
        &[
            ("title", title.into()),
            ("swings", swings.len().into()),
            ("least", extreme(f64::min)),
            ("most", extreme(f64::max)),
            ("largest", length(largest)),
            ("formula", formula.into()),
        ],
    )
}
