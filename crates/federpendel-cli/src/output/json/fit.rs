//! Fits, with the fields of `schemas/fit.schema.json`.

use std::collections::BTreeMap;

use federpendel::Mix;
use federpendel_fit::{Model, Parameter, Quantity};
use federpendel_report::recording::{Fitted, sentences};
use federpendel_text::Catalogue;
use serde::Serialize;

use super::document::Schema;
#[derive(Serialize)]
pub(super) struct FitsDocument {
    schema: Schema,
    fits: Vec<FitFields>,
}

#[derive(Serialize)]
struct FitFields {
    name: String,
    quantity: &'static str,
    column: String,
    unit: String,
    verdict: VerdictFields,
    parameters: BTreeMap<&'static str, ParameterFields>,
    statistics: Statistics,
    models: Vec<ModelFields>,
    rest: Option<RestFields>,
    window: WindowFields,
}

#[derive(Serialize)]
struct VerdictFields {
    laws: Vec<&'static str>,
    adequate: bool,
    sentences: Vec<String>,
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
    evaluations: usize,
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

impl FitsDocument {
    pub(super) fn new(fits: &[Fitted], catalogue: &Catalogue) -> Self {
        let fields = |fit: &Fitted| fields(fit, catalogue);
        FitsDocument {
            schema: Schema { name: "federpendel-fit", version: 1 },
            fits: fits.iter().filter_map(fields).collect(),
        }
    }
}

fn fields(fit: &Fitted, catalogue: &Catalogue) -> Option<FitFields> {
    let report = &fit.report;
    let best = report.best()?;
    Some(FitFields {
        name: fit.name.clone(),
        quantity: quantity(report.quantity),
        column: fit.read.value.label.clone(),
        unit: report.unit.clone(),
        verdict: VerdictFields {
            laws: laws(report.verdict.mix),
            adequate: report.adequacy.adequate,
            sentences: sentences(fit, catalogue),
        },
        parameters: best.parameters.iter().map(|one| (one.name, parameter(fit, one))).collect(),
        statistics: Statistics {
            n: report.samples,
            effective_n: report.effective_samples,
            rms: best.rms,
            chi_square: best.chi_square,
            reduced_chi_square: best.reduced,
            aic: best.criteria.aic,
            aicc: best.criteria.aicc,
            bic: best.criteria.bic,
            evaluations: report.evaluations,
        },
        models: report.models.iter().map(model).collect(),
        rest: best
            .rest
            .as_ref()
            .map(|rest| RestFields { time: rest.time, position: rest.position }),
        window: WindowFields { from: report.window.from, to: report.window.to },
    })
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

fn model(model: &Model) -> ModelFields {
    ModelFields {
        laws: laws(model.mix),
        aic: model.criteria.aic,
        aicc: model.criteria.aicc,
        bic: model.criteria.bic,
        rms: model.rms,
    }
}

/// The name of what is recorded.
pub(super) fn quantity(quantity: Quantity) -> &'static str {
    let named = crate::args::QUANTITIES.iter().find(|(_, known)| *known == quantity);
    named.map_or("position", |(name, _)| name)
}

/// The names of the laws of a mix.
pub(in crate::output) fn laws(mix: Mix) -> Vec<&'static str> {
    let named = [(mix.stokes, "stokes"), (mix.coulomb, "coulomb"), (mix.newton, "newton")];
    named.into_iter().filter(|(acts, _)| *acts).map(|(_, name)| name).collect()
}
