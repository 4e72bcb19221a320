//! How far a method is from the exact motion.

use super::Course;
use crate::error::Result;
use crate::motion::Motion;
use crate::oscillator::State;

/// How far a method is from the exact motion, on its own steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// Largest error of a position, m.
    pub largest: f64,
    /// When that was, s.
    pub time_of_largest: f64,
    /// Root of the mean over time of the squared error of the position, m.
    pub root_mean_square: f64,
    /// Largest error of kinetic and potential energy, over the energy of the release; none where that is zero.
    pub energy: Option<f64>,
    /// Position at the end, m.
    pub final_position: f64,
    /// Steps taken.
    pub steps: u64,
}

/// Takes in the states of a method, with rising times, and holds them against the exact motion.
pub struct Gauge<'m> {
    motion: &'m Motion,
    times: Vec<f64>,
    states: Vec<State>,
    largest: (f64, f64),
    energy: f64,
    /// Integral of the squared error, m² s, up to the last state, and its time and error.
    integral: f64,
    last: Option<(f64, f64)>,
}

/// States that are compared at once.
const BLOCK: usize = 4096;

impl<'m> Gauge<'m> {
    /// A gauge for this motion.
    pub fn new(motion: &'m Motion) -> Self {
        Gauge {
            motion,
            times: Vec::new(),
            states: Vec::new(),
            largest: (0.0, 0.0),
            energy: 0.0,
            integral: 0.0,
            last: None,
        }
    }

    /// Takes in the state at `time`, s.
    ///
    /// # Errors
    /// As [`Motion::sample`].
    pub fn add(&mut self, time: f64, state: State) -> Result<()> {
        self.times.push(time);
        self.states.push(state);
        if self.times.len() == BLOCK { self.compare() } else { Ok(()) }
    }

    /// What was found; the final position is that of the last state.
    ///
    /// # Errors
    /// As [`Motion::sample`].
    pub fn finish(mut self, steps: u64) -> Result<Errors> {
        let last = self.states.last().copied();
        self.compare()?;
        let duration = self.last.map_or(0.0, |(time, _)| time);
        let mean = if duration > 0.0 { self.integral / duration } else { 0.0 };
        Ok(Errors {
            largest: self.largest.0,
            time_of_largest: self.largest.1,
            root_mean_square: mean.sqrt(),
            energy: (self.motion.initial_energy() > 0.0).then_some(self.energy),
            final_position: last.map_or(f64::NAN, |state| state.position),
            steps,
        })
    }

    fn compare(&mut self) -> Result<()> {
        let oscillator = self.motion.oscillator();
        let scale = self.motion.initial_energy().max(f64::MIN_POSITIVE);
        let (mut x, mut v) = (vec![0.0; self.times.len()], vec![0.0; self.times.len()]);
        self.motion.sample(&self.times, &mut x, &mut v)?;
        let exact = x.iter().zip(&v).map(|(&position, &velocity)| State { position, velocity });
        for ((&time, &state), exact) in self.times.iter().zip(&self.states).zip(exact) {
            let error = (state.position - exact.position).abs();
            if error > self.largest.0 {
                self.largest = (error, time);
            }
            let energy = (oscillator.energy(state) - oscillator.energy(exact)).abs() / scale;
            self.energy = self.energy.max(energy);
            if let Some((before, former)) = self.last {
                let squares = 0.5 * (error * error + former * former);
                self.integral += (time - before) * squares;
            }
            self.last = Some((time, error));
        }
        self.times.clear();
        self.states.clear();
        Ok(())
    }
}

/// The errors of a method on its own steps from 0 to `duration`, s; the end itself is added.
///
/// # Errors
/// What makes the method fail, see [`Course::check`] and [`Course::step`].
pub fn errors(motion: &Motion, course: &mut Course, duration: f64) -> Result<Errors> {
    course.check(duration)?;
    let mut gauge = Gauge::new(motion);
    let (mut time, mut state) = course.now();
    while time < duration {
        gauge.add(time, state)?;
        course.step()?;
        (time, state) = course.now();
    }
    gauge.add(duration, course.at(duration)?)?;
    gauge.finish(course.steps())
}
