//! Numbers made of uncertain ones: each carries its derivatives by what is uncertain, so that linear propagation
//! (GUM, JCGM 100:2008, 5.2) counts rightly what stands in several factors.

use std::ops::{Add, Div, Mul, Sub};

use nalgebra::{SMatrix, SVector};

use crate::covariance::student;
use crate::report::Model;

/// What a number may be uncertain by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// ω0 of the fit.
    AngularFrequency,
    /// γ of the fit.
    DampingRate,
    /// a_c of the fit.
    CoulombAcceleration,
    /// κ of the fit.
    NewtonRate,
    /// The mass as given.
    Mass,
    /// The stiffness as given.
    Stiffness,
    /// The mass of the spring as given.
    SpringMass,
    /// The normal force as given.
    NormalForce,
    /// The gravity as given.
    Gravity,
}

/// The fitted sources, by the names of their parameters.
const FITTED: [(Source, &str); 4] = [
    (Source::AngularFrequency, "angular_frequency"),
    (Source::DampingRate, "damping_rate"),
    (Source::CoulombAcceleration, "coulomb_acceleration"),
    (Source::NewtonRate, "newton_rate"),
];

/// How many sources there are.
const COUNT: usize = 9;

/// A value with its standard uncertainty, as it was measured beside the recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// The value, SI.
    pub value: f64,
    /// Its standard uncertainty, SI; zero for an exact value.
    pub uncertainty: f64,
}

/// A number with its derivatives by all sources.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Propagated {
    /// The number.
    pub value: f64,
    slopes: SVector<f64, COUNT>,
}

impl Propagated {
    /// A number that nothing makes uncertain.
    pub fn exact(value: f64) -> Self {
        Self { value, slopes: SVector::zeros() }
    }

    /// The source of this value itself.
    fn source(value: f64, source: Source) -> Self {
        let mut slopes = SVector::zeros();
        slopes[source as usize] = 1.0;
        Self { value, slopes }
    }

    /// The square root.
    pub fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        Self { value, slopes: self.slopes / (2.0 * value) }
    }
}

impl Add for Propagated {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slopes: self.slopes + other.slopes }
    }
}

impl Sub for Propagated {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + other * -1.0
    }
}

impl Mul for Propagated {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let slopes = self.slopes * other.value + other.slopes * self.value;
        Self { value: self.value * other.value, slopes }
    }
}

impl Mul<f64> for Propagated {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, slopes: self.slopes * factor }
    }
}

impl Div for Propagated {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slopes: (self.slopes - other.slopes * value) / other.value }
    }
}

/// A number with what is known of its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Its value; none where only an interval is known.
    pub value: Option<f64>,
    /// Its standard error; none where it is not known.
    pub stderr: Option<f64>,
    /// Its 95 % interval, open where an end is none. Nothing here is negative: it begins at zero at least.
    pub interval95: (Option<f64>, Option<f64>),
    /// Its unit.
    pub unit: &'static str,
}

/// The values of all sources and how they vary together.
#[derive(Debug, Clone)]
pub struct Sources {
    values: [f64; COUNT],
    covariance: SMatrix<f64, COUNT, COUNT>,
    /// The 95 % intervals of the fitted ones.
    intervals: [(Option<f64>, Option<f64>); FITTED.len()],
}

impl Sources {
    /// The parameters of a fit. A law that its mix lacks counts as an exact zero.
    pub fn of(model: &Model) -> Self {
        let found = FITTED.map(|(_, name)| model.parameters.iter().position(|p| p.name == name));
        let stderr = |i: usize| {
            let fitted = found[i].map(|at| model.parameters[at].stderr.unwrap_or(f64::INFINITY));
            fitted.unwrap_or(0.0)
        };
        let mut covariance = SMatrix::zeros();
        for i in 0..FITTED.len() {
            for j in 0..FITTED.len() {
                let both = stderr(i) * stderr(j);
                covariance[(i, j)] = match (found[i], found[j]) {
                    _ if i == j => both,
                    (Some(row), Some(column)) if both.is_finite() => {
                        both * model.correlations[row][column]
                    }
                    _ => 0.0,
                };
            }
        }
        let mut values = [0.0; COUNT];
        FITTED.iter().enumerate().for_each(|(i, (_, name))| values[i] = model.value(name));
        let interval = |at: Option<usize>| at.map(|at| model.parameters[at].interval95);
        let intervals = found.map(|at| interval(at).unwrap_or((Some(0.0), Some(0.0))));
        Self { values, covariance, intervals }
    }

