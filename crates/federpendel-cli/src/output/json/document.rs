//! The fields of the JSON.

use federpendel::{Mode, NormalForce, Oscillator, Outcome, Sample, TurningPoint};
use serde::{Serialize, Serializer};

use crate::record::{Record, Source};

/// Which schema a document fits.
#[derive(Serialize)]
pub(super) struct Schema {
    pub(super) name: &'static str,
    pub(super) version: u32,
}

#[derive(Serialize)]
struct OscillatorFields {
    mass: f64,
    stiffness: f64,
    gravity: Option<f64>,
    normal_force: f64,
    damping: f64,
    kinetic: f64,
    #[serde(rename = "static")]
    static_: f64,
    newton_coefficient: f64,
}

#[derive(Serialize)]
struct Derived {
    angular_frequency: f64,
    frequency: Option<f64>,
    period: Option<f64>,
    damping_rate: f64,
    damping_ratio: f64,
    quality_factor: Option<f64>,
    logarithmic_decrement: Option<f64>,
    regime: &'static str,
    offset: f64,
    sticking_offset: f64,
    newton_rate: f64,
}

#[derive(Serialize)]
struct Samples<'a> {
    time: Column<'a>,
    position: Column<'a>,
    velocity: Column<'a>,
    acceleration: Column<'a>,
    mode: Modes<'a>,
}

/// One quantity of all samples; `get` says which.
struct Column<'a> {
    samples: &'a [Sample],
    get: fn(&Sample) -> f64,
}

impl Serialize for Column<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // Adding zero turns −0 into 0.
        serializer.collect_seq(self.samples.iter().map(|sample| (self.get)(sample) + 0.0))
    }
}

struct Modes<'a>(&'a [Sample]);

impl Serialize for Modes<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let number = |mode: Mode| mode as i8;
        serializer.collect_seq(self.0.iter().map(|sample| number(sample.mode)))
    }
}

#[derive(Serialize)]
struct Point {
    time: f64,
    position: f64,
}

impl From<TurningPoint> for Point {
    fn from(point: TurningPoint) -> Self {
        Point { time: point.time, position: point.position }
    }
}

#[derive(Serialize)]
struct RestFields {
    time: f64,
    position: f64,
    margin: f64,
    tie: bool,
}

#[derive(Serialize)]
struct Energy {
    initial: f64,
    kinetic: f64,
    potential: f64,
    heat: Option<HeatFields>,
}

#[derive(Serialize)]
struct HeatFields {
    stokes: f64,
    coulomb: f64,
    newton: f64,
}

/// Turning points, written one by one as they are found.
struct Points<'a>(&'a Record);

impl Serialize for Points<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.turning_points().map(Point::from))
    }
}

/// How samples that are not exact were made.
#[derive(Serialize)]
struct MethodFields {
    method: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    equation: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    dt: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    interpolated: Option<bool>,
}

impl MethodFields {
    fn new(record: &Record) -> Option<Self> {
        let other = record.other.as_ref()?;
        let (equation, dt, interpolated) = match other.source {
            Source::Equation(number) => (Some(number), None, None),
            Source::Steps { time_step, interpolated } => {
                (None, Some(time_step), Some(interpolated))
            }
        };
        Some(Self { method: record.method.name(), equation, dt, interpolated })
    }
}

/// The whole JSON. What only the exact motion knows is null for other methods.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    schema: Schema,
    oscillator: OscillatorFields,
    derived: Derived,
    #[serde(flatten)]
    method: Option<MethodFields>,
    kind: Option<&'static str>,
    error_bound: Option<f64>,
    samples: Samples<'a>,
    turning_points: Option<Points<'a>>,
    rest: Option<RestFields>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rest_unknown_after: Option<f64>,
    limit: Option<f64>,
    energy: Energy,
}

