//! The quantities that the page's controls offer, from the core's table, each with a slider.

use federpendel::parameter::{self, ParameterInfo};
use federpendel_text::Catalogue;
use serde::Serialize;

/// A quantity with all that its control needs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Parameter {
    /// Name in experiment files and on the command line.
    pub name: &'static str,
    /// Symbol in formulas.
    pub symbol: &'static str,
    /// SI unit as it is printed; empty for a pure number.
    pub unit: String,
    /// What it is called.
    pub label: String,
    /// One line that says what it is.
    pub description: String,
    /// Which values are allowed, in words.
    pub allowed: String,
    /// How far a slider goes.
    pub slider: Slider,
    /// The value to begin with.
    pub value: f64,
}

/// How far a slider goes; the number field takes all that is allowed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Slider {
    /// Its lower end.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
    /// Whether equal ways are equal factors.
    pub logarithmic: bool,
}

const fn linear(low: f64, high: f64) -> Slider {
    Slider { low, high, logarithmic: false }
}

const fn factors(low: f64, high: f64) -> Slider {
    Slider { low, high, logarithmic: true }
}

/// The quantities of the page: slider, and the value to begin with. Those of the built-in experiment are its own; Stokes
/// and Newton friction have the coefficients that the report on the article takes.
pub const CONTROLS: [(&ParameterInfo, Slider, f64); 12] = [
    (&parameter::MASS, factors(0.01, 10.0), 0.5),
    (&parameter::STIFFNESS, factors(0.1, 1000.0), 20.0),
    (&parameter::POSITION, linear(-0.5, 0.5), 0.1),
    (&parameter::VELOCITY, linear(-2.0, 2.0), 0.0),
    (&parameter::GRAVITY, linear(0.0, 25.0), 9.81),
    (&parameter::NORMAL_FORCE, linear(0.0, 20.0), 4.905),
    (&parameter::DAMPING, linear(0.0, 10.0), 0.2),
    (&parameter::KINETIC, linear(0.0, 0.5), 0.02),
    (&parameter::STATIC, linear(0.0, 0.6), 0.02),
    (&parameter::DENSITY, factors(0.1, 2000.0), 1000.0),
    (&parameter::DRAG_COEFFICIENT, linear(0.0, 2.5), 0.47),
    (&parameter::AREA, factors(1e-5, 0.1), 1e-3),
];

/// Length of the record to begin with, s: that of the built-in experiment.
pub const DURATION: f64 = 5.5;

/// All quantities of the page, the length of the record last.
pub fn parameters(catalogue: &Catalogue) -> Vec<Parameter> {
    let duration = (&parameter::DURATION, factors(0.1, 1000.0), DURATION);
    CONTROLS.into_iter().chain([duration]).map(|control| described(catalogue, control)).collect()
}

fn described(
    catalogue: &Catalogue,
    (info, slider, value): (&ParameterInfo, Slider, f64),
) -> Parameter {
    let text = catalogue.parameter(info);
    Parameter {
        name: info.name,
        symbol: info.symbol,
        unit: text.unit,
        label: text.name,
        description: text.description,
        allowed: text.allowed,
        slider,
        value,
    }
}
