//! A law of friction as a sentence about a fit names it.

use federpendel::Mix;
use federpendel_fit::{Model, Parameter};
use federpendel_text::Catalogue;

use super::Fitted;

/// A law: its name, the symbol and the parameter that say how strongly it acts.
pub struct Law {
    name: &'static str,
    inside: &'static str,
    symbol: &'static str,
    parameter: &'static str,
    /// Whether it is in a mix.
    pub acts: fn(Mix) -> bool,
}

/// The laws, in the order of the verdict.
pub const LAWS: [Law; 3] = [
    Law {
        name: "fit-law-stokes",
        inside: "fit-law-stokes.inside",
        symbol: "γ",
        parameter: "damping_rate",
        acts: |mix| mix.stokes,
    },
    Law {
        name: "fit-law-coulomb",
        inside: "fit-law-coulomb.inside",
        symbol: "a_c",
        parameter: "coulomb_acceleration",
        acts: |mix| mix.coulomb,
    },
    Law {
        name: "fit-law-newton",
        inside: "fit-law-newton.inside",
        symbol: "κ",
        parameter: "newton_rate",
        acts: |mix| mix.newton,
    },
];

impl Law {
    /// Its name at the beginning of a sentence.
    pub fn name(&self, catalogue: &Catalogue) -> String {
        catalogue.text(self.name)
    }

    /// Its name inside a sentence.
    pub fn inside(&self, catalogue: &Catalogue) -> String {
        catalogue.text(self.inside)
    }

    /// How strongly it acts: `γ = 0.053 ± 0.002 1/s`, or at least: `a_c ≥ 0.72 m/s²`.
    pub fn value(&self, fit: &Fitted, model: &Model, catalogue: &Catalogue) -> String {
        let parameter = model.parameter(self.parameter);
        let unit = fit.report.unit_of(self.parameter);
        if let Some(Parameter { value: None, interval95: (Some(least), None), .. }) = parameter {
            return format!("{} ≥ {}", self.symbol, catalogue.quantity(*least, &unit, 2));
        }
        let value = parameter.and_then(|parameter| parameter.value).unwrap_or(0.0);
        let error = parameter.and_then(|parameter| parameter.stderr).unwrap_or(f64::NAN);
        format!("{} = {}", self.symbol, catalogue.measured(value, error, &unit))
    }

    /// The most that it could be beside the verdict's mix: `κ < 0.02 1/m`.
    pub fn limit(&self, fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
        let report = &fit.report;
        let beside = report.models.iter().find(|model| {
            LAWS.iter().all(|law| {
                let acts = (law.acts)(report.verdict.mix) || law.parameter == self.parameter;
                (law.acts)(model.mix) == acts
            })
        })?;
        let most = beside.parameter(self.parameter)?.interval95.1?;
        let most = catalogue.quantity(most, &report.unit_of(self.parameter), 2);
        Some(format!("{} < {most}", self.symbol))
    }

    /// How many standard errors it is away from none.
    pub fn sigmas(&self, model: &Model) -> Option<f64> {
        let parameter = model.parameter(self.parameter)?;
        Some(parameter.value? / parameter.stderr?)
    }
}
