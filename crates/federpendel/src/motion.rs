//! The motion: a chain of swings between turning points, until the mass rests.

use std::sync::OnceLock;

use crate::chain::cursor::Cursor;
use crate::chain::linear::LinearChain;
use crate::chain::series::SeriesChain;
use crate::chain::stop::StopChain;
use crate::chain::{Chain, Frame, Start};
use crate::error::{Error, Result, derived};
use crate::oscillator::{Oscillator, State};
use crate::outcome::Outcome;
use crate::parameter;
use crate::sampling::{self, Grid, Times};
use crate::sticking::Sticking;

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

/// How the motion is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// No Newton friction: everything in closed form.
    ClosedForm,
    /// Newton friction without Stokes friction: a first integral gives turning places and v(x) exactly
    /// (see [`crate::first_integral`]); the motion is followed as a series that agrees with it.
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
    /// The binary inputs are taken as exact, and arithmetic is as good as double-double (1e-30):
    /// what is nearer to the edge than that lies on it and sticks.
    Strict,
}

/// The motion of an oscillator after a release: every mix of friction, any time t ≥ 0.
#[derive(Debug, Clone)]
pub struct Motion {
    oscillator: Oscillator,
    release: State,
    pub(crate) sticking: Sticking,
    amplitude: f64,
    chain: Chain,
    pub(crate) outcome: OnceLock<Outcome>,
}

/// Drag stronger than this, κ times the amplitude, is refused: a swing would take too many steps.
const STRONGEST_DRAG: f64 = 1e5;

impl Motion {
    /// The motion of `oscillator` after `release`; on the edge of the band it sticks.
    ///
    /// # Errors
    /// [`Error::Derived`] if the amplitude or the energy of the release overflow or underflow,
    /// [`Error::DragTooStrong`] if κ times the amplitude is above 1e5.
    pub fn new(oscillator: Oscillator, release: State) -> Result<Self> {
        Self::with_ties(oscillator, release, Ties::Stick)
    }

    /// The same with a choice for the edge of the band.
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn with_ties(oscillator: Oscillator, release: State, ties: Ties) -> Result<Self> {
        let reduced = oscillator.reduced();
        let amplitude = release.position.abs().max(release.velocity.abs() / reduced.omega0.hi());
        const OF: &[&str] = &["mass", "stiffness", "position", "velocity"];
        let moves = release.position != 0.0 || release.velocity != 0.0;
        derived("position", &["position"], release.position, release.position != 0.0)?;
        derived("velocity", &["velocity"], release.velocity, release.velocity != 0.0)?;
        derived("amplitude", OF, amplitude, moves)?;
        let scaled = release.velocity / reduced.omega0.hi();
        derived("velocity/angular_frequency", OF, scaled, release.velocity != 0.0)?;
        derived("energy", OF, oscillator.energy(release), moves)?;
        let drag = reduced.kappa * amplitude;
        // The series of drag multiplies lengths, and its coefficients grow.
        derived("amplitude^3", OF, amplitude.powi(3), moves && reduced.kappa > 0.0)?;
        // In units of ω0² m, in which it is computed, and in SI units.
        let damped = amplitude * (1.0 + 2.0 * reduced.zeta.hi() + drag);
        let acceleration = damped + reduced.offset.hi();
        derived("acceleration/omega0^2", OF, acceleration, moves)?;
        let unit = reduced.omega0.hi() * reduced.omega0.hi();
        derived("acceleration", OF, acceleration * unit, moves)?;
        if drag > STRONGEST_DRAG {
            return Err(Error::DragTooStrong { value: drag, limit: STRONGEST_DRAG });
        }
        let sticking = Sticking::new(reduced, amplitude, ties);
        let first = Start::release(reduced, &sticking, release.position, release.velocity);
        let stop = StopChain::new(reduced, first, amplitude)
            .map_err(|_| Error::DragTooStrong { value: drag, limit: STRONGEST_DRAG })?;
        let chain = if let Some(stop) = stop {
            Chain::Stop(Box::new(stop))
        } else if reduced.kappa > 0.0 {
            Chain::Series(Box::new(SeriesChain::new(reduced, &sticking, first, amplitude)))
        } else {
            let error = CLOSED_FORM_ERROR * amplitude;
            Chain::Linear(Box::new(LinearChain::new(reduced, &sticking, first, error)))
        };
        Ok(Self { oscillator, release, sticking, amplitude, chain, outcome: OnceLock::new() })
    }

