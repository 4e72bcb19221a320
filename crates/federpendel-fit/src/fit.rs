//! The steps of a fit, one after the other.

use std::f64::consts::PI;

use federpendel::Mix;

use crate::adequacy::{adequacy, noise};
use crate::bootstrap;
use crate::covariance::{covariance, interval, student, variance};
use crate::error::FitError;
use crate::extremes::{look, median};
use crate::least_squares::Minimum;
use crate::mixes::{Fitted, fit_all, free};
use crate::noise::Excess;
use crate::options::{Intervals, Laws, Loss, Options};
use crate::problem::{COULOMB, LAWS, Matrix, NAMES, OMEGA, Problem, Vector, parameters};
use crate::profile;
use crate::ranking::{Candidate, criteria, verdict};
use crate::reach::{Reach, reach};
use crate::report::{FitReport, Model, Parameter};
use crate::shares::shares;
use crate::stop;
use crate::unit::unit_of_values;
use crate::window::{Edge, Found, Window, find};
use crate::{Quantity, Recording};

/// Fewest values that are fitted: more than there are parameters, with some to judge them by.
const FEWEST: usize = 12;

/// So many standard errors off a position is taken to be possible where a rest is bracketed: it is a difference of
/// two of them, each known about as well as half a swing of values tells.
const BLUR: f64 = 4.0;

/// Fits every mix of the allowed laws to a recording of a free decay, from a cold start.
///
/// # Errors [`FitError`] if the recording or an option is out of range, if nothing moves, or if no
/// search came to an end.
pub fn fit(recording: &Recording, options: &Options) -> Result<FitReport, FitError> {
    check(recording, options)?;
    let mut found = find(recording, options.from, options.to);
    let mut fits = Fits::new(recording, &found, options)?;
    for _ in 0..3 {
        // A hand that let go late, or the like, spoils the first values: without them once more.
        let Some(first) = fits.misfit(&found.window, options) else { break };
        let Window { end, ends, .. } = found.window;
        let window = Window::between(&recording.times, first, end, Edge::Misfit, ends);
        let part = (&recording.times[first..end], &recording.values[first..end]);
        let look = look(part.0, part.1).or(found.look.clone());
        let shorter = Found { window, look };
        let Ok(again) = Fits::new(recording, &shorter, options) else { break };
        (found, fits) = (shorter, again);
    }
    fits.report(recording, found.window, options)
}

fn check(recording: &Recording, options: &Options) -> Result<(), FitError> {
    let (times, values) = (&recording.times, &recording.values);
    if times.len() != values.len() {
        return Err(FitError::Length { times: times.len(), values: values.len() });
    }
    let bad = |index, what, value, allowed| Err(FitError::Value { index, what, value, allowed });
    for (index, (&time, &value)) in times.iter().zip(values).enumerate() {
        if !time.is_finite() || (index > 0 && time <= times[index - 1]) {
            return bad(index, "time", time, "finite and after the one before it");
        }
        if !value.is_finite() {
            return bad(index, "value", value, "finite");
        }
    }
    if let Some(sigma) = options.sigma
        && !(sigma.is_finite() && sigma > 0.0)
    {
        return Err(FitError::Option {
            name: "sigma",
            value: sigma,
            allowed: "finite and above zero",
        });
    }
    for (name, value) in [("from", options.from), ("to", options.to)] {
        if let Some(value) = value
            && !value.is_finite()
        {
            return Err(FitError::Option { name, value, allowed: "finite" });
        }
    }
    let inside = |t: &&f64| {
        options.from.is_none_or(|from| **t >= from) && options.to.is_none_or(|to| **t <= to)
    };
    let found = times.iter().filter(inside).count();
    if found < FEWEST {
        let from = options.from.or(times.first().copied()).unwrap_or(f64::NAN);
        let to = options.to.or(times.last().copied()).unwrap_or(f64::NAN);
        return Err(FitError::TooFew { found, needed: FEWEST, from, to });
    }
    Ok(())
}

