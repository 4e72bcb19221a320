//! What a method is to integrate, and how finely.

use super::article;
use crate::error::Result;
use crate::motion::Motion;
use crate::oscillator::{Oscillator, State};
use crate::parameter;

/// An experiment and the fineness of its integration. Every method takes of it what it needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    pub(super) oscillator: Oscillator,
    pub(super) release: State,
    pub(super) time_step: f64,
    pub(super) tolerance: f64,
    pub(super) width: f64,
}

/// From rest the reversals of a linear motion lie half a period apart. On a thousandth of the period they would
/// all fall on steps, which flatters methods that step over them: 320π steps to a period instead.
const OFF_THE_REVERSALS: f64 = 1000.0 / (320.0 * std::f64::consts::PI);

/// Tolerance where none is given.
const TOLERANCE: f64 = 1e-6;

/// Width of smooth friction where none is given, over the largest velocity of the spring alone.
const WIDTH: f64 = 0.01;

impl Setting {
    /// The defaults: steps of a 1005th of the period, which no reversal falls on, a tolerance of 1e-6, smooth friction over
    /// 1 % of the velocity ω0·max(|x0|, |v0|/ω0).
    ///
    /// # Errors
    /// [`Error::Parameter`](crate::Error::Parameter) for a release that is not finite.
    pub fn new(oscillator: Oscillator, release: State) -> Result<Self> {
        Ok(Self::defaults(oscillator, State::new(release.position, release.velocity)?))
    }

    fn defaults(oscillator: Oscillator, release: State) -> Self {
        let time_step = article::Scheme::default_time_step(&oscillator) * OFF_THE_REVERSALS;
        let mut setting =
            Setting { oscillator, release, time_step, tolerance: TOLERANCE, width: 1.0 };
        setting.width = WIDTH * setting.amplitude() * oscillator.angular_frequency();
        setting
    }

    /// The defaults for the oscillator and release of a motion.
    pub fn of(motion: &Motion) -> Self {
        Self::defaults(*motion.oscillator(), motion.release())
    }

    /// With another time step Δt, s.
    ///
    /// # Errors
    /// [`Error::Parameter`](crate::Error::Parameter) unless it is above zero and finite.
    pub fn with_time_step(self, time_step: f64) -> Result<Self> {
        Ok(Setting { time_step: parameter::TIME_STEP.check(time_step)?, ..self })
    }

    /// With another tolerance: error allowed in a step, over the amplitude max(|x0|, |v0|/ω0) for positions and
    /// over ω0 times that for velocities.
    ///
    /// # Errors
    /// [`Error::Parameter`](crate::Error::Parameter) unless it lies between 0 and 1.
    pub fn with_tolerance(self, tolerance: f64) -> Result<Self> {
        Ok(Setting { tolerance: parameter::TOLERANCE.check(tolerance)?, ..self })
    }

    /// With another width of smooth friction, m/s.
    ///
    /// # Errors
    /// [`Error::Parameter`](crate::Error::Parameter) unless it is above zero and finite.
    pub fn with_width(self, width: f64) -> Result<Self> {
        Ok(Setting { width: parameter::WIDTH.check(width)?, ..self })
    }

    /// The time step, s.
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// The tolerance.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The width of smooth friction, m/s.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// max(|x0|, |v0|/ω0), m; for a mass that is released at rest in the middle 1, so that a tolerance still
    /// means something.
    pub fn amplitude(&self) -> f64 {
        let omega = self.oscillator.angular_frequency();
        match self.release.position.abs().max(self.release.velocity.abs() / omega) {
            0.0 => 1.0,
            amplitude => amplitude,
        }
    }
}
