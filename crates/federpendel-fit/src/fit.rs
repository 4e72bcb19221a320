//! The steps of a fit, one after the other.

use std::f64::consts::PI;

use federpendel::Mix;

use crate::Recording;
use crate::adequacy::{adequacy, noise};
use crate::beginning::settled;
use crate::check::check;
use crate::clipping::unclipped;
use crate::condense::{Whole, condense};
use crate::covariance::variance;
use crate::error::FitError;
use crate::extremes::spread;
use crate::least_squares::Minimum;
use crate::mixes::{Fitted, fit_all, free};
use crate::noise::Excess;
use crate::options::{Intervals, Laws, Loss, Options};
use crate::problem::{LAWS, OMEGA, Problem, parameters};
use crate::ranking::{Candidate, Ranking, verdict};
use crate::reach::{Reach, reach};
use crate::report::{FitReport, Model};
use crate::robust::robust;
use crate::shares::shares;
use crate::start::mix;
use crate::unit::unit_of_values;
use crate::window::{Found, Window};

/// So many turns that stand out of the noise are an oscillation, whatever is fitted to it.
const TURNS: usize = 5;

/// A likelihood ratio that the parameters of a motion reach in noise hardly ever, beside the 2 ln n that the best
/// of n frequencies does.
const OF_NOISE: f64 = 20.0;

/// All laws at once.
const ALL: Mix = Mix { stokes: true, coulomb: true, newton: true };

/// Fits every mix of the allowed laws to a recording of a free decay, from a cold start.
///
/// # Errors [`FitError`] if the recording or an option is out of range, if nothing moves, or if no
/// search came to an end.
pub fn fit(recording: &Recording, options: &Options) -> Result<FitReport, FitError> {
    check(recording, options)?;
    let condensed = match options.loss {
        Loss::Squares => condense(recording),
        // Outliers have to be seen one by one.
        Loss::Huber | Loss::Tukey => None,
    };
    let all = recording;
    let recording = condensed.as_ref().map_or(all, |condensed| &condensed.recording);
    let (found, clipping) = unclipped(all, recording, options);
    let laws = match options.laws {
        Laws::Among(mix) => mix,
        // Else a mix that is wrong would have no beginning that fits.
        Laws::Exactly(_) => ALL,
    };
    let (mut found, mut fits) = settled(recording, found, options, laws)?;
    let mut asked_rejection = None;
    if let Laws::Exactly(mix) = options.laws {
        let asked = Fits::new(recording, &found, options, mix)?;
        asked_rejection = fits.ranking().rejection(mix);
        fits = asked;
    }
    let whole = condensed.as_ref().map(|condensed| condensed.whole(all, &found.window));
    if let Some((whole, window)) = whole {
        fits.whole = Some(whole);
        found.window = window;
    }
    let report = fits.report(recording, &found, options)?;
    Ok(FitReport { asked_rejection, clipping, ..report })
}

/// The fits of all mixes to one window.
pub struct Fits<'a> {
    pub problem: Problem,
    /// All values, where those of the problem are means.
    whole: Option<Whole<'a>>,
    fitted: Vec<Fitted>,
    pub excess: Excess,
    pub effective: f64,
}

