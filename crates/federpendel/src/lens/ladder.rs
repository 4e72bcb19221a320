//! The observed order of a method: the slope of its error against its step.

use std::f64::consts::PI;

use super::{Course, errors};
use crate::error::Result;
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
pub const LONGEST: f64 = 12.0;

/// Steps in an undamped period on the coarsest rung; each of the others has twice as many as the one before.
const COARSEST: f64 = 64.0;

/// Rungs: six halvings.
const RUNGS: u32 = 7;

/// The largest of the tolerances; each of the others is a tenth of the one before.
const LOOSEST: f64 = 1e-5;

/// The errors of `scheme` up to `duration` (s) or twelve periods, with six halvings of the time step from a
/// 64th of the undamped period on, or six tenths of the tolerance from 1e-3 on.
///
/// # Errors
/// What makes the method fail on any rung.
pub fn ladder(
    motion: &Motion,
    scheme: &Scheme,
    setting: &Setting,
    duration: f64,
) -> Result<Vec<Rung>> {
    let period = 2.0 * PI / motion.oscillator().angular_frequency();
    let duration = duration.min(LONGEST * period);
    let rung = |k: u32| {
        let (setting, tolerance) = if scheme.adaptive {
            let tolerance = LOOSEST * 0.1f64.powi(k as i32);
            (setting.with_tolerance(tolerance)?, Some(tolerance))
        } else {
            (setting.with_time_step(period / COARSEST * 0.5f64.powi(k as i32))?, None)
        };
        let found = errors(motion, &mut Course::new(scheme, &setting)?, duration)?;
        let mean = duration / found.steps as f64;
        let time_step = if scheme.adaptive { mean } else { setting.time_step() };
        Ok(Rung { time_step, tolerance, error: found.largest, steps: found.steps })
    };
    (0..RUNGS).map(rung).collect()
}

/// The slope of log error against log time step through all rungs, by least squares; none where an error
/// vanishes.
pub fn order(rungs: &[Rung]) -> Option<f64> {
    let points: Vec<_> = rungs.iter().map(|rung| (rung.time_step.ln(), rung.error.ln())).collect();
    let count = points.len() as f64;
    let mean = |get: fn(&(f64, f64)) -> f64| points.iter().map(get).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let sum = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>();
    let slope = sum(&|point| (point.0 - x) * (point.1 - y)) / sum(&|point| (point.0 - x).powi(2));
    slope.is_finite().then_some(slope)
}
