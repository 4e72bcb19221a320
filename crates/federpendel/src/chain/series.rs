//! The chain with Newton friction: swing after swing as a series, with places kept to come back to.

use std::sync::Mutex;

use crate::chain::Start;
use crate::chain::linear::LinearChain;
use crate::oscillator::Reduced;
use crate::sticking::Sticking;
use crate::swing::piece::Piece;
use crate::swing::stiff::Stiff;
use crate::swing::taylor::{NEGLIGIBLE, Taylor};
use crate::swing::{End, NotFollowed};

/// So many swings are followed unless one says otherwise; then the motion is given up as unknown.
const MOST_SWINGS: u64 = 10_000_000;

/// The swings from the release on.
#[derive(Debug)]
pub(crate) struct SeriesChain {
    reduced: Reduced,
    sticking: Sticking,
    taylor: Taylor,
    /// Takes the place of the Taylor series where damping is so strong that it would need many steps.
    stiff: Option<Stiff>,
    amplitude: f64,
    first: Start,
    /// So many swings are followed; then the motion is given up as unknown.
    pub most_swings: u64,
    known: Mutex<Known>,
}

/// Damping ratio from which a swing is solved implicitly.
const STIFF: f64 = 3.0;

/// Starts that were passed, to come back to: every `stride`-th.
#[derive(Debug, Clone)]
struct Known {
    starts: Vec<Start>,
    stride: u64,
    tail: Option<LinearChain>,
}

/// More are not kept: then every second one is dropped and the stride doubles.
const MOST_KNOWN: usize = 1 << 15;

/// What follows a swing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Next {
    /// Another start on this chain.
    Start(Start),
    /// Drag has become negligible: the rest of the motion, the rest of a swing first if its start is
    /// not a turning point.
    Tail(Box<LinearChain>),
}

impl Clone for SeriesChain {
    fn clone(&self) -> Self {
        let known =
            self.known.lock().map_or_else(|_| Known::new(self.first), |known| known.clone());
        SeriesChain { known: Mutex::new(known), ..*self }
    }
}

impl Known {
    fn new(first: Start) -> Self {
        Known { starts: vec![first], stride: 1, tail: None }
    }

    fn insert(&mut self, start: Start) {
        let newer = self.starts.last().is_none_or(|last| last.index < start.index);
        if !newer || !start.index.is_multiple_of(self.stride) {
            return;
        }
        if self.starts.len() == MOST_KNOWN {
            self.stride *= 2;
            self.starts.retain(|start| start.index.is_multiple_of(self.stride));
        }
        self.starts.push(start);
    }
}

impl SeriesChain {
    pub fn new(reduced: &Reduced, sticking: &Sticking, first: Start, amplitude: f64) -> Self {
        let zeta = reduced.zeta.into();
        let stiff = (zeta >= STIFF).then_some(Stiff { zeta, kappa: reduced.kappa, amplitude });
        SeriesChain {
            reduced: *reduced,
            sticking: *sticking,
            taylor: Taylor::new(reduced),
            stiff,
            amplitude,
            first,
            most_swings: MOST_SWINGS,
            known: Mutex::new(Known::new(first)),
        }
    }

    /// Bound on the error of a state up to the turning point `index`, m: the phase keeps all errors.
    pub fn error(&self, index: u64) -> f64 {
        self.amplitude * f64::EPSILON * (8.0 + 0.5 * index as f64)
    }

    /// Bound on the error of the distance at which a swing from (y0, w0) ends, at `y`. What the start
    /// brought along falls at least as the distance itself: friction draws neighbours together.
    fn distance_error(&self, start: &Start, y0: f64, w0: f64, y: f64) -> f64 {
        let fall = if w0 == 0.0 { (y / y0).abs() } else { 1.0 };
        fall * start.error + 8.0 * f64::EPSILON * y0.abs().max(w0.abs())
    }

    /// Follows the swing from `start` and leaves its pieces, if asked.
    ///
    /// # Errors
    /// [`NotFollowed`] if its solver comes to no end.
    pub fn solve(
        &self,
        start: &Start,
        pieces: Option<&mut Vec<Piece>>,
    ) -> Result<Next, NotFollowed> {
        let (y0, w0) = start.framed(self.reduced.offset);
        let end = match &self.stiff {
            Some(stiff) => stiff.solve(y0.into(), w0, pieces),
            None => self.taylor.solve(y0, w0, pieces),
        };
        let next = match end? {
            End::Reversal { tau, y } => {
                let error = self.distance_error(start, y0.into(), w0, y.into());
                let turn = start.turn(tau, y, self.reduced.offset, &self.sticking, error);
                if turn.rests() || !self.drag_is_negligible(turn.x.hi().abs()) {
                    Next::Start(turn)
                } else {
                    Next::Tail(Box::new(self.tail(turn, error)))
                }
            }
            End::Linear { tau, y, w } => {
                let x = -start.direction * (self.reduced.offset + y);
                let within = Start { tau: start.tau + tau, x, w: -start.direction * w, ..*start };
                let error = self.distance_error(start, y0.into(), w0, y);
                Next::Tail(Box::new(self.tail(within, error)))
            }
        };
        self.remember(&next);
        Ok(next)
    }

    fn tail(&self, first: Start, error: f64) -> LinearChain {
        LinearChain::new(&self.reduced, &self.sticking, first, error)
    }

    /// Whether all that drag can still do is below rounding even of the amplitude `a` left. The
    /// swings to come lose at most 4κa²/3 each; damping makes their squares a geometric series, Coulomb
    /// friction leaves a/2f of them.
    fn drag_is_negligible(&self, a: f64) -> bool {
        let damped = 1.0 / (1.0 - self.taylor.ratio.hi());
        let dry = a / (2.0 * self.reduced.offset.hi()) + 1.0;
        self.reduced.kappa * a * damped.min(dry) < NEGLIGIBLE
    }

    fn remember(&self, next: &Next) {
        // Another thread that holds the lock is remembering the same swings.
        let Ok(mut known) = self.known.try_lock() else { return };
        match next {
            Next::Start(start) => known.insert(*start),
            Next::Tail(tail) => known.tail = Some(**tail),
        }
    }

    /// The last known place of the motion at or before `time` s.
    pub fn known_before(&self, time: f64) -> Next {
        let Ok(known) = self.known.lock() else { return Next::Start(self.first) };
        if let Some(tail) = known.tail.filter(|tail| tail.first().time(&self.reduced) <= time) {
            return Next::Tail(Box::new(tail));
        }
        let later = known.starts.partition_point(|start| start.time(&self.reduced) <= time);
        Next::Start(known.starts[later.saturating_sub(1)])
    }

    pub fn first(&self) -> Start {
        self.first
    }

    /// Whether the linear part of the motion swings for ever.
    pub fn swings_on(&self) -> bool {
        self.taylor.half_period.is_some()
    }
}
