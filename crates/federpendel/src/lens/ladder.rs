//! The observed order of a method: the slope of its error against its step.

use std::f64::consts::PI;

use super::{Course, errors};
use crate::error::{Error, Result};
use crate::motion::Motion;
use crate::scheme::{Scheme, Setting};

/// One step of the ladder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rung {
    /// Time step, s; of a method that chooses its steps their mean.
    pub time_step: f64,
    /// Tolerance, for a method that has one.
    pub tolerance: Option<f64>,
    /// Largest error of a position, m.
    pub error: f64,
    /// Steps taken.
    pub steps: u64,
}

/// Longest stretch of a motion on which the order is measured, undamped periods.
const LONGEST: f64 = 12.0;

/// The coarsest step, ω0 Δt; each of the others is half the one before. Unlike a whole number of steps to a
/// period it has no reversal on a step, which would flatter methods that step over them.
const COARSEST: f64 = 0.1;

/// Steps of a short record on the coarsest rung; no whole number either.
const FEWEST: f64 = 20.0 * PI;

/// Rungs: six halvings.
const RUNGS: u32 = 7;

/// The largest of the tolerances; each of the others is a tenth of the one before.
const LOOSEST: f64 = 1e-5;

/// The errors of a method at shorter and shorter steps.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ladder {
    /// The runs that came through.
    pub rungs: Vec<Rung>,
    /// Why the first that did not failed, and with which setting.
    pub failed: Option<FailedRung>,
}

/// A run that failed.
#[derive(Debug, Clone, PartialEq)]
pub struct FailedRung {
    /// Time step, s; none for a method that chooses its steps.
    pub time_step: Option<f64>,
    /// Tolerance, for such a method.
    pub tolerance: Option<f64>,
    /// Why it failed.
    pub error: Error,
}

/// The errors of `scheme` up to `duration` (s) or twelve periods, with six halvings of the time step from
/// 0.1/ω0 on (less for a short record), or the tolerance from 1e-5 on six times a tenth of the one before.
pub fn ladder(motion: &Motion, scheme: &Scheme, setting: &Setting, duration: f64) -> Ladder {
    let omega = motion.oscillator().angular_frequency();
    let duration = duration.min(LONGEST * 2.0 * PI / omega);
    let mut ladder = Ladder::default();
    for k in 0..RUNGS {
        let (time_step, tolerance) = if scheme.adaptive {
            (None, Some(LOOSEST * 0.1f64.powi(k as i32)))
        } else {
            (Some((COARSEST / omega).min(duration / FEWEST) * 0.5f64.powi(k as i32)), None)
        };
        match rung(motion, scheme, setting, duration, (time_step, tolerance)) {
            Ok(rung) => ladder.rungs.push(rung),
            Err(error) => {
                ladder.failed.get_or_insert(FailedRung { time_step, tolerance, error });
            }
        }
    }
    ladder
}

fn rung(
    motion: &Motion,
    scheme: &Scheme,
    setting: &Setting,
    duration: f64,
    (time_step, tolerance): (Option<f64>, Option<f64>),
) -> Result<Rung> {
    let mut setting = *setting;
    if let Some(time_step) = time_step {
        setting = setting.with_time_step(time_step)?;
    }
    if let Some(tolerance) = tolerance {
        setting = setting.with_tolerance(tolerance)?;
    }
    let found = errors(motion, &mut Course::new(scheme, &setting)?, duration)?;
    let mean = duration / found.steps as f64;
    let time_step = time_step.unwrap_or(mean);
    Ok(Rung { time_step, tolerance, error: found.largest, steps: found.steps })
}

impl Ladder {
    /// The observed order: [`order`] of all rungs; none if one failed.
    pub fn order(&self) -> Option<f64> {
        if self.failed.is_none() { order(&self.rungs) } else { None }
    }
}

/// Steps that differ by less than this factor in all show no order: stability rather than the tolerance has
/// chosen them.
const LEAST_RANGE: f64 = 4.0;

/// The slope of log error against log time step through all rungs, by least squares; none where an error
/// vanishes, or where the steps hardly differ.
pub fn order(rungs: &[Rung]) -> Option<f64> {
    let steps = || rungs.iter().map(|rung| rung.time_step);
    let (longest, shortest) = (steps().fold(0.0, f64::max), steps().fold(f64::INFINITY, f64::min));
    if longest < LEAST_RANGE * shortest {
        return None;
    }
    let points: Vec<_> = rungs.iter().map(|rung| (rung.time_step.ln(), rung.error.ln())).collect();
    let count = points.len() as f64;
    let mean = |get: fn(&(f64, f64)) -> f64| points.iter().map(get).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let sum = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>();
    let slope = sum(&|point| (point.0 - x) * (point.1 - y)) / sum(&|point| (point.0 - x).powi(2));
    slope.is_finite().then_some(slope)
}
