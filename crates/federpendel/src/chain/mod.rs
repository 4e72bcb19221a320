//! The chain of swings that makes a motion, and a cursor that walks along it.

pub(crate) mod cursor;
pub(crate) mod linear;
pub(crate) mod series;
pub(crate) mod stop;

use crate::chain::linear::LinearChain;
use crate::chain::series::SeriesChain;
use crate::chain::stop::StopChain;
use crate::double::Double;
use crate::oscillator::Reduced;
use crate::sticking::Sticking;

/// The swings of a motion.
#[derive(Debug, Clone)]
pub(crate) enum Chain {
    /// Without Newton friction.
    Linear(Box<LinearChain>),
    /// With it.
    Series(Box<SeriesChain>),
    /// A throw that dry friction ends at once.
    Stop(Box<StopChain>),
}

/// Where a swing starts: the release, a turning point, or a point within a swing from which another
/// way of solving it takes over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Start {
    /// Number of turning points up to here.
    pub index: u64,
    /// Time ω0 t.
    pub tau: Double,
    /// Position, m.
    pub x: Double,
    /// Velocity over ω0, m.
    pub w: f64,
    /// −1 or +1, the way the mass moves from here; 0 if it rests.
    pub direction: f64,
    /// Bound on what arithmetic may have added to the distance of a turning point, m.
    pub error: f64,
}

impl Start {
    /// The release at `position` m with `velocity` m/s.
    pub fn release(reduced: &Reduced, sticking: &Sticking, position: f64, velocity: f64) -> Self {
        let (tau, x) = (0.0.into(), position.into());
        let mut start = Start { index: 0, tau, x, w: 0.0, direction: 0.0, error: 0.0 };
        if velocity == 0.0 {
            start.direction = departure(start.x, sticking.verdict(start.x, 0, 0.0).sticks);
        } else {
            start.w = (velocity * reduced.time_unit).into();
            start.direction = velocity.signum();
        }
        start
    }

    /// The turning point that ends the swing from here, after `duration`, at `y` in the frame of
    /// the swing. `error` bounds the arithmetic behind `y`, m.
    pub fn turn(
        &self,
        duration: Double,
        y: Double,
        offset: Double,
        sticking: &Sticking,
        error: f64,
    ) -> Self {
        let index = self.index + 1;
        let x = -self.direction * (y + offset);
        let direction = departure(x, sticking.verdict(x, index, error).sticks);
        // A throw too slow for its swing to take any time can come out shorter than none.
        let duration = if duration.hi() > 0.0 { duration } else { 0.0.into() };
        Start { index, tau: self.tau + duration, x, w: 0.0, direction, error }
    }

    /// State in the frame of the swing from here (see [`crate::swing`]): (y, w).
    pub fn framed(&self, offset: Double) -> (Double, f64) {
        (-self.direction * self.x - offset, -self.direction * self.w)
    }

    /// The time of this start, s.
    pub fn time(&self, reduced: &Reduced) -> f64 {
        (self.tau * reduced.time_unit).into()
    }

    pub fn rests(&self) -> bool {
        self.direction == 0.0
    }
}

/// Position x = `side`·y + `origin` of the y that a swing is computed in, and the distance y + `shift` from the
/// centre of that swing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    pub side: f64,
    pub origin: f64,
    pub shift: f64,
}

/// From a turning point the mass moves towards the centre, unless it sticks.
fn departure(x: Double, sticks: bool) -> f64 {
    if sticks { 0.0 } else { -x.hi().signum() }
}
