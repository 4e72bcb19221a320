//! How far samples are from the exact motion.

use std::collections::HashMap;

use federpendel::Result;

use super::problem::Problem;
use super::rest::AfterRest;
use super::samples::Samples;

/// Errors of one quantity, over its scale.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Errors {
    /// The largest one.
    pub largest: f64,
    /// When that is, s.
    pub time_of_largest: f64,
    /// Root of the mean over the samples of the squared error.
    pub root_mean_square: f64,
}

/// What is found of the samples at times that the problem stores, over the scales.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct AtStored {
    /// How many there are.
    pub samples: usize,
    /// Largest error of a position.
    pub position: f64,
    /// Largest error of a velocity, if there are any.
    pub velocity: Option<f64>,
}

/// Everything that is found of samples.
#[derive(Debug)]
pub(crate) struct Score<'a> {
    /// The problem.
    pub problem: Problem<'a>,
    /// The amplitude max(|x0|, |v0|/ω0), m.
    pub amplitude: f64,
    /// What errors of positions are divided by, m: the amplitude, or 1 m where that is zero.
    pub length: f64,
    /// What errors of velocities are divided by, m/s: ω0 times the length.
    pub speed: f64,
    /// Bound on the error of the exact motion itself, over the length.
    pub bound: f64,
    /// How many samples there are.
    pub samples: usize,
    /// Errors of the positions.
    pub position: Errors,
    /// Errors of the velocities, if there are any.
    pub velocity: Option<Errors>,
    /// The time of the last sample, s, and its error over the length, with its sign.
    pub last: (f64, f64),
    /// What is found at the stored times; none if no sample has one.
    pub stored: Option<AtStored>,
    /// What the samples do after the rest; none if the mass never rests.
    pub rest: Option<AfterRest>,
}

impl<'a> Score<'a> {
    /// Holds `samples` against the exact motion of `problem`.
    ///
    /// # Errors
    /// A time that lies more swings ahead than are followed.
    pub(super) fn new(problem: Problem<'a>, samples: &Samples) -> Result<Self> {
        let motion = problem.motion()?;
        let times = &samples.times;
        let (mut x, mut v) = (vec![0.0; times.len()], vec![0.0; times.len()]);
        motion.sample(times, &mut x, &mut v)?;
        let amplitude = motion.amplitude();
        let length = if amplitude > 0.0 { amplitude } else { 1.0 };
        let speed = motion.oscillator().angular_frequency() * length;
        let latest = (0..times.len()).max_by(|a, b| times[*a].total_cmp(&times[*b])).unwrap_or(0);
        Ok(Score {
            amplitude,
            length,
            speed,
            bound: motion.error_bound(times[latest])? / length,
            samples: times.len(),
            position: errors(times, &samples.positions, &x, length),
            velocity: samples.velocities.as_ref().map(|found| errors(times, found, &v, speed)),
            last: (times[latest], (samples.positions[latest] - x[latest]) / length),
            stored: at_stored(&problem, samples, length, speed),
            rest: AfterRest::of(&motion, samples, length),
            problem,
        })
    }
}

fn errors(times: &[f64], found: &[f64], exact: &[f64], scale: f64) -> Errors {
    let mut errors = Errors::default();
    let mut squares = 0.0;
    for ((&time, found), exact) in times.iter().zip(found).zip(exact) {
        let error = (found - exact).abs() / scale;
        squares += error * error;
        if error > errors.largest {
            errors = Errors { largest: error, time_of_largest: time, ..errors };
        }
    }
    errors.root_mean_square = (squares / times.len() as f64).sqrt();
    errors
}

/// Compares the samples whose times are stored, to the last bit, with the stored digits.
fn at_stored(
    problem: &Problem<'_>,
    samples: &Samples,
    length: f64,
    speed: f64,
) -> Option<AtStored> {
    let stored = problem.samples.iter().filter_map(|stored| {
        let time: f64 = stored.written.parse().ok()?;
        Some((time.to_bits(), stored))
    });
    let stored: HashMap<u64, _> = stored.collect();
    let mut found =
        AtStored { velocity: samples.velocities.as_ref().map(|_| 0.0), ..AtStored::default() };
    for (at, time) in samples.times.iter().enumerate() {
        let Some(answer) = stored.get(&time.to_bits()) else { continue };
        found.samples += 1;
        let error = (samples.positions[at] - answer.position).abs() / length;
        found.position = found.position.max(error);
        if let (Some(largest), Some(velocities)) = (&mut found.velocity, &samples.velocities) {
            *largest = largest.max((velocities[at] - answer.velocity).abs() / speed);
        }
    }
    (found.samples > 0).then_some(found)
}
