//! The motion: a chain of swings between turning points, until the mass rests.

use crate::error::Result;
use crate::oscillator::{Oscillator, State};

/// Which way the mass moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(i8)]
pub enum Mode {
    /// Towards negative positions.
    Backward = -1,
    /// It is at rest.
    Stuck = 0,
    /// Towards positive positions.
    Forward = 1,
}

/// The motion at one time; at a turning point and at rest the limit from the right.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time t, s.
    pub time: f64,
    /// Position x, m.
    pub position: f64,
    /// Velocity v, m/s.
    pub velocity: f64,
    /// Acceleration, m/s².
    pub acceleration: f64,
    /// Which way the mass moves from here.
    pub mode: Mode,
}

impl Sample {
    /// Position and velocity alone.
    pub fn state(&self) -> State {
        State { position: self.position, velocity: self.velocity }
    }
}

/// A time t > 0 at which the velocity becomes zero; the place of rest is the last one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningPoint {
    /// Time, s.
    pub time: f64,
    /// Position, m.
    pub position: f64,
}

/// Where and when the mass comes to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// Time, s; zero if it is released at rest.
    pub time: f64,
    /// Position, m.
    pub position: f64,
    /// Number of swings until then; the first one may be a partial one.
    pub swings: u64,
    /// Distance of the place inside the edge of the sticking band, over the half width of the band;
    /// negative when only [`Ties::Stick`] made it stick. Without Coulomb friction, zero.
    pub margin: f64,
    /// Whether the edge is so near that rounding of the inputs decides.
    pub tie: bool,
}

/// How a motion ends.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Outcome {
    /// The mass comes to rest.
    Rests(Rest),
    /// The mass never rests but creeps to this place, m, without turning any more.
    Creeps {
        /// The place, m.
        limit: f64,
    },
    /// The mass swings for ever, with falling or constant amplitude.
    Swings,
    /// Nothing is known after the time at which the search for a rest was given up.
    Unknown {
        /// Time of the last turning point followed, s.
        after: f64,
        /// Number of swings until then.
        swings: u64,
    },
}

/// How the motion is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// No Newton friction: everything in closed form.
    ClosedForm,
    /// Newton friction without Stokes friction: turning places and v(x) from a first integral.
    FirstIntegral,
    /// Stokes and Newton friction: every swing as a series, to rounding.
    Series,
}

impl Kind {
    /// The label in files: `closed-form`, `first-integral` or `series`.
    pub fn name(self) -> &'static str {
        match self {
            Kind::ClosedForm => "closed-form",
            Kind::FirstIntegral => "first-integral",
            Kind::Series => "series",
        }
    }
}

/// What happens at a turning point on the very edge of the sticking band.
///
/// Round-number experiments often end a swing exactly there in decimals, which the binary numbers
/// that hold the inputs cannot say.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Ties {
    /// Within the accumulated rounding of inputs and arithmetic the mass sticks.
    #[default]
    Stick,
    /// The binary inputs are taken as exact.
    Strict,
}

/// The motion of an oscillator after a release: every mix of friction, any time t ≥ 0.
#[derive(Debug, Clone)]
pub struct Motion {
    oscillator: Oscillator,
    release: State,
}

impl Motion {
    /// The motion of `oscillator` after `release`; on the edge of the band it sticks.
    ///
    /// # Errors
    /// [`Error::Derived`](crate::Error::Derived) if amplitude or energy overflow.
    pub fn new(oscillator: Oscillator, release: State) -> Result<Self> {
        Self::with_ties(oscillator, release, Ties::Stick)
    }

    /// The same with a choice for the edge of the band.
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn with_ties(oscillator: Oscillator, release: State, ties: Ties) -> Result<Self> {
        let _ = ties;
        Ok(Self { oscillator, release })
    }

    /// The oscillator.
    pub fn oscillator(&self) -> &Oscillator {
        &self.oscillator
    }

    /// The release.
    pub fn release(&self) -> State {
        self.release
    }

    /// How this motion is known.
    pub fn kind(&self) -> Kind {
        todo!()
    }

    /// Bound on the error of every position up to `time` (s), in m; divided by 1/ω0 it bounds
    /// that of the velocity.
    ///
    /// # Errors
    /// As [`Motion::at`].
    pub fn error_bound(&self, _time: f64) -> Result<f64> {
        todo!()
    }

    /// The motion at `time` ≥ 0, s.
    ///
    /// # Errors
    /// [`Error::Parameter`](crate::Error::Parameter) for a negative time, NaN or infinity;
    /// [`Error::TooManySwings`](crate::Error::TooManySwings) with Newton friction beyond the swings
    /// that are followed.
    pub fn at(&self, _time: f64) -> Result<Sample> {
        todo!()
    }

    /// Positions (m) and velocities (m/s) at `times` (s), in any order.
    ///
    /// # Errors
    /// As [`Motion::at`], and [`Error::Length`](crate::Error::Length) if the buffers differ.
    pub fn sample(
        &self,
        _times: &[f64],
        _positions: &mut [f64],
        _velocities: &mut [f64],
    ) -> Result<()> {
        todo!()
    }

    /// Positions (m) and velocities (m/s) at the even times `duration`·i/(n − 1), i = 0 … n − 1, with n
    /// the length of the buffers; the fastest way to a whole record.
    ///
    /// # Errors
    /// As [`Motion::sample`]; n must be at least 2.
    pub fn sample_even(
        &self,
        _duration: f64,
        _positions: &mut [f64],
        _velocities: &mut [f64],
    ) -> Result<()> {
        todo!()
    }

    /// All turning points with 0 < t, in order, one at a time; endless if the mass never rests.
    pub fn turning_points(&self) -> impl Iterator<Item = TurningPoint> + '_ {
        std::iter::empty()
    }

    /// How the motion ends. With Newton friction this follows up to 1e7 swings.
    pub fn outcome(&self) -> Outcome {
        todo!()
    }
}
