//! Fits, with the fields of `schemas/fit.schema.json`.

use std::collections::BTreeMap;

use federpendel_fit::{FitReport, Model, Parameter, Standing};
use federpendel_report::recording::{Fitted, sentences};
use federpendel_text::Catalogue;
use serde::Serialize;

use super::document::Schema;
use super::physical::{DampingFields, PhysicalFields};
use crate::fit::{Failed, Fits};
use crate::output::fit::{law_names, quantity_name, stop_name};

/// The fit of one recording.
#[derive(Serialize)]
pub(super) struct FitDocument {
    schema: Schema,
    #[serde(flatten)]
    fit: FitFields,
}

/// The fits of several recordings.
#[derive(Serialize)]
pub(super) struct FitsDocument {
    schema: Schema,
    fits: Vec<FitFields>,
    failed: Vec<FailedFields>,
}

#[derive(Serialize)]
struct FailedFields {
    name: String,
    problem: String,
}

#[derive(Serialize)]
struct FitFields {
    name: String,
    quantity: &'static str,
    column: String,
    unit: String,
    verdict: VerdictFields,
    parameters: BTreeMap<&'static str, ParameterFields>,
    correlations: BTreeMap<&'static str, BTreeMap<&'static str, f64>>,
    physical: Option<PhysicalFields>,
    damping: Option<DampingFields>,
    statistics: Statistics,
    models: Vec<ModelFields>,
    rest: Option<RestFields>,
    window: WindowFields,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct VerdictFields {
    laws: Vec<&'static str>,
    adequate: bool,
    sentences: Vec<String>,
    standing: OfLaws<&'static str>,
    p_values: OfLaws<Option<f64>>,
    energy_shares: Option<OfLaws<f64>>,
}

/// Something of each law.
#[derive(Serialize)]
struct OfLaws<T> {
    stokes: T,
    coulomb: T,
    newton: T,
}

impl<T> From<[T; 3]> for OfLaws<T> {
    fn from([stokes, coulomb, newton]: [T; 3]) -> Self {
        OfLaws { stokes, coulomb, newton }
    }
}

#[derive(Serialize)]
struct ParameterFields {
    value: Option<f64>,
    stderr: Option<f64>,
    interval95: [Option<f64>; 2],
    unit: String,
}

#[derive(Serialize)]
struct Statistics {
    n: usize,
    effective_n: f64,
    rms: f64,
    chi_square: f64,
    reduced_chi_square: f64,
    aic: f64,
    aicc: f64,
    bic: f64,
    sigma: Option<f64>,
    evaluations: usize,
    stop_reason: &'static str,
}

#[derive(Serialize)]
struct ModelFields {
    laws: Vec<&'static str>,
    aic: f64,
    aicc: f64,
    bic: f64,
    rms: f64,
}

#[derive(Serialize)]
struct RestFields {
    time: f64,
    position: f64,
}

#[derive(Serialize)]
struct WindowFields {
    from: f64,
    to: f64,
}

impl FitDocument {
    pub(super) fn new(fit: &Fitted, catalogue: &Catalogue) -> Option<Self> {
        let fit = fields(fit, catalogue)?;
        Some(FitDocument { schema: Schema { name: "federpendel-fit", version: 1 }, fit })
    }
}

impl FitsDocument {
    pub(super) fn new(fits: &Fits, catalogue: &Catalogue) -> Self {
        let failed = |failed: &Failed| FailedFields {
            name: failed.name.clone(),
            problem: failed.failure.sentence(),
        };
        FitsDocument {
            schema: Schema { name: "federpendel-fits", version: 1 },
            fits: fits.fitted.iter().filter_map(|fit| fields(fit, catalogue)).collect(),
            failed: fits.failed.iter().map(failed).collect(),
        }
    }
}

fn fields(fit: &Fitted, catalogue: &Catalogue) -> Option<FitFields> {
    let report = &fit.report;
    let best = report.best()?;
    let rest = best.rest.as_ref();
    Some(FitFields {
        name: fit.name.clone(),
        quantity: quantity_name(report.quantity),
        column: fit.read.value.label.clone(),
        unit: report.unit.clone(),
        verdict: verdict(fit, catalogue),
        parameters: best.parameters.iter().map(|one| (one.name, parameter(fit, one))).collect(),
        correlations: correlations(best),
        physical: PhysicalFields::new(fit, catalogue),
        damping: DampingFields::new(fit),
        statistics: statistics(report, best),
        models: report.models.iter().map(model).collect(),
        rest: rest.map(|rest| RestFields { time: rest.time, position: rest.position }),
        window: WindowFields { from: report.window.from, to: report.window.to },
        notes: fit.notes(catalogue),
    })
}

fn verdict(fit: &Fitted, catalogue: &Catalogue) -> VerdictFields {
    let report = &fit.report;
    let standing = report.verdict.laws.map(|standing| match standing {
        Standing::Acts => "acts",
        Standing::Open => "open",
        Standing::NotNeeded => "not-needed",
        Standing::Excluded => "excluded",
    });
    VerdictFields {
        laws: law_names(report.verdict.mix),
        adequate: report.adequacy.adequate,
        sentences: sentences(fit, catalogue),
        standing: standing.into(),
        p_values: report.verdict.p_values.into(),
        energy_shares: report.shares.map(OfLaws::from),
    }
}

fn parameter(fit: &Fitted, parameter: &Parameter) -> ParameterFields {
    let (low, high) = parameter.interval95;
    ParameterFields {
        value: parameter.value,
        stderr: parameter.stderr,
        interval95: [low, high],
        unit: fit.report.unit_of(parameter.name),
    }
}

/// Of each pair of parameters that are known together.
fn correlations(model: &Model) -> BTreeMap<&'static str, BTreeMap<&'static str, f64>> {
    let row = |(parameter, row): (&Parameter, &Vec<f64>)| {
        let others =
            model.parameters.iter().zip(row).filter(|(other, _)| other.name != parameter.name);
        (parameter.name, others.map(|(other, &r)| (other.name, r)).collect())
    };
    model.parameters.iter().zip(&model.correlations).map(row).collect()
}

fn statistics(report: &FitReport, model: &Model) -> Statistics {
    Statistics {
        n: report.samples,
        effective_n: report.effective_samples,
        rms: model.rms,
        chi_square: model.chi_square,
        reduced_chi_square: model.reduced,
        aic: model.criteria.aic,
        aicc: model.criteria.aicc,
        bic: model.criteria.bic,
        sigma: report.sigma,
        evaluations: report.evaluations,
        stop_reason: stop_name(model.stop_reason),
    }
}

fn model(model: &Model) -> ModelFields {
    ModelFields {
        laws: law_names(model.mix),
        aic: model.criteria.aic,
        aicc: model.criteria.aicc,
        bic: model.criteria.bic,
        rms: model.rms,
    }
}
