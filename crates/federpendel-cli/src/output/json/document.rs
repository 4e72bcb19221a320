//! The fields of the JSON.

use federpendel::{Mode, NormalForce, Oscillator, Outcome, Sample, TurningPoint};
use serde::{Serialize, Serializer};

use crate::record::Record;

#[derive(Serialize)]
struct Schema {
    name: &'static str,
    version: u32,
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
    heat: HeatFields,
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

/// The whole JSON.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    schema: Schema,
    oscillator: OscillatorFields,
    derived: Derived,
    kind: &'static str,
    error_bound: f64,
    samples: Samples<'a>,
    turning_points: Points<'a>,
    rest: Option<RestFields>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rest_unknown_after: Option<f64>,
    limit: Option<f64>,
    energy: Energy,
}

impl<'a> Document<'a> {
    pub(super) fn new(record: &'a Record) -> federpendel::Result<Self> {
        let ends = Ends::new(&record.outcome);
        Ok(Self {
            schema: Schema { name: "federpendel-simulation", version: 1 },
            oscillator: oscillator(record),
            derived: derived(record.motion.oscillator()),
            kind: record.motion.kind().name(),
            error_bound: record.motion.error_bound(record.duration)?,
            samples: samples(&record.samples),
            turning_points: Points(record),
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
    let (gravity, normal_force) = match record.experiment.normal_force {
        NormalForce::Weight(gravity) => (Some(gravity), oscillator.mass() * gravity),
        NormalForce::Given(force) => (None, force),
    };
    OscillatorFields {
        mass: oscillator.mass(),
        stiffness: oscillator.stiffness(),
        gravity,
        normal_force,
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
    let ledger = record.ledger_at_end()?;
    Ok(Energy {
        initial: record.motion.initial_energy(),
        kinetic: ledger.kinetic,
        potential: ledger.potential,
        heat: HeatFields {
            stokes: ledger.heat.stokes,
            coulomb: ledger.heat.coulomb,
            newton: ledger.heat.newton,
        },
    })
}