/// The fits of all mixes to one window.
struct Fits {
    problem: Problem,
    fitted: Vec<Fitted>,
    excess: Excess,
    effective: f64,
}

impl Fits {
    fn new(recording: &Recording, found: &Found, options: &Options) -> Result<Self, FitError> {
        let Window { first, end, from, to, .. } = found.window;
        let values = recording.values[first..end].to_vec();
        if values.iter().all(|&value| value == values[0]) {
            return Err(FitError::Still { from, to });
        }
        let times = recording.times[first..end].to_vec();
        let mut problem = Problem::new(times, values, recording.quantity);
        let look = found.look.as_ref();
        let none = FitError::NoFit { from, to };
        let mut fitted = fit_all(&mut problem, look, options.laws.mix()).ok_or(none.clone())?;
        if options.loss != Loss::Squares {
            fitted = robust(&mut problem, &fitted, options.loss);
        }
        let best =
            fitted.iter().min_by(|a, b| a.minimum.normal.cost.total_cmp(&b.minimum.normal.cost));
        let best = *best.ok_or(none.clone())?;
        let excess = noise(&mut problem, &best.minimum, &free(best.mix)).ok_or(none)?;
        let effective = problem.len() as f64 / excess.of_amplitude;
        Ok(Self { problem, fitted, excess, effective })
    }

    /// The fit of the largest mix, which all others are part of.
    fn largest(&self) -> &Fitted {
        &self.fitted[0]
    }

    /// The index from which on the recording fits, if its first values do not belong to the motion:
    /// over the first eighth of a period, or over the first swing, the residuals are far larger
    /// than after it.
    fn misfit(&mut self, window: &Window, options: &Options) -> Option<usize> {
        if options.from.is_some() {
            return None;
        }
        let Minimum { at, ending, .. } = self.largest().minimum;
        let residuals = self.problem.residuals(&at, ending)?;
        let begin = self.problem.times[0];
        let half = PI / at[OMEGA];
        let index =
            |swings: f64| self.problem.times.partition_point(|&t| t <= begin + swings * half);
        let rms = |from: usize, to: usize| {
            let part = &residuals[from..to];
            (part.iter().map(|r| r * r).sum::<f64>() / part.len().max(1) as f64).sqrt()
        };
        // How long the part is, how many times larger its residuals, and where the window begins
        // without it.
        for (part, times, without) in [(0.25, 3.0, 0.6), (1.0, 2.0, 1.0)] {
            let (end, later) = (index(part), index(part + 4.0));
            let enough = end >= 2 && later >= end + FEWEST && self.problem.len() >= 2 * later;
            if enough && rms(0, end) > times * rms(end, later) {
                return Some(window.first + index(without));
            }
        }
        None
    }

    fn report(
        mut self,
        recording: &Recording,
        window: Window,
        options: &Options,
    ) -> Result<FitReport, FitError> {
        let none = FitError::NoFit { from: window.from, to: window.to };
        let candidates: Vec<Candidate> = self
            .fitted
            .iter()
            .map(|f| Candidate { mix: f.mix, cost: f.minimum.normal.cost })
            .collect();
        let mut verdict = verdict(&candidates, self.effective).ok_or(none.clone())?;
        if let Laws::Exactly(mix) = options.laws {
            (verdict.mix, verdict.alternatives) = (mix, vec![]);
        }
        let find = |mix: Mix| self.fitted.iter().find(|f| f.mix == mix).copied();
        let best = find(verdict.mix).ok_or(none.clone())?;
        let free_here = free(best.mix);
        let adequacy =
            adequacy(&mut self.problem, &best.minimum, &free_here).ok_or(none.clone())?;
        let reaches = self.reaches(&verdict.alternatives, &best);
        let shares = shares(&parameters(&best.minimum.at), window.to - window.from);
        let residuals =
            self.problem.residuals(&best.minimum.at, best.minimum.ending).ok_or(none)?;
        let mut models: Vec<Model> = Vec::new();
        for fitted in self.fitted.clone() {
            let chosen = fitted.mix == best.mix || options.every_mix;
            let intervals = if chosen { options.intervals } else { Intervals::Covariance };
            models.push(self.model(&fitted, intervals, options.sigma));
        }
        models.sort_by(|a, b| a.criteria.aicc.total_cmp(&b.criteria.aicc));
        Ok(FitReport {
            quantity: recording.quantity,
            laws: options.laws,
            unit: unit_of_values(recording),
            window,
            samples: self.problem.len(),
            effective_samples: self.effective,
            excess: self.excess,
            models,
            verdict,
            adequacy,
            shares,
            reaches,
            residuals,
            evaluations: self.problem.evaluations,
            sigma: options.sigma,
            intervals: options.intervals,
        })
    }