    /// With Newton friction follows at most so many swings instead of 1e7, for those who cannot wait: each takes some
    /// microseconds. Without it the motion has formulas for any number of swings, and nothing changes.
    #[must_use]
    pub fn with_most_swings(mut self, most: u64) -> Self {
        if let Chain::Series(chain) = &mut self.chain {
            chain.most_swings = most;
            self.outcome = OnceLock::new();
        }
        self
    }

    /// The oscillator.
    pub fn oscillator(&self) -> &Oscillator {
        &self.oscillator
    }

    /// The release.
    pub fn release(&self) -> State {
        self.release
    }

    /// The larger of |x0| and |v0|/ω0, m: errors are relative to it.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// How this motion is known.
    pub fn kind(&self) -> Kind {
        let mix = self.oscillator.friction().mix();
        match (mix.newton, mix.stokes) {
            (false, _) => Kind::ClosedForm,
            (true, false) => Kind::FirstIntegral,
            (true, true) => Kind::Series,
        }
    }

    /// Bound on the error of every position up to `time` (s), m; times ω0 it bounds that of the
    /// velocity.
    ///
    /// # Errors
    /// As [`Motion::at`].
    pub fn error_bound(&self, time: f64) -> Result<f64> {
        Ok(match &self.chain {
            Chain::Linear(_) | Chain::Stop(_) => CLOSED_FORM_ERROR * self.amplitude,
            Chain::Series(chain) => chain.error(self.cursor_at(time)?.start().index),
        })
    }

    /// What rounding of a `time` (s) that was itself computed, such as the end of a record, makes of the phase, as a
    /// length, m: no position is that wrong, but a velocity that should be zero then is, and a formula knows its phase no
    /// better.
    pub fn phase_error(&self, time: f64) -> f64 {
        TIME_ERROR * self.oscillator.angular_frequency() * time * self.amplitude
    }

    pub(crate) fn chain(&self) -> &Chain {
        &self.chain
    }