impl Fits<'_> {
    pub fn new(
        recording: &Recording,
        found: &Found,
        options: &Options,
        laws: Mix,
    ) -> Result<Self, FitError> {
        let Window { first, end, from, to, .. } = found.window;
        let values = recording.values[first..end].to_vec();
        if values.iter().all(|&value| value == values[0]) {
            return Err(FitError::Still { from, to });
        }
        let times = recording.times[first..end].to_vec();
        let mut problem = Problem::new(times, values, recording.quantity);
        let look = found.look.as_ref();
        let none = FitError::NoFit { from, to };
        let mut fitted = fit_all(&mut problem, look, laws).ok_or(none.clone())?;
        if options.loss != Loss::Squares {
            fitted = robust(&mut problem, &fitted, options.loss);
        }
        let best =
            fitted.iter().min_by(|a, b| a.minimum.normal.cost.total_cmp(&b.minimum.normal.cost));
        let best = best.ok_or(none.clone())?;
        let excess = noise(&mut problem, &best.minimum, &free(best.mix)).ok_or(none)?;
        let effective = problem.len() as f64 / excess.of_amplitude;
        Ok(Self { problem, whole: None, fitted, excess, effective })
    }

    /// The fit of the largest mix, which all others are part of.
    pub fn largest(&self) -> &Fitted {
        &self.fitted[0]
    }

    fn report(
        mut self,
        recording: &Recording,
        found: &Found,
        options: &Options,
    ) -> Result<FitReport, FitError> {
        let window = found.window;
        let none = FitError::NoFit { from: window.from, to: window.to };
        let ranking = self.ranking();
        let mut verdict = verdict(&ranking).ok_or(none.clone())?;
        if let Laws::Exactly(mix) = options.laws {
            verdict.mix = mix;
        }
        let find = |mix: Mix| self.fitted.iter().find(|f| f.mix == mix).cloned();
        let best = find(verdict.mix).ok_or(none.clone())?;
        let free_here = free(best.mix);
        let adequacy =
            adequacy(&mut self.problem, &best.minimum, &free_here).ok_or(none.clone())?;
        let turns = found.look.as_ref().map_or(0, |look| look.extremes.len());
        // Of what turns often enough adequacy says more.
        if !self.swings(&best.minimum) && (adequacy.adequate || turns < TURNS) {
            return Err(FitError::NoOscillation { from: window.from, to: window.to });
        }
        let shares = shares(&parameters(&best.minimum.at), window.to - window.from);
        let residuals = self.residuals(&best.minimum).ok_or(none)?;
        if self.whole.is_some() {
            // Means hold less noise than values: as many independent values tell as much.
            let means = best.minimum.normal.cost / self.problem.len() as f64;
            self.effective *= mean_square(&residuals) / means;
        }
        let mut models: Vec<Model> = Vec::new();
        for fitted in self.fitted.clone() {
            let chosen = fitted.mix == best.mix || options.every_mix;
            let intervals = if chosen { options.intervals } else { Intervals::Covariance };
            models.push(self.model(&fitted, intervals, options.sigma));
        }
        let shown = models.iter().filter(|model| model.mix == best.mix);
        shown.for_each(|shown| verdict.doubt(&shown.parameters));
        if let Laws::Exactly(_) = options.laws {
            verdict.alternatives.clear();
        }
        let reaches = self.reaches(&verdict.alternatives, &best);
        models.sort_by(|a, b| a.criteria.aicc.total_cmp(&b.criteria.aicc));
        Ok(FitReport {
            quantity: recording.quantity,
            laws: options.laws,
            unit: unit_of_values(recording),
            window,
            samples: residuals.len(),
            effective_samples: self.effective,
            excess: self.excess,
            models,
            verdict,
            ranking,
            asked_rejection: None,
            adequacy,
            shares,
            reaches,
            outliers: outliers(&residuals),
            clipping: None,
            residuals,
            evaluations: self.problem.evaluations,
            loss: options.loss,
            sigma: options.sigma,
        })
    }

    /// The mixes as the verdict weighs them.
    fn ranking(&self) -> Ranking {
        let candidate = |fitted: &Fitted| Candidate {
            mix: fitted.mix,
            cost: fitted.minimum.normal.cost,
            lowest: fitted.lowest(),
            core: core(fitted),
        };
        let candidates = self.fitted.iter().map(candidate).collect();
        Ranking { candidates, effective: self.effective }
    }

    /// Whether the values show a motion: at least half a swing of it, beyond what a search for a frequency finds in
    /// noise.
    fn swings(&self, minimum: &Minimum) -> bool {
        let problem = &self.problem;
        let count = problem.len() as f64;
        let phase = minimum.at[OMEGA] * problem.step() * (count - 1.0);
        let mean = problem.values.iter().sum::<f64>() / count;
        let still: f64 = problem.values.iter().map(|value| (value - mean).powi(2)).sum();
        let ratio = self.effective * (still / minimum.normal.cost).ln();
        phase > PI && (minimum.normal.cost == 0.0 || ratio > 2.0 * count.ln() + OF_NOISE)
    }

    /// Value minus model at every value.
    fn residuals(&mut self, minimum: &Minimum) -> Option<Vec<f64>> {
        match &self.whole {
            Some(whole) => {
                let mut residuals = Vec::with_capacity(whole.len());
                whole.residuals(minimum, |residual| residuals.push(residual))?;
                Some(residuals)
            }
            None => self.problem.residuals(&minimum.at, minimum.ending),
        }
    }

    /// The sum of squares of a fit over every value, and their number.
    pub fn cost(&mut self, minimum: &Minimum) -> (f64, usize) {
        let whole = self.whole.as_ref().and_then(|whole| {
            let mut cost = 0.0;
            whole.residuals(minimum, |residual| cost += residual * residual)?;
            Some((cost, whole.len()))
        });
        whole.unwrap_or((minimum.normal.cost, self.problem.len()))
    }

    fn reaches(&self, alternatives: &[Mix], best: &Fitted) -> Vec<Reach> {
        let count = self.problem.len();
        let variance = variance(&best.minimum, &free(best.mix), count, self.excess);
        let each = |&other: &Mix| {
            reach(&self.problem, &best.minimum, best.mix, other, self.excess, variance)
        };
        alternatives.iter().map(each).collect()
    }
}

/// The laws of the mix that did not come out as none.
fn core(fitted: &Fitted) -> Mix {
    let free = free(fitted.mix);
    mix(LAWS.map(|law| free[law] && fitted.minimum.at[law] > 0.0))
}

/// A residual so many standard deviations large is none of the noise.
const OUTLIER: f64 = 10.0;

/// How many residuals are outliers.
fn outliers(residuals: &[f64]) -> usize {
    let limit = OUTLIER * spread(residuals.iter().copied());
    residuals.iter().filter(|r| r.abs() > limit && limit > 0.0).count()
}

fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>() / values.len().max(1) as f64
}