    fn reaches(&self, alternatives: &[Mix], best: &Fitted) -> Vec<Reach> {
        let count = self.problem.len();
        let variance = variance(&best.minimum, &free(best.mix), count, self.excess);
        let each = |&other: &Mix| {
            reach(&self.problem, &best.minimum, best.mix, other, self.excess, variance)
        };
        alternatives.iter().map(each).collect()
    }

    fn model(&mut self, fitted: &Fitted, intervals: Intervals, sigma: Option<f64>) -> Model {
        let (minimum, free) = (&fitted.minimum, free(fitted.mix));
        let count = self.problem.len();
        let spread = covariance(minimum, &free, count, self.excess);
        let used: Vec<usize> = (0..7).filter(|&i| free[i]).collect();
        let freedom = count.saturating_sub(used.len()).max(1) as f64;
        let found = self.intervals(minimum, &free, &spread, intervals);
        let mut parameters: Vec<Parameter> =
            used.iter().map(|&i| parameter(i, &minimum.at, &spread, found[i])).collect();
        let rest =
            if minimum.at[COULOMB] > 0.0 { self.rest(minimum, &free, &spread) } else { None };
        parameters.extend(rest.map(|rest| Parameter {
            name: "static_acceleration",
            value: None,
            stderr: None,
            interval95: (Some(rest.static_acceleration.0), rest.static_acceleration.1),
            at_bound: false,
        }));
        let residual = minimum.normal.cost;
        let chi_square = residual / sigma.map_or(1.0, |sigma| sigma * sigma);
        Model {
            mix: fitted.mix,
            parameters,
            correlations: correlations(&spread, &used),
            chi_square,
            reduced: chi_square / freedom,
            rms: (residual / count as f64).sqrt(),
            criteria: criteria(residual / count as f64, used.len(), self.effective),
            stop_reason: minimum.reason,
            rest,
        }
    }

    /// The rest of a motion, with positions as unsure as half a swing of values leaves them.
    fn rest(&mut self, minimum: &Minimum, free: &[bool; 7], spread: &Matrix) -> Option<stop::Rest> {
        let variance = variance(minimum, free, self.problem.len(), self.excess);
        let omega = minimum.at[OMEGA];
        let values = (PI / omega / self.problem.step()).max(1.0) / self.excess.of_amplitude;
        let power = match self.problem.quantity {
            Quantity::Position => 0,
            Quantity::Velocity => 1,
            Quantity::Acceleration => 2,
        };
        let blur = BLUR * (variance / values.max(1.0)).sqrt() / omega.powi(power);
        let dry = student(self.effective) * spread[(COULOMB, COULOMB)].sqrt();
        stop::rest(&mut self.problem, minimum, (blur, dry))
    }

