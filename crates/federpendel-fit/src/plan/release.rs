//! One release: what recordings of all lengths would tell of it.

use std::f64::consts::PI;

use federpendel::Mix;

use super::setup::{FEWEST_SWINGS, Setup};
use super::steps::{rounded_up, steps};
use super::{Law, PAYS, Resolution};
use crate::information::Information;
use crate::model::{Course, Jacobian, ModelError, Stop, evaluate};

/// Most values that are computed; where there are more, each of these stands for several.
const MOST: f64 = 20_000.0;

/// Fewest of them in a period, so that they may.
const PER_PERIOD: f64 = 12.0;

/// A release from rest at some amplitude.
pub struct Release {
    /// What recordings of these lengths (s) tell, none if the mass rests too soon; rising, the last as long as it pays at
    /// all.
    told: Vec<(f64, Information)>,
    noise: f64,
}

impl Release {
    /// The release of this amplitude.
    ///
    /// # Errors
    /// What the model refuses.
    pub fn new(setup: &Setup, amplitude: f64) -> Result<Self, ModelError> {
        let told = match horizon(setup, amplitude)? {
            None => Vec::new(),
            Some(horizon) => told(setup, amplitude, horizon)?,
        };
        Ok(Release { told, noise: setup.noise })
    }

    /// The longest recording that is of any use, s; zero if the mass rests too soon.
    pub fn longest(&self) -> f64 {
        self.told.last().map_or(0.0, |(duration, _)| *duration)
    }

    /// How well `law`, of which this is the coefficient, is known beside the other `fitted` laws, once more time does
    /// little for it.
    pub fn resolution(&self, law: Law, coefficient: f64, fitted: Mix) -> Option<Resolution> {
        let stderr = |information: &Information| {
            information.stderr(law.beside(fitted), law.index(), self.noise)
        };
        let (_, all) = self.told.last()?;
        let enough = PAYS * stderr(all);
        let found = self.told.iter().find(|(_, information)| stderr(information) <= enough);
        let (duration, stderr) = found.map(|(duration, told)| (*duration, stderr(told)))?;
        let known = stderr.is_finite() && stderr > 0.0;
        known.then_some(Resolution { duration, stderr, significance: coefficient / stderr })
    }

    /// The correlation of two coefficients beside the other `fitted` laws in the longest recording.
    pub fn correlation(&self, pair: [Law; 2], fitted: Mix) -> Option<f64> {
        let covariance = self.told.last()?.1.covariance(fitted, self.noise);
        let [i, j] = pair.map(Law::index);
        let correlation = covariance[i][j] / (covariance[i][i] * covariance[j][j]).sqrt();
        correlation.is_finite().then_some(correlation)
    }
}

/// When nothing more is to be learnt: a period after the mass has come to rest, or when its amplitude has fallen to
/// the noise of one value, or at the user's limit; none if it never moves, or rests too soon.
fn horizon(setup: &Setup, amplitude: f64) -> Result<Option<f64>, ModelError> {
    let course = course(setup, amplitude)?;
    let period = 2.0 * PI / setup.oscillator.angular_frequency();
    let end = match course.rest {
        Some(rest) if rest.number < FEWEST_SWINGS => return Ok(None),
        Some(rest) => Some(rest.time + period),
        None => None,
    };
    let noise = setup.noise_length();
    let mut points = course.turning_points.iter();
    let drowned = points.find(|point| point.position.abs() < noise).map(|point| point.time);
    let ends = [end, drowned].into_iter().flatten();
    let end = ends.reduce(f64::min).map(|end| rounded_up(end.max(setup.shortest())));
    Ok(Some(end.unwrap_or(f64::INFINITY).min(setup.longest())))
}

/// The turning points within the user's limit.
fn course(setup: &Setup, amplitude: f64) -> Result<Course, ModelError> {
    let (mut values, times) = ([0.0; 2], [0.0, setup.longest()]);
    evaluate(&setup.parameters(amplitude), setup.stop(), &times, setup.quantity, &mut values, None)
}

/// What recordings of easy lengths up to `horizon` tell.
fn told(
    setup: &Setup,
    amplitude: f64,
    horizon: f64,
) -> Result<Vec<(f64, Information)>, ModelError> {
    let period = 2.0 * PI / setup.oscillator.angular_frequency();
    let spare = (setup.rate * period / PER_PERIOD).floor();
    let stride = (horizon * setup.rate / MOST).ceil().min(spare).max(1.0);
    let step = stride / setup.rate;
    // A recording of a whole number of steps has a value at both ends, as far as rounding goes.
    let count = |duration: f64| (duration / step * (1.0 + 1e-12)).floor() as usize + 1;
    let times: Vec<f64> = (0..count(horizon)).map(|i| i as f64 * step).collect();
    let mut values = vec![0.0; times.len()];
    let mut jacobian = Jacobian::new();
    let (parameters, stop) = (setup.parameters(amplitude), setup.stop());
    evaluate(&parameters, stop, &times, setup.quantity, &mut values, Some(&mut jacobian))?;
    let shortest = setup.shortest();
    let lengths = if horizon > shortest { steps(shortest, horizon) } else { vec![horizon] };
    let (mut information, mut from) = (Information::none(), 0);
    Ok(lengths
        .into_iter()
        .map(|duration| {
            information.add(&jacobian, from..count(duration), stride);
            from = count(duration);
            (duration, information)
        })
        .collect())
}

impl Setup {
    /// How the motion ends.
    pub(super) fn stop(&self) -> Stop {
        let unit = self.oscillator.angular_frequency().powi(2);
        Stop::Natural { static_acceleration: self.oscillator.sticking_offset() * unit }
    }
}
