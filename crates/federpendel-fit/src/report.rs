//! What a fit found: numbers and reasons, no sentences.

use federpendel::Mix;

use crate::Quantity;
use crate::adequacy::Adequacy;
use crate::clipping::Clipping;
use crate::least_squares::StopReason;
use crate::noise::Excess;
use crate::options::{Laws, Loss};
use crate::ranking::{Criteria, Ranking, Verdict};
use crate::reach::Reach;
use crate::stop::Rest;
use crate::window::Window;

/// A parameter of a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Its name, as in the field of [`crate::Parameters`], or `static_acceleration`.
    pub name: &'static str,
    /// Its value; none where only an interval is known.
    pub value: Option<f64>,
    /// Its standard error; none where it is not known.
    pub stderr: Option<f64>,
    /// Its 95 % interval, open where an end is none. That of a coefficient begins at zero where
    /// zero fits.
    pub interval95: (Option<f64>, Option<f64>),
    /// Whether it ended at the edge of what is allowed, zero.
    pub at_bound: bool,
}

/// The fit of one mix.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// The laws that may act in it.
    pub mix: Mix,
    /// The fitted parameters; `static_acceleration` last, where the mass rests.
    pub parameters: Vec<Parameter>,
    /// Correlations of the fitted parameters, in their order.
    pub correlations: Vec<Vec<f64>>,
    /// Σ of the squared residuals, in σ² where σ is given.
    pub chi_square: f64,
    /// The same per degree of freedom.
    pub reduced: f64,
    /// Root mean square of the residuals, in the unit of the values.
    pub rms: f64,
    /// Information criteria, of the effective number of values.
    pub criteria: Criteria,
    /// Why the search ended.
    pub stop_reason: StopReason,
    /// Where the mass rests, if it does.
    pub rest: Option<Rest>,
}

impl Model {
    /// The parameter of this name, if it is fitted.
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }

    /// The value of the parameter of this name, or the least where only that is known; zero for a law that the mix has not.
    pub fn value(&self, name: &str) -> f64 {
        let known = |parameter: &Parameter| parameter.value.or(parameter.interval95.0);
        self.parameter(name).and_then(known).unwrap_or(0.0)
    }
}

/// All that a fit found.
#[derive(Debug, Clone, PartialEq)]
pub struct FitReport {
    /// What was recorded.
    pub quantity: Quantity,
    /// The laws that were asked for.
    pub laws: Laws,
    /// Unit of the values; that of their length is `u` where the recording names none.
    pub unit: String,
    /// The part that was fitted.
    pub window: Window,
    /// Number of values in it.
    pub samples: usize,
    /// So many independent values tell as much about the motion.
    pub effective_samples: f64,
    /// By how much the residuals that hang together exceed white noise.
    pub excess: Excess,
    /// Every mix, by AICc, best first.
    pub models: Vec<Model>,
    /// Which laws act.
    pub verdict: Verdict,
    /// What that follows from.
    pub ranking: Ranking,
    /// Where a mix was asked for that is not that of all laws: with this probability one with further laws fits better by as
    /// much, if it were right.
    pub asked_rejection: Option<f64>,
    /// Whether the verdict's mix describes the motion, and what is wrong where not.
    pub adequacy: Adequacy,
    /// The shares of Stokes, Coulomb and Newton friction in the energy lost in the window; none if nothing
    /// is lost.
    pub shares: Option<[f64; 3]>,
    /// For each mix that is as good as the verdict's: from which amplitude they differ.
    pub reaches: Vec<Reach>,
    /// The verdict's residuals, value − model, at the values of the window.
    pub residuals: Vec<f64>,
    /// How many residuals are far too large for the noise of the others.
    pub outliers: usize,
    /// Where the sensor clipped the swings, if it did.
    pub clipping: Option<Clipping>,
    /// How residuals counted.
    pub loss: Loss,
    /// Evaluations of the model, of all mixes together.
    pub evaluations: usize,
    /// Standard deviation of a value, where it was given: χ² is measured in it.
    pub sigma: Option<f64>,
}

impl FitReport {
    /// The fit of a mix.
    pub fn model(&self, mix: Mix) -> Option<&Model> {
        self.models.iter().find(|model| model.mix == mix)
    }

    /// The fit of the verdict's mix.
    pub fn best(&self) -> Option<&Model> {
        self.model(self.verdict.mix)
    }
}