    /// Adds what was measured beside the recording.
    pub fn give(&mut self, source: Source, given: Measured) {
        let i = source as usize;
        self.values[i] = given.value;
        self.covariance[(i, i)] = given.uncertainty.powi(2);
    }

    /// The number that this source is.
    pub fn number(&self, source: Source) -> Propagated {
        Propagated::source(self.values[source as usize], source)
    }

    /// The variance of a number; infinite where it depends on something of which nothing is known.
    fn variance(&self, number: &Propagated) -> f64 {
        let used = |i: &usize| number.slopes[*i] != 0.0;
        let mut sum = 0.0;
        for i in (0..COUNT).filter(used) {
            for j in (0..COUNT).filter(used) {
                sum += number.slopes[i] * number.slopes[j] * self.covariance[(i, j)];
            }
        }
        sum.max(0.0)
    }

    /// Its standard error, where one is known.
    pub fn stderr(&self, number: &Propagated) -> Option<f64> {
        Some(self.variance(number).sqrt()).filter(|stderr| stderr.is_finite())
    }

    /// A number as it is handed on.
    ///
    /// `fitted` is the parameter that it follows: what that one adds to each half of the interval is taken from
    /// the interval of the fit, which need not be symmetric, all else from standard errors.
    pub fn estimate(&self, number: Propagated, fitted: Source, unit: &'static str) -> Estimate {
        let value = number.value;
        let Some(stderr) = self.stderr(&number).filter(|_| value.is_finite()) else {
            let value = Some(value).filter(|value| value.is_finite());
            // The number of the least that is known of what it follows is the least of it.
            let least = self.intervals.get(fitted as usize).is_some_and(|ends| ends.1.is_none());
            let (value, low) = if least { (None, value) } else { (value, None) };
            return Estimate { value, stderr: None, interval95: (low, None), unit };
        };
        let i = fitted as usize;
        let slope = number.slopes[i];
        let own = (slope * slope * self.covariance[(i, i)]).max(0.0);
        let others = student(f64::INFINITY).powi(2) * (stderr * stderr - own).max(0.0);
        let half = |end: Option<f64>| {
            let part = if slope == 0.0 { 0.0 } else { slope * (end? - self.values[i]) };
            Some((part * part + others).sqrt())
        };
        let (low, high) = self.intervals.get(i).copied().unwrap_or_default();
        let (down, up) = if slope < 0.0 { (high, low) } else { (low, high) };
        let interval95 =
            (half(down).map(|half| (value - half).max(0.0)), half(up).map(|half| value + half));
        Estimate { value: Some(value), stderr: Some(stderr), interval95, unit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_differences() {
        let formula = |x: Propagated, y: Propagated| {
            (x * y + x / y - y * 3.0).sqrt() / (x * x + Propagated::exact(2.0))
        };
        let at = |x: f64, y: f64| {
            formula(Propagated::source(x, Source::Mass), Propagated::source(y, Source::Gravity))
        };
        let number = at(7.0, 2.0);
        let step = 1e-6;
        let slope = |high: f64, low: f64| (high - low) / (2.0 * step);
        let by_x = slope(at(7.0 + step, 2.0).value, at(7.0 - step, 2.0).value);
        let by_y = slope(at(7.0, 2.0 + step).value, at(7.0, 2.0 - step).value);
        assert!((number.slopes[Source::Mass as usize] - by_x).abs() < 1e-9);
        assert!((number.slopes[Source::Gravity as usize] - by_y).abs() < 1e-9);
    }
}
