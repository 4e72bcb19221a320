//! A fitted mix in full: standard errors, intervals, rest, criteria.

use std::f64::consts::PI;

use crate::Quantity;
use crate::bootstrap;
use crate::covariance::{covariance, interval, student, variance};
use crate::elsewhere::{Other, Reached};
use crate::fit::Fits;
use crate::least_squares::Minimum;
use crate::mixes::{Fitted, free};
use crate::options::Intervals;
use crate::problem::{COULOMB, LAWS, Matrix, NAMES, OMEGA};
use crate::profile;
use crate::ranking::criteria;
use crate::report::{Model, Parameter};
use crate::stop::{self, Early};

/// So many standard errors off a position is taken to be possible where a rest is bracketed: it is a difference of
/// two of them, each known about as well as half a swing of values tells.
const BLUR: f64 = 4.0;

impl Fits<'_> {
    /// All that is known of a fitted mix.
    pub fn model(&mut self, fitted: &Fitted, intervals: Intervals, sigma: Option<f64>) -> Model {
        let (minimum, free) = (&fitted.minimum, free(fitted.mix));
        let count = self.problem.len();
        let spread = covariance(minimum, &free, count, self.excess);
        let used: Vec<usize> = (0..7).filter(|&i| free[i]).collect();
        let quantile = self.quantile(&free);
        let found = self.intervals(minimum, &free, &spread, intervals, quantile);
        let rests = self.rests(fitted, quantile);
        let known = |&i: &usize| {
            let own = Reached { stderr: spread[(i, i)].sqrt(), interval95: found[i] };
            parameter(i, minimum.at[i], own.with(&rests, i, minimum.at[i], quantile))
        };
        let mut parameters: Vec<Parameter> = used.iter().map(known).collect();
        let rest = self.rest(minimum, &rests, &free, &spread);
        if let Some(early) = rest.and_then(|rest| rest.early) {
            bound(&mut parameters, &early, self.problem.quantity);
        }
        parameters.extend(rest.map(|rest| Parameter {
            name: "static_acceleration",
            value: None,
            stderr: None,
            interval95: (Some(rest.static_acceleration.0), rest.static_acceleration.1),
            at_bound: false,
        }));
        let (residual, values) = self.cost(minimum);
        let freedom = values.saturating_sub(used.len()).max(1) as f64;
        let chi_square = residual / sigma.map_or(1.0, |sigma| sigma * sigma);
        Model {
            mix: fitted.mix,
            parameters,
            correlations: correlations(&spread, &used),
            chi_square,
            reduced: chi_square / freedom,
            rms: (residual / values as f64).sqrt(),
            criteria: criteria(residual / values as f64, used.len(), self.effective),
            stop_reason: minimum.reason,
            rest,
        }
    }

    /// The rest of a motion, with positions as unsure as half a swing of values leaves them; wherever else it may
    /// rest counts too.
    fn rest(
        &mut self,
        minimum: &Minimum,
        rests: &[Other],
        free: &[bool; 7],
        spread: &Matrix,
    ) -> Option<stop::Rest> {
        if minimum.at[COULOMB] == 0.0 {
            return None;
        }
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
        let shown = stop::rest(&mut self.problem, minimum, (blur, dry))?;
        let others = rests.iter().map(|Other { minimum, .. }| {
            let least = (minimum.at[COULOMB] - dry).max(0.0);
            stop::rest(&mut self.problem, minimum, (blur, dry)).ok_or(least)
        });
        Some(others.fold(shown, stop::Rest::or))
    }

    /// What the number of standard deviations is that makes a 95 % interval.
    fn quantile(&self, free: &[bool; 7]) -> f64 {
        let fitted = free.iter().filter(|&&free| free).count() as f64;
        // Where the noise hangs together, its power at one frequency is known only as well as n/2F values
        // tell it: so for x = φ x' + e, from the variance of φ.
        let share = if self.excess.of_amplitude > 1.1 { 0.5 } else { 1.0 };
        student((share * self.effective - fitted).max(4.0))
    }

    /// The interval of each free parameter.
    fn intervals(
        &mut self,
        minimum: &Minimum,
        free: &[bool; 7],
        spread: &Matrix,
        how: Intervals,
        quantile: f64,
    ) -> [(Option<f64>, Option<f64>); 7] {
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

fn parameter(i: usize, value: f64, reached: Reached) -> Parameter {
    let Reached { stderr, interval95 } = reached;
    Parameter {
        name: NAMES[i],
        value: Some(value),
        stderr: stderr.is_finite().then_some(stderr),
        interval95,
        at_bound: LAWS.contains(&i) && value == 0.0,
    }
}

/// Says of the dry friction no more than that it is at least so much, and nothing of the middle, which goes with it.
fn bound(parameters: &mut [Parameter], early: &Early, quantity: Quantity) {
    for parameter in parameters {
        let ends = match parameter.name {
            "coulomb_acceleration" => {
                parameter.value = None;
                (Some(early.least_kinetic), None)
            }
            "position0" => {
                parameter.value = parameter.value.map(|value| value + early.shift);
                (None, None)
            }
            // That of a velocity or an acceleration is no place.
            "equilibrium" if quantity == Quantity::Position => {
                parameter.value = parameter.value.map(|value| value - early.shift);
                (None, None)
            }
            _ => continue,
        };
        (parameter.stderr, parameter.interval95) = (None, ends);
    }
}

fn correlations(spread: &Matrix, used: &[usize]) -> Vec<Vec<f64>> {
    let one = |i: usize, j: usize| {
        if i == j { 1.0 } else { spread[(i, j)] / (spread[(i, i)] * spread[(j, j)]).sqrt() }
    };
    used.iter().map(|&i| used.iter().map(|&j| one(i, j)).collect()).collect()
}
