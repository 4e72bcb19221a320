//! What each swing costs: loss of amplitude against amplitude, where the laws of friction show as intercept,
//! slope and curvature.

use std::f64::consts::PI;

use federpendel::Oscillator;

use super::{Axis, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plot of the loss of amplitude shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct DecrementData<'a> {
    /// The oscillator, for the averaged law.
    pub oscillator: &'a Oscillator,
    /// Displacement at the turning points in order, of either sign, m; a release from rest is one.
    pub amplitudes: &'a [f64],
}

/// A part of the averaged law: what it is called, and the loss at an amplitude.
pub(super) struct Part {
    name: String,
    formula: &'static str,
    role: Role,
    loss: Box<dyn Fn(f64) -> f64>,
}

/// Most swings that are marked: more would hide the law.
const MOST_MARKERS: usize = 48;

/// Points of a curve.
const POINTS: u32 = 101;

impl Plot {
    /// |xₙ| − |xₙ₊₁| of each swing against (|xₙ| + |xₙ₊₁|)/2, with the loss that averaging over a swing
    /// of slow decay gives, ΔA = 2f + (πγ/ω0) A + (4/3) κ A², and its parts.
    pub fn decrement(catalogue: &Catalogue, data: &DecrementData<'_>) -> Self {
        let swings = swings(data.amplitudes);
        let parts = parts(catalogue, data.oscillator);
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let largest = most(&mut swings.iter().map(|swing| swing.0));
        let loss =
            most(&mut swings.iter().map(|swing| swing.1.abs())).max(loss_of(&parts, largest));
        let amplitude =
            Axis::new(catalogue, &catalogue.text("plot-mean-amplitude"), "A", "m", largest);
        let lost = Axis::new(catalogue, &catalogue.text("plot-loss"), "ΔA", "m", loss);
        let mix = data.oscillator.friction().mix();
        let title = catalogue.format("plot-decrement-title", &[("mix", catalogue.mix(mix).into())]);
        let mut plot = Plot::new(catalogue, title, amplitude.from_zero(), lost.from_zero());
        let formula = formula(&parts);
        if swings.is_empty() {
            let why = catalogue.text("plot-decrement-empty");
            plot.description = format!("{}: {why}.", plot.title);
            plot.notes.push(super::Note { text: why, point: (0.0, 0.0) });
            return plot;
        }
        plot.description = description(catalogue, &plot.title, &swings, largest, &formula);
        let markers = Style::Markers(Marker::Circle);
        let stride = swings.len().div_ceil(MOST_MARKERS);
        let name = match stride {
            1 => catalogue.text("plot-decrement-swings"),
            _ => catalogue.format("plot-decrement-some", &[("stride", stride.into())]),
        };
        plot.add(name, Role::Swings, markers, swings.into_iter().step_by(stride));
        if !parts.is_empty() {
            let name = catalogue.format("plot-decrement-law", &[("formula", formula.into())]);
            plot.add(name, Role::Exact, Style::WIDE, law(&parts, largest));
        }
        for part in &parts {
            let curve = law(std::slice::from_ref(part), largest);
            plot.add(part.name.clone(), part.role, Style::LONG_DASHED, curve);
        }
        plot
    }
}

/// Mean amplitude and loss of each swing.
pub(super) fn swings(amplitudes: &[f64]) -> Vec<(f64, f64)> {
    let pairs = amplitudes.windows(2).map(|pair| (pair[0].abs(), pair[1].abs()));
    pairs.map(|(from, to)| ((from + to) / 2.0, from - to)).collect()
}

/// The loss of all parts together, from no amplitude to a little more than the largest.
pub(super) fn law(parts: &[Part], largest: f64) -> Vec<(f64, f64)> {
    let at = |i: u32| 1.05 * largest * f64::from(i) / f64::from(POINTS - 1);
    (0..POINTS).map(|i| (at(i), loss_of(parts, at(i)))).collect()
}

fn loss_of(parts: &[Part], amplitude: f64) -> f64 {
    parts.iter().map(|part| (part.loss)(amplitude)).sum()
}

/// The parts of the averaged law that act.
pub(super) fn parts(catalogue: &Catalogue, oscillator: &Oscillator) -> Vec<Part> {
    let mix = oscillator.friction().mix();
    let name = |id: &str, value: f64, unit: &str| {
        let value = catalogue.quantity(value, unit, DIGITS);
        catalogue.format(id, &[("value", value.into())])
    };
    let mut parts = Vec::new();
    if mix.coulomb {
        let intercept = 2.0 * oscillator.offset();
        let name = name("plot-decrement-coulomb", intercept, "m");
        let loss = Box::new(move |_| intercept);
        parts.push(Part { name, formula: "2f", role: Role::Coulomb, loss });
    }
    if mix.stokes {
        let slope = PI * oscillator.damping_ratio();
        let name = name("plot-decrement-stokes", slope, "1");
        let loss = Box::new(move |amplitude| slope * amplitude);
        parts.push(Part { name, formula: "(πγ/ω₀) A", role: Role::Stokes, loss });
    }
    if mix.newton {
        let curvature = 4.0 / 3.0 * oscillator.newton_rate();
        let name = name("plot-decrement-newton", curvature, "m⁻¹");
        let loss = Box::new(move |amplitude| curvature * amplitude * amplitude);
        parts.push(Part { name, formula: "(4/3) κ A²", role: Role::Newton, loss });
    }
    parts
}

pub(super) fn formula(parts: &[Part]) -> String {
    let terms: Vec<_> = parts.iter().map(|part| part.formula).collect();
    format!("ΔA = {}", if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") })
}

fn description(
    catalogue: &Catalogue,
    title: &str,
    swings: &[(f64, f64)],
    largest: f64,
    formula: &str,
) -> String {
    let length = |value: f64| catalogue.quantity(value, "m", DIGITS).into();
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