    /// The interval of each free parameter.
    fn intervals(
        &mut self,
        minimum: &Minimum,
        free: &[bool; 7],
        spread: &Matrix,
        how: Intervals,
    ) -> [(Option<f64>, Option<f64>); 7] {
        let fitted = free.iter().filter(|&&free| free).count() as f64;
        // Where the noise hangs together, its power at one frequency is known only as well as n/2F values
        // tell it: so for x = φ x' + e, from the variance of φ.
        let share = if self.excess.of_amplitude > 1.1 { 0.5 } else { 1.0 };
        let quantile = student((share * self.effective - fitted).max(4.0));
        let variance = variance(minimum, free, self.problem.len(), self.excess);
        let refits = match how {
            Intervals::Bootstrap(bootstrap) => {
                let step = (self.problem.times[1] - self.problem.times[0]).max(f64::MIN_POSITIVE);
                let block =
                    if self.excess.of_phase > 1.0 { PI / minimum.at[OMEGA] / step } else { 1.0 };
                bootstrap::refits(&self.problem, minimum, free, block as usize, bootstrap)
            }
            _ => vec![],
        };
        // Where values change sides at jumps, the sum of squares has steps that a profile stumbles
        // over.
        let jumps = self.problem.quantity == Quantity::Acceleration && minimum.at[COULOMB] > 0.0;
        std::array::from_fn(|i| {
            let stderr = spread[(i, i)].sqrt();
            let (low, high) = interval(minimum.at[i], stderr, i, quantile);
            let known = |x: f64| x.is_finite().then_some(x);
            let plain = (known(low), known(high));
            match how {
                _ if !free[i] => (None, None),
                Intervals::Covariance => plain,
                Intervals::Profile if jumps => plain,
                Intervals::Bootstrap(_) => bootstrap::interval(&refits, i)
                    .map_or(plain, |(low, high)| (Some(low), Some(high))),
                Intervals::Profile => {
                    let unit = variance * self.excess.of(i);
                    let measure = profile::Measure { unit, stderr, quantile };
                    profile::interval(&mut self.problem, minimum, free, i, measure)
                }
            }
        })
    }
}

fn parameter(
    i: usize,
    at: &Vector,
    spread: &Matrix,
    interval95: (Option<f64>, Option<f64>),
) -> Parameter {
    let stderr = spread[(i, i)].sqrt();
    Parameter {
        name: NAMES[i],
        value: Some(at[i]),
        stderr: stderr.is_finite().then_some(stderr),
        interval95,
        at_bound: LAWS.contains(&i) && at[i] == 0.0,
    }
}

fn correlations(spread: &Matrix, used: &[usize]) -> Vec<Vec<f64>> {
    let one = |i: usize, j: usize| {
        if i == j { 1.0 } else { spread[(i, j)] / (spread[(i, i)] * spread[(j, j)]).sqrt() }
    };
    used.iter().map(|&i| used.iter().map(|&j| one(i, j)).collect()).collect()
}

/// The fits again with a loss that outliers do not sway; the scale is that of the residuals'
/// median.
fn robust(problem: &mut Problem, fitted: &[Fitted], loss: Loss) -> Vec<Fitted> {
    use crate::least_squares::{Effort, minimise};
    let mut fitted = fitted.to_vec();
    // The scale is that of the best fit, the same for all, so that they can be compared.
    for _ in 0..3 {
        let Some(best) = fitted.first() else { return fitted };
        let Some(residuals) = problem.residuals(&best.minimum.at, best.minimum.ending) else {
            return fitted;
        };
        let mut sizes: Vec<f64> = residuals.iter().map(|r| r.abs()).collect();
        let scale = 1.4826 * median(&mut sizes).unwrap_or(0.0);
        if scale <= 0.0 {
            return fitted;
        }
        problem.loss = (loss, scale);
        for fit in &mut fitted {
            let Minimum { at, ending, .. } = fit.minimum;
            if let Some(found) = minimise(problem, &at, &free(fit.mix), ending, Effort::FINE) {
                fit.minimum = found;
            }
        }
    }
    fitted
}
