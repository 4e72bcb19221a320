//! Plans, with the fields of `schemas/plan.schema.json`.

use federpendel_fit::plan::{Law, Limit, Pair, Plan, Prospect, RESOLVED, Resolution, Row};
use federpendel_report::plan::sentences;
use federpendel_text::Catalogue;
use serde::Serialize;

use super::document::Schema;
use crate::output::fit::{law_names, quantity_name};

#[derive(Serialize)]
pub(super) struct PlanDocument {
    schema: Schema,
    setup: SetupFields,
    threshold: f64,
    advice: Option<AdviceFields>,
    sentences: Vec<String>,
    laws: Vec<LawFields>,
    pairs: Vec<PairFields>,
    limits: Vec<LimitFields>,
    amplitudes: Vec<RowFields>,
}

#[derive(Serialize)]
struct SetupFields {
    quantity: &'static str,
    noise: f64,
    rate: f64,
    min_amplitude: f64,
    max_amplitude: f64,
    duration: f64,
    mass: f64,
    stiffness: f64,
    expected: Vec<&'static str>,
    fitted: Vec<&'static str>,
}

#[derive(Serialize)]
struct AdviceFields {
    amplitude: f64,
    duration: f64,
    laws: Vec<&'static str>,
}

#[derive(Serialize)]
struct LawFields {
    law: &'static str,
    parameter: &'static str,
    unit: &'static str,
    value: f64,
    smallest: Option<SmallestFields>,
    drowned: Option<f64>,
    largest: Option<ResolutionFields>,
    noise_factor: Option<f64>,
    beyond: Option<f64>,
}

#[derive(Serialize)]
struct SmallestFields {
    amplitude: f64,
    #[serde(flatten)]
    resolution: ResolutionFields,
}

#[derive(Serialize)]
struct ResolutionFields {
    duration: f64,
    stderr: f64,
    significance: f64,
}

#[derive(Serialize)]
struct PairFields {
    laws: [&'static str; 2],
    correlation: f64,
    separated: bool,
}

#[derive(Serialize)]
struct LimitFields {
    law: &'static str,
    parameter: &'static str,
    unit: &'static str,
    duration: f64,
    stderr: f64,
    resolved: f64,
    upper95: f64,
}

#[derive(Serialize)]
struct RowFields {
    amplitude: f64,
    longest: f64,
    stokes: Option<ResolutionFields>,
    coulomb: Option<ResolutionFields>,
    newton: Option<ResolutionFields>,
}

impl PlanDocument {
    pub(super) fn new(plan: &Plan, catalogue: &Catalogue) -> Self {
        let setup = &plan.setup;
        PlanDocument {
            schema: Schema { name: "federpendel-plan", version: 1 },
            setup: SetupFields {
                quantity: quantity_name(setup.quantity),
                noise: setup.noise,
                rate: setup.rate,
                min_amplitude: setup.smallest(),
                max_amplitude: setup.max_amplitude,
                duration: setup.longest(),
                mass: setup.oscillator.mass(),
                stiffness: setup.oscillator.stiffness(),
                expected: law_names(setup.expected()),
                fitted: law_names(setup.fitted()),
            },
            threshold: RESOLVED,
            advice: plan.advice().map(|advice| AdviceFields {
                amplitude: advice.amplitude,
                duration: advice.duration,
                laws: law_names(advice.laws),
            }),
            sentences: sentences(catalogue, plan),
            laws: plan.prospects.iter().map(law).collect(),
            pairs: plan.pairs.iter().map(pair).collect(),
            limits: plan.limits.iter().map(limit).collect(),
            amplitudes: plan.rows.iter().map(row).collect(),
        }
    }
}

/// The name of a law.
fn named(law: Law) -> &'static str {
    law_names(law.alone()).first().copied().unwrap_or_default()
}

fn resolution(known: Resolution) -> ResolutionFields {
    let Resolution { duration, stderr, significance } = known;
    ResolutionFields { duration, stderr, significance }
}

fn law(prospect: &Prospect) -> LawFields {
    let law = prospect.law;
    let smallest = |(amplitude, known)| SmallestFields { amplitude, resolution: resolution(known) };
    LawFields {
        law: named(law),
        parameter: law.parameter(),
        unit: law.unit(),
        value: prospect.coefficient,
        smallest: prospect.smallest.map(smallest),
        drowned: prospect.drowned,
        largest: prospect.largest.map(resolution),
        // Where it is resolved nothing more is needed.
        noise_factor: prospect.noise_factor().filter(|_| prospect.smallest.is_none()),
        beyond: prospect.beyond,
    }
}

fn pair(pair: &Pair) -> PairFields {
    let Pair { laws, correlation, separated } = *pair;
    PairFields { laws: laws.map(named), correlation, separated }
}

fn limit(limit: &Limit) -> LimitFields {
    let law = limit.law;
    LimitFields {
        law: named(law),
        parameter: law.parameter(),
        unit: law.unit(),
        duration: limit.duration,
        stderr: limit.stderr,
        resolved: limit.resolved(),
        upper95: limit.upper95(),
    }
}

fn row(row: &Row) -> RowFields {
    let [stokes, coulomb, newton] = row.laws.map(|known| known.map(resolution));
    RowFields { amplitude: row.amplitude, longest: row.longest, stokes, coulomb, newton }
}
