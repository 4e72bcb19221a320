//! The graphs of the report: a motion with formulas and schemes over it, and their errors below.

use federpendel::article::Formula;
use federpendel::{Result, TurningPoint, even_times, lens};
use federpendel_text::plot::{
    AveragedLaw, DecrementData, ErrorsData, MethodCurve, MethodErrors, MotionData, OverlayData,
    Plot, swings,
};

use super::Case;
use super::measure::{article_scheme, position};
use super::writer::Writer;

/// Samples of a curve.
const SAMPLES: usize = 1501;

/// Distances of less than this part of the largest are left out of a graph.
const FAINT: f64 = 1e-5;

/// Turning points that a graph can show.
const PLOTTED: usize = 2000;

/// A curve over a motion.
pub struct Curve {
    name: String,
    number: usize,
    positions: Vec<f64>,
}

/// What is drawn over a motion, and in which look: the same in every graph of the report.
#[derive(Clone, Copy)]
pub enum Look {
    /// A formula as printed.
    Printed,
    /// A formula with its errors put right.
    Corrected,
    /// The article's scheme.
    Scheme,
}

impl Look {
    fn number(self) -> usize {
        match self {
            Look::Printed => 1,
            Look::Corrected => 2,
            Look::Scheme => 0,
        }
    }
}

/// Times of a graph of this motion, s.
pub fn times(case: &Case) -> Result<Vec<f64>> {
    even_times(case.duration, SAMPLES)
}

/// A formula at `times`.
pub fn formula(name: String, look: Look, formula: &Formula, times: &[f64]) -> Curve {
    curve(name, look, times, |time| position(formula, time))
}

/// Any function of time at `times`.
pub fn curve(name: String, look: Look, times: &[f64], value: impl Fn(f64) -> f64) -> Curve {
    Curve {
        name,
        number: look.number(),
        positions: times.iter().map(|time| value(*time)).collect(),
    }
}

/// The article's scheme at `times`; none where it runs away.
pub fn scheme(name: String, case: &Case, times: &[f64]) -> Option<Curve> {
    let mut course = lens::Course::new(article_scheme(), &case.setting()).ok()?;
    let positions: Result<Vec<f64>> =
        times.iter().map(|time| course.at(*time).map(|state| state.position)).collect();
    Some(Curve { name, number: Look::Scheme.number(), positions: positions.ok()? })
}

/// A motion as it is drawn.
struct Record {
    times: Vec<f64>,
    positions: Vec<f64>,
    turning_points: Vec<TurningPoint>,
}

fn record(case: &Case) -> Result<Record> {
    let times = times(case)?;
    let samples = case.motion.samples(&times)?;
    let positions = samples.iter().map(|sample| sample.position).collect();
    Ok(Record { times, positions, turning_points: turning_points(case).collect() })
}

/// The turning points within the record, as many as a graph can show.
fn turning_points(case: &Case) -> impl Iterator<Item = TurningPoint> + '_ {
    case.motion.turning_points().take(PLOTTED).take_while(|point| point.time <= case.duration)
}

/// The motion with curves over it, and their distances from it below.
pub fn beside(writer: &Writer<'_>, case: &Case, curves: &[Curve]) -> Result<Vec<Plot>> {
    let Record { times, positions, turning_points } = record(case)?;
    let methods: Vec<_> = curves
        .iter()
        .map(|curve| MethodCurve {
            name: &curve.name,
            number: curve.number,
            times: &times,
            positions: &curve.positions,
        })
        .collect();
    let errors: Vec<Vec<f64>> =
        curves.iter().map(|curve| visible(distances_of(&curve.positions, &positions))).collect();
    let distances: Vec<_> = curves
        .iter()
        .zip(&errors)
        .map(|(curve, errors)| MethodErrors {
            name: &curve.name,
            number: curve.number,
            times: &times,
            errors,
        })
        .collect();
    let oscillator = case.oscillator();
    let mix = oscillator.friction().mix();
    let above = Plot::beside(
        writer.catalogue,
        &OverlayData {
            mix,
            kind: case.motion.kind(),
            times: &times,
            positions: &positions,
            turning_points: &turning_points,
            outcome: &case.motion.outcome(),
            sticking_offset: oscillator.sticking_offset(),
            methods: &methods,
        },
    );
    if curves.is_empty() {
        return Ok(vec![above]);
    }
    let amplitude = case.motion.amplitude();
    let below = Plot::errors(writer.catalogue, &ErrorsData { mix, amplitude, methods: &distances });
    Ok(vec![above, below])
}

fn distances_of(curve: &[f64], exact: &[f64]) -> Vec<f64> {
    curve.iter().zip(exact).map(|(curve, exact)| curve - exact).collect()
}

/// Distances without those that are far below the largest, which are not drawn if they are zero: a curve that happens
/// to touch the motion would stretch a logarithmic axis far down.
fn visible(distances: Vec<f64>) -> Vec<f64> {
    let largest = distances.iter().fold(0.0, |most: f64, distance| most.max(distance.abs()));
    let seen = |distance: f64| if distance.abs() < FAINT * largest { 0.0 } else { distance };
    distances.into_iter().map(seen).collect()
}

/// The motion by itself, between its envelopes.
pub fn motion(writer: &Writer<'_>, case: &Case) -> Result<Plot> {
    let Record { times, positions, turning_points } = record(case)?;
    let oscillator = case.oscillator();
    Ok(Plot::motion(
        writer.catalogue,
        &MotionData {
            mix: oscillator.friction().mix(),
            times: &times,
            positions: &positions,
            turning_points: &turning_points,
            from_rest: case.release().velocity == 0.0,
            outcome: &case.motion.outcome(),
            sticking_offset: oscillator.sticking_offset(),
        },
    ))
}

/// What each swing loses.
pub fn decrement(writer: &Writer<'_>, case: &Case) -> Plot {
    let law = AveragedLaw::of(case.oscillator());
    let data = DecrementData { law, swings: &swings(&amplitudes(case)), mean_of: 1, length: "m" };
    Plot::decrement(writer.catalogue, &data)
}

/// Displacements at the turning points within the record, the release first if it is one, m.
pub fn amplitudes(case: &Case) -> Vec<f64> {
    let release = (case.release().velocity == 0.0).then_some(case.release().position);
    release.into_iter().chain(turning_points(case).map(|point| point.position)).collect()
}
