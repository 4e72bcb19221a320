//! What a swing costs, averaged over it: one law with a part for each kind of friction.

use std::f64::consts::PI;

use federpendel::{Mix, Oscillator};

use super::Role;
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// The loss of amplitude per swing that averaging over a swing of slow decay gives, ΔA = 2f + (πγ/ω0) A + (4/3) κ A²
/// (Krylov and Bogoliubov 1937). A law of friction that does not act has no coefficient.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AveragedLaw {
    /// The offset of dry friction, f, a length.
    pub offset: Option<f64>,
    /// The damping ratio γ/ω0 of Stokes friction.
    pub damping_ratio: Option<f64>,
    /// The rate κ of Newton friction, over a length.
    pub newton_rate: Option<f64>,
}

/// A part of the averaged law: what it is called, and the loss at an amplitude.
pub(super) struct Part {
    pub name: String,
    pub formula: &'static str,
    pub role: Role,
    pub loss: Box<dyn Fn(f64) -> f64>,
}

/// Points of a curve.
const POINTS: u32 = 101;

impl AveragedLaw {
    /// The law of an oscillator; lengths in m.
    pub fn of(oscillator: &Oscillator) -> Self {
        let mix = oscillator.friction().mix();
        Self {
            offset: mix.coulomb.then(|| oscillator.offset()),
            damping_ratio: mix.stokes.then(|| oscillator.damping_ratio()),
            newton_rate: mix.newton.then(|| oscillator.newton_rate()),
        }
    }

    /// The laws of friction that act.
    pub fn mix(&self) -> Mix {
        Mix {
            stokes: self.damping_ratio.is_some(),
            coulomb: self.offset.is_some(),
            newton: self.newton_rate.is_some(),
        }
    }

    /// The parts that act, for amplitudes in the unit `length`.
    pub(super) fn parts(&self, catalogue: &Catalogue, length: &str) -> Vec<Part> {
        let name = |id: &str, value: f64, unit: &str| {
            let value = catalogue.quantity(value, unit, DIGITS);
            catalogue.format(id, &[("value", value.into())])
        };
        let mut parts = Vec::new();
        if let Some(offset) = self.offset {
            let intercept = 2.0 * offset;
            let name = name("plot-decrement-coulomb", intercept, length);
            let loss = Box::new(move |_| intercept);
            parts.push(Part { name, formula: "2f", role: Role::Coulomb, loss });
        }
        if let Some(ratio) = self.damping_ratio {
            let slope = PI * ratio;
            let name = name("plot-decrement-stokes", slope, "1");
            let loss = Box::new(move |amplitude| slope * amplitude);
            parts.push(Part { name, formula: "(πγ/ω₀) A", role: Role::Stokes, loss });
        }
        if let Some(rate) = self.newton_rate {
            let curvature = 4.0 / 3.0 * rate;
            let unit = if length == "1" { "1".to_owned() } else { format!("1/{length}") };
            let name = name("plot-decrement-newton", curvature, &unit);
            let loss = Box::new(move |amplitude| curvature * amplitude * amplitude);
            parts.push(Part { name, formula: "(4/3) κ A²", role: Role::Newton, loss });
        }
        parts
    }
}

/// Mean amplitude and loss of each swing between turning points at these displacements, of either sign.
pub fn swings(amplitudes: &[f64]) -> Vec<(f64, f64)> {
    let pairs = amplitudes.windows(2).map(|pair| (pair[0].abs(), pair[1].abs()));
    pairs.map(|(from, to)| ((from + to) / 2.0, from - to)).collect()
}

/// The loss of all parts together, from no amplitude to a little more than the largest.
pub(super) fn curve(parts: &[Part], largest: f64) -> Vec<(f64, f64)> {
    let at = |i: u32| 1.05 * largest * f64::from(i) / f64::from(POINTS - 1);
    (0..POINTS).map(|i| (at(i), loss(parts, at(i)))).collect()
}

/// The loss of all parts together at one amplitude.
pub(super) fn loss(parts: &[Part], amplitude: f64) -> f64 {
    parts.iter().map(|part| (part.loss)(amplitude)).sum()
}

/// The law as it is written, with the parts that act.
pub(super) fn formula(parts: &[Part]) -> String {
    let terms: Vec<_> = parts.iter().map(|part| part.formula).collect();
    format!("ΔA = {}", if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") })
}
