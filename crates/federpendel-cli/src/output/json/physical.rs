//! Physical numbers and engineers' figures of a fit.

use std::collections::BTreeMap;

use federpendel_fit::{Estimate, damping};
use federpendel_report::recording::{Fitted, physical_sentences};
use federpendel_text::Catalogue;
use serde::Serialize;

#[derive(Serialize)]
struct EstimateFields {
    value: Option<f64>,
    stderr: Option<f64>,
    interval95: [Option<f64>; 2],
    unit: &'static str,
}

impl From<Estimate> for EstimateFields {
    fn from(number: Estimate) -> Self {
        let Estimate { value, stderr, interval95: (low, high), unit } = number;
        Self { value, stderr, interval95: [low, high], unit }
    }
}

/// Numbers that need a mass, a stiffness or a normal force; null with a reason where one is missing.
#[derive(Serialize)]
pub(super) struct PhysicalFields {
    #[serde(flatten)]
    numbers: BTreeMap<&'static str, Option<EstimateFields>>,
    absent: BTreeMap<&'static str, &'static str>,
    agreement: Option<AgreementFields>,
    sentences: Vec<String>,
}

#[derive(Serialize)]
struct AgreementFields {
    ratio: f64,
    deviation: f64,
}

impl PhysicalFields {
    pub(super) fn new(fit: &Fitted, catalogue: &Catalogue) -> Option<Self> {
        let physical = fit.physical?;
        let numbers = physical.numbers();
        let agreement = physical.agreement;
        Some(Self {
            numbers: numbers.iter().map(|(name, one)| (*name, one.ok().map(Into::into))).collect(),
            absent: numbers.iter().filter_map(|(n, one)| Some((*n, one.err()?.name()))).collect(),
            agreement: agreement
                .map(|one| AgreementFields { ratio: one.ratio, deviation: one.deviation }),
            sentences: physical_sentences(fit, catalogue),
        })
    }
}

/// Figures that need no mass.
#[derive(Serialize)]
pub(super) struct DampingFields {
    natural_frequency: EstimateFields,
    damping_ratio: Option<EstimateFields>,
    logarithmic_decrement: Option<EstimateFields>,
    quality_factor: Option<EstimateFields>,
    equivalent: Vec<EquivalentFields>,
}

#[derive(Serialize)]
struct EquivalentFields {
    amplitude: f64,
    damping_ratio: f64,
    stderr: Option<f64>,
}

impl DampingFields {
    pub(super) fn new(fit: &Fitted) -> Option<Self> {
        let figures = damping(&fit.report)?;
        let equivalent = figures.equivalent.iter().map(|one| EquivalentFields {
            amplitude: one.amplitude,
            damping_ratio: one.damping_ratio,
            stderr: one.stderr,
        });
        Some(Self {
            natural_frequency: figures.natural_frequency.into(),
            damping_ratio: figures.damping_ratio.map(Into::into),
            logarithmic_decrement: figures.logarithmic_decrement.map(Into::into),
            quality_factor: figures.quality_factor.map(Into::into),
            equivalent: equivalent.collect(),
        })
    }
}