impl<'a> Document<'a> {
    pub(super) fn new(record: &'a Record, schema: &'static str) -> federpendel::Result<Self> {
        let exact = record.other.is_none();
        let ends = if exact { Ends::new(&record.outcome) } else { Ends::default() };
        let bound = record.motion.error_bound(record.duration)?;
        Ok(Self {
            schema: Schema { name: schema, version: 1 },
            oscillator: oscillator(record),
            derived: derived(record.motion.oscillator()),
            method: MethodFields::new(record),
            kind: exact.then(|| record.motion.kind().name()),
            error_bound: exact.then_some(bound),
            samples: samples(record.samples()),
            turning_points: exact.then_some(Points(record)),
            rest: ends.rest,
            rest_unknown_after: ends.unknown_after,
            limit: ends.limit,
            energy: energy(record)?,
        })
    }
}

fn oscillator(record: &Record) -> OscillatorFields {
    let oscillator = record.motion.oscillator();
    let friction = oscillator.friction();
    let normal_force = record.experiment.normal_force;
    let gravity = match normal_force {
        NormalForce::Weight(gravity) => Some(gravity),
        NormalForce::Given(_) => None,
    };
    OscillatorFields {
        mass: oscillator.mass(),
        stiffness: oscillator.stiffness(),
        gravity,
        normal_force: normal_force.force(oscillator.mass()),
        damping: friction.stokes.map_or(0.0, |law| law.damping()),
        kinetic: friction.coulomb.map_or(0.0, |law| law.kinetic()),
        static_: friction.coulomb.map_or(0.0, |law| law.static_coefficient()),
        newton_coefficient: friction.newton.map_or(0.0, |law| law.coefficient()),
    }
}

fn derived(oscillator: &Oscillator) -> Derived {
    Derived {
        angular_frequency: oscillator.angular_frequency(),
        frequency: oscillator.frequency(),
        period: oscillator.period(),
        damping_rate: oscillator.damping_rate(),
        damping_ratio: oscillator.damping_ratio(),
        quality_factor: oscillator.quality_factor(),
        logarithmic_decrement: oscillator.logarithmic_decrement(),
        regime: oscillator.regime().name(),
        offset: oscillator.offset(),
        sticking_offset: oscillator.sticking_offset(),
        newton_rate: oscillator.newton_rate(),
    }
}

fn samples(samples: &[Sample]) -> Samples<'_> {
    let column = |get| Column { samples, get };
    Samples {
        time: column(|sample| sample.time),
        position: column(|sample| sample.position),
        velocity: column(|sample| sample.velocity),
        acceleration: column(|sample| sample.acceleration),
        mode: Modes(samples),
    }
}

/// How the motion ends, as fields.
#[derive(Default)]
struct Ends {
    rest: Option<RestFields>,
    unknown_after: Option<f64>,
    limit: Option<f64>,
}

impl Ends {
    fn new(outcome: &Outcome) -> Self {
        match *outcome {
            Outcome::Rests(rest) => {
                let fields = RestFields {
                    time: rest.time,
                    position: rest.position + 0.0,
                    margin: rest.margin,
                    tie: rest.tie,
                };
                Ends { rest: Some(fields), ..Ends::default() }
            }
            Outcome::Creeps { limit } => Ends { limit: Some(limit + 0.0), ..Ends::default() },
            Outcome::Unknown { after, .. } => {
                Ends { unknown_after: Some(after), ..Ends::default() }
            }
            _ => Ends::default(),
        }
    }
}

fn energy(record: &Record) -> federpendel::Result<Energy> {
    let initial = record.motion.initial_energy();
    if let Some((kinetic, potential)) = record.other_energy() {
        return Ok(Energy { initial, kinetic, potential, heat: None });
    }
    let ledger = record.ledger_at_end()?;
    let heat = HeatFields {
        stokes: ledger.heat.stokes,
        coulomb: ledger.heat.coulomb,
        newton: ledger.heat.newton,
    };
    Ok(Energy { initial, kinetic: ledger.kinetic, potential: ledger.potential, heat: Some(heat) })
}