    pub(crate) fn cursor(&self, dense: bool) -> Cursor<'_> {
        Cursor::new(self.oscillator.reduced(), &self.chain, dense)
    }

    fn cursor_at(&self, time: f64) -> Result<Cursor<'_>> {
        parameter::TIME.check(time)?;
        let mut cursor = self.cursor(true);
        cursor.seek(&self.chain, time)?;
        Ok(cursor)
    }

    /// The motion at `time` ≥ 0, s.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a negative time, NaN or infinity; [`Error::TooManySwings`] beyond 1e7
    /// swings with Newton friction (see [`Motion::with_most_swings`]), or 2⁵³ without.
    pub fn at(&self, time: f64) -> Result<Sample> {
        Ok(self.sample_on(&self.cursor_at(time)?, time))
    }

    /// The sample at `time` on the swing under the cursor, which must hold it.
    pub(crate) fn sample_on(&self, cursor: &Cursor, time: f64) -> Sample {
        let start = cursor.start();
        if start.rests() {
            let position = start.x.into();
            return Sample { time, position, velocity: 0.0, acceleration: 0.0, mode: Mode::Stuck };
        }
        let reduced = self.oscillator.reduced();
        let (omega0, zeta, kappa) = (reduced.omega0.hi(), reduced.zeta.hi(), reduced.kappa);
        let (y, w) = cursor.framed_at(cursor.tau(time));
        let Frame { side, origin, shift } = cursor.frame();
        // The release itself, not what is left of it after two changes of frame.
        let (position, velocity) = if time == 0.0 {
            (self.release.position, self.release.velocity)
        } else {
            (side * y + origin, side * w * omega0)
        };
        Sample {
            time,
            // Adding zero makes a negative zero positive.
            position: position + 0.0,
            velocity: velocity + 0.0,
            acceleration: side * (kappa * w * w - 2.0 * zeta * w - (y + shift)) * omega0 * omega0
                + 0.0,
            mode: if start.direction > 0.0 { Mode::Forward } else { Mode::Backward },
        }
    }

    /// The motion at each of `times` (s), in any order; rising times are fastest.
    ///
    /// # Errors
    /// As [`Motion::at`].
    pub fn samples(&self, times: &[f64]) -> Result<Vec<Sample>> {
        let mut cursor = self.cursor(true);
        let at = |&time: &f64| {
            cursor.seek(&self.chain, parameter::TIME.check(time)?)?;
            Ok(self.sample_on(&cursor, time))
        };
        times.iter().map(at).collect()
    }

    /// Positions (m) and velocities (m/s) at `times` (s), in any order; rising times are fastest,
    /// others are sorted first.
    ///
    /// # Errors
    /// As [`Motion::at`], and [`Error::Length`] if the buffers differ.
    pub fn sample(
        &self,
        times: &[f64],
        positions: &mut [f64],
        velocities: &mut [f64],
    ) -> Result<()> {
        for (name, found) in [("positions", positions.len()), ("velocities", velocities.len())] {
            if found != times.len() {
                return Err(Error::Length { name, found, expected: times.len() });
            }
        }
        sampling::fill(self, &Times::Any(times), positions, velocities)
    }

    /// Positions (m) and velocities (m/s) at the even times `duration`·i/(n − 1), i = 0 … n − 1, with n
    /// the length of the buffers; the fastest way to a whole record.
    ///
    /// # Errors
    /// As [`Motion::sample`]; n must be at least 2.
    pub fn sample_even(
        &self,
        duration: f64,
        positions: &mut [f64],
        velocities: &mut [f64],
    ) -> Result<()> {
        parameter::DURATION.check(duration)?;
        parameter::SAMPLES.check(positions.len() as f64)?;
        if velocities.len() != positions.len() {
            let (found, expected) = (velocities.len(), positions.len());
            return Err(Error::Length { name: "velocities", found, expected });
        }
        let grid = Grid::new(self.oscillator.reduced(), duration, positions.len());
        sampling::fill(self, &Times::Even(&grid), positions, velocities)
    }

    /// All turning points with t > 0, in order, one at a time; endless if the mass never rests.
    pub fn turning_points(&self) -> impl Iterator<Item = TurningPoint> + '_ {
        let reduced = self.oscillator.reduced();
        let mut cursor = self.cursor(false);
        std::iter::from_fn(move || {
            let index = cursor.start().index;
            while cursor.start().index == index {
                if !cursor.advance() {
                    return None;
                }
            }
            let start = cursor.start();
            Some(TurningPoint { time: start.time(reduced), position: start.x.into() })
        })
    }
}

/// Relative error of a time that was itself computed.
const TIME_ERROR: f64 = 16.0 * f64::EPSILON;

/// Bound on the error of a closed-form position, relative to the amplitude.
const CLOSED_FORM_ERROR: f64 = 8.0 * f64::EPSILON;

/// The times `duration`·i/(`samples` − 1), s, the last one `duration` itself.
///
/// # Errors
/// [`Error::Parameter`] for a duration that is not above zero and finite, or fewer than two samples.
pub fn even_times(duration: f64, samples: usize) -> Result<Vec<f64>> {
    parameter::DURATION.check(duration)?;
    parameter::SAMPLES.check(samples as f64)?;
    let last = (samples - 1) as f64;
    Ok((0..samples).map(|i| even_time(duration, last, i as f64)).collect())
}

/// Time `i` of `last` + 1 even ones; the last is `duration` itself.
pub(crate) fn even_time(duration: f64, last: f64, i: f64) -> f64 {
    let product = duration * i;
    if i == last {
        duration
    } else if product.is_finite() {
        product / last
    } else {
        duration * (i / last)
    }
}
