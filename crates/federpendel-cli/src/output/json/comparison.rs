//! Methods beside the exact motion, with the fields of `schemas/comparison.schema.json`.

use federpendel::lens::Rung;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::document::Document;
use crate::comparison::{Compared, Comparison, Measured};

/// The fields of `simulate`, and beside them the methods.
#[derive(Serialize)]
pub(super) struct ComparisonDocument<'a> {
    #[serde(flatten)]
    motion: Document<'a>,
    methods: Methods<'a>,
}

impl<'a> ComparisonDocument<'a> {
    pub(super) fn new(comparison: &'a Comparison) -> federpendel::Result<Self> {
        let motion = Document::new(&comparison.record, "federpendel-comparison")?;
        Ok(Self { motion, methods: Methods(comparison) })
    }
}

/// The methods by name, in the order in which they were asked for.
struct Methods<'a>(&'a Comparison);

impl Serialize for Methods<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let methods = &self.0.methods;
        let mut map = serializer.serialize_map(Some(methods.len()))?;
        for compared in methods {
            map.serialize_entry(compared.candidate.name(), &MethodFields::new(compared, self.0))?;
        }
        map.end()
    }
}

/// A method; of one that failed all is null but the reason.
#[derive(Serialize, Default)]
struct MethodFields<'a> {
    declared_order: Option<u32>,
    observed_order: Option<f64>,
    max_error: Option<f64>,
    time_of_max_error: Option<f64>,
    rms_error: Option<f64>,
    energy_error: Option<f64>,
    final_position: Option<f64>,
    sticks: Option<bool>,
    creep: Option<f64>,
    steps: Option<u64>,
    run_time: Option<f64>,
    ladder: Option<Vec<RungFields>>,
    failed: Option<String>,
    samples: Option<Samples<'a>>,
}

impl<'a> MethodFields<'a> {
    fn new(compared: &'a Compared, comparison: &'a Comparison) -> Self {
        let declared_order = compared.candidate.order();
        match &compared.found {
            Err(error) => {
                let failed = Some(error.to_string());
                MethodFields { declared_order, failed, ..MethodFields::default() }
            }
            Ok(measured) => MethodFields {
                declared_order,
                observed_order: measured.ladder.order(),
                max_error: Some(measured.errors.largest),
                time_of_max_error: Some(measured.errors.time_of_largest),
                rms_error: Some(measured.errors.root_mean_square),
                energy_error: measured.errors.energy,
                final_position: Some(measured.errors.final_position + 0.0),
                sticks: measured.sticks,
                creep: measured.creep,
                steps: Some(measured.errors.steps),
                run_time: Some(measured.run_time.as_secs_f64()),
                ladder: Some(measured.ladder.rungs.iter().map(RungFields::new).collect()),
                failed: None,
                samples: Some(Samples { comparison, measured }),
            },
        }
    }
}

/// A run with another step or tolerance.
#[derive(Serialize)]
struct RungFields {
    time_step: f64,
    tolerance: Option<f64>,
    max_error: f64,
    steps: u64,
}

impl RungFields {
    fn new(rung: &Rung) -> Self {
        let Rung { time_step, tolerance, error, steps } = *rung;
        RungFields { time_step, tolerance, max_error: error, steps }
    }
}

/// The states at the times of the record.
struct Samples<'a> {
    comparison: &'a Comparison,
    measured: &'a Measured,
}

impl Serialize for Samples<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let times: Vec<f64> = self.comparison.record.exact.iter().map(|s| s.time).collect();
        let states = &self.measured.states;
        let positions: Vec<f64> = states.iter().map(|state| state.position + 0.0).collect();
        let velocities: Vec<f64> = states.iter().map(|state| state.velocity + 0.0).collect();
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("time", &times)?;
        map.serialize_entry("position", &positions)?;
        map.serialize_entry("velocity", &velocities)?;
        map.end()
    }
}
