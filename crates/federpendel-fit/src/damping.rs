//! Engineers' figures of a fit: natural frequency, damping ratio, decrement, quality factor, and for any mix the damping
//! ratio that loses as much energy per cycle.

use std::f64::consts::PI;

use federpendel::Mix;

use crate::Quantity;
use crate::model::{Parameters, Stop, evaluate};
use crate::propagation::{Estimate, Propagated, Source, Sources};
use crate::report::{FitReport, Model};

/// The figures of the verdict's mix. None of them needs a mass.
#[derive(Debug, Clone, PartialEq)]
pub struct Damping {
    /// f0 = ω0/2π, Hz: that of the oscillator without friction.
    pub natural_frequency: Estimate,
    /// ζ = γ/ω0 of the Stokes part, if there is one.
    pub damping_ratio: Option<Estimate>,
    /// Logarithmic decrement Λ = 2πζ/√(1 − ζ²), the logarithm of the ratio of amplitudes one period apart; none unless
    /// Stokes friction acts alone and lets the mass swing: else it depends on the amplitude.
    pub logarithmic_decrement: Option<Estimate>,
    /// Quality factor Q = 1/(2ζ); none unless Stokes friction acts alone.
    pub quality_factor: Option<Estimate>,
    /// The equivalent damping ratio from the first to the last amplitude of the fitted part; empty without friction,
    /// and where nothing swings.
    pub equivalent: Vec<Equivalent>,
}

/// The damping ratio of the viscous friction that takes as much energy from a harmonic cycle of this amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equivalent {
    /// The amplitude, in the unit of a length of the recording.
    pub amplitude: f64,
    /// ζ_eq.
    pub damping_ratio: f64,
    /// Its standard error, where one is known.
    pub stderr: Option<f64>,
}

/// At so many amplitudes the equivalent damping ratio is given.
const AMPLITUDES: i32 = 5;

/// The figures of the verdict's mix; none without one.
pub fn damping(report: &FitReport) -> Option<Damping> {
    let model = report.best()?;
    let sources = Sources::of(model);
    let omega = sources.number(Source::AngularFrequency);
    let frequency = omega * (1.0 / (2.0 * PI));
    let ratio = sources.number(Source::DampingRate) / omega;
    let estimate = |number, unit| sources.estimate(number, Source::DampingRate, unit);
    let stokes = model.mix.stokes.then(|| estimate(ratio, "1"));
    let alone = stokes.filter(|_| model.mix == Mix { stokes: true, ..Mix::default() });
    let swings = alone.filter(|_| ratio.value < 1.0);
    let figure = |number: Propagated, ends: (Option<f64>, Option<f64>)| Estimate {
        interval95: ends,
        ..estimate(number, "1")
    };
    Some(Damping {
        natural_frequency: sources.estimate(frequency, Source::AngularFrequency, "Hz"),
        damping_ratio: stokes,
        logarithmic_decrement: swings.map(|ratios| {
            let (low, high) = ratios.interval95;
            let end = |ratio: Option<f64>| {
                ratio.filter(|ratio| *ratio < 1.0).map(|r| decrement(Propagated::exact(r)).value)
            };
            figure(decrement(ratio), (end(low), end(high)))
        }),
        quality_factor: alone.filter(|_| ratio.value > 0.0).map(|ratios| {
            let (low, high) = ratios.interval95;
            let end = |ratio: Option<f64>| ratio.filter(|ratio| *ratio > 0.0).map(|r| 0.5 / r);
            figure(Propagated::exact(0.5) / ratio, (end(high), end(low)))
        }),
        equivalent: equivalent(report, model, &sources),
    })
}

/// Λ = 2πζ/√(1 − ζ²).
fn decrement(ratio: Propagated) -> Propagated {
    ratio * (2.0 * PI) / (Propagated::exact(1.0) - ratio * ratio).sqrt()
}

/// ζ_eq = γ/ω0 + 2a_c/(πω0²A) + 4κA/(3π).
///
/// A cycle x = A cos ω0t takes, per mass, 2πγω0A² by Stokes, 4a_cA by Coulomb and (8/3)κω0²A³ by Newton friction;
/// the viscous cycle with 4πζ·½ω0²A² takes as much at this ζ (equivalent viscous damping, Jacobsen 1930).
fn equivalent_ratio(sources: &Sources, amplitude: f64) -> Propagated {
    let number = |source: Source| sources.number(source);
    let omega = number(Source::AngularFrequency);
    let dry = number(Source::CoulombAcceleration) / (omega * omega);
    number(Source::DampingRate) / omega
        + dry * (2.0 / (PI * amplitude))
        + number(Source::NewtonRate) * (4.0 * amplitude / (3.0 * PI))
}

fn equivalent(report: &FitReport, model: &Model, sources: &Sources) -> Vec<Equivalent> {
    let swings = model.value("damping_rate") < model.value("angular_frequency");
    let damped = swings && model.mix != Mix::default();
    let Some((first, last)) = amplitudes(report, model).filter(|_| damped) else {
        return vec![];
    };
    let at = |i: i32| {
        let amplitude = first * (last / first).powf(f64::from(i) / f64::from(AMPLITUDES - 1));
        let ratio = equivalent_ratio(sources, amplitude);
        Equivalent { amplitude, damping_ratio: ratio.value, stderr: sources.stderr(&ratio) }
    };
    (0..AMPLITUDES).map(at).collect()
}

/// The first and the last amplitude of the fitted part: that of the energy at its beginning, and the last turning point
/// that the mass leaves again. None where nothing turns.
fn amplitudes(report: &FitReport, model: &Model) -> Option<(f64, f64)> {
    let p = Parameters::from_array(Parameters::NAMES.map(|name| model.value(name)));
    let stop = model.rest.as_ref().map_or(Stop::Never, |rest| Stop::After(rest.turning_points));
    let times = [report.window.from, report.window.to];
    let course = evaluate(&p, stop, &times, Quantity::Position, &mut [0.0; 2], None).ok()?;
    let turns = &course.turning_points;
    let left = turns.len() - usize::from(course.rest.is_some());
    let first = p.position0.hypot(p.velocity0 / p.angular_frequency);
    let last = turns[..left].last().map(|turn| turn.position.abs())?;
    (first > 0.0 && last > 0.0).then_some((first, last))
}
