//! A place on the chain of swings, from which it is walked and sampled.

use crate::chain::linear::{self, LinearChain};
use crate::chain::series::{Next, SeriesChain};
use crate::chain::stop::StopChain;
use crate::chain::{Chain, Frame, Start};
use crate::error::{Error, Result};
use crate::oscillator::Reduced;
use crate::swing::piece::Piece;

/// One swing of a chain, or the rest that ends it.
#[derive(Debug, Clone)]
pub(crate) struct Cursor<'m> {
    reduced: Reduced,
    course: Course<'m>,
    start: Start,
    /// Times of this start and of the next, s; the next is infinite if there is none.
    from: f64,
    until: f64,
    next: Option<Next>,
    /// Dense output of the swing, where it is a series.
    pieces: Vec<Piece>,
    /// Whether pieces are wanted.
    dense: bool,
}

/// What solves the swing under the cursor.
#[derive(Debug, Clone)]
enum Course<'m> {
    Linear(Box<LinearChain>),
    Series(&'m SeriesChain),
    Stop(&'m StopChain),
}

impl<'m> Cursor<'m> {
    /// The cursor on the first swing. Without `dense` only starts are computed, no states between.
    pub fn new(reduced: &Reduced, chain: &'m Chain, dense: bool) -> Self {
        let (course, start) = match chain {
            Chain::Linear(chain) => (Course::Linear(chain.clone()), chain.first()),
            Chain::Series(chain) => (Course::Series(chain), chain.first()),
            Chain::Stop(chain) => (Course::Stop(chain), chain.first()),
        };
        let mut cursor = Cursor {
            reduced: *reduced,
            course,
            start,
            from: 0.0,
            until: f64::INFINITY,
            next: None,
            pieces: Vec::new(),
            dense,
        };
        cursor.enter(start);
        cursor
    }

    /// Puts the cursor on the swing that starts at `start` on its present course.
    fn enter(&mut self, start: Start) {
        self.enter_at(start, start.time(&self.reduced));
    }

    /// The same where the time `from` of that start is known, s.
    fn enter_at(&mut self, start: Start, from: f64) {
        self.start = start;
        self.from = from;
        // A swing that cannot be followed holds no time at all.
        let mut without_next = f64::INFINITY;
        self.next = if start.rests() {
            None
        } else {
            match &self.course {
                Course::Linear(chain) => chain.next(&start).map(Next::Start),
                Course::Series(chain) => {
                    let next = chain.solve(&start, self.dense.then_some(&mut self.pieces));
                    without_next = self.from;
                    next.ok()
                }
                Course::Stop(chain) => {
                    self.pieces = chain.pieces().to_vec();
                    Some(Next::Start(chain.rest()))
                }
            }
        };
        self.until = match &self.next {
            None => without_next,
            Some(Next::Start(next)) => next.time(&self.reduced),
            Some(Next::Tail(chain)) => chain.first().time(&self.reduced),
        };
    }

    /// Goes on to the next start; false if there is none.
    pub fn advance(&mut self) -> bool {
        match self.next.take() {
            None => return false,
            Some(next) => self.take_up(next, self.until),
        }
        true
    }

    /// Whether so many swings are behind it that no more are followed.
    pub fn is_given_up(&self) -> bool {
        matches!(self.course, Course::Series(chain) if self.start.index >= chain.most_swings)
    }

    /// Goes on to the next start on the way to `time`, s.
    ///
    /// # Errors
    /// [`Error::TooManySwings`] if the motion is not followed any further.
    pub fn advance_towards(&mut self, time: f64) -> Result<()> {
        if self.is_given_up() || !self.advance() {
            return Err(self.lost(time));
        }
        Ok(())
    }

    /// Goes on with `next`, which begins at `from`, s.
    fn take_up(&mut self, next: Next, from: f64) {
        match next {
            Next::Start(start) => self.enter_at(start, from),
            Next::Tail(chain) => {
                let first = chain.first();
                self.course = Course::Linear(chain);
                self.enter_at(first, from);
            }
        }
    }

    /// Goes to the swing that holds `time` ≥ 0, s.
    pub fn seek(&mut self, chain: &'m Chain, time: f64) -> Result<()> {
        if self.from <= time && time < self.until {
            return Ok(());
        }
        if time < self.from
            && let Chain::Series(series) = chain
        {
            self.course = Course::Series(series);
            let known = series.known_before(time);
            let from = match &known {
                Next::Start(start) => start.time(&self.reduced),
                Next::Tail(chain) => chain.first().time(&self.reduced),
            };
            self.take_up(known, from);
        }
        if let (true, Chain::Stop(stop)) = (time < self.from, chain) {
            self.enter(stop.first());
            return Ok(());
        }
        let wanted = self.dense;
        // Mostly it is the next swing.
        if self.until <= time && matches!(self.course, Course::Linear(_)) {
            self.advance();
            if time < self.until {
                return Ok(());
            }
        }
        loop {
            if let Course::Linear(linear) = &self.course {
                let tau = self.reduced.omega0 * time;
                let start = linear.index_at(time, tau).map(|index| linear.start(index));
                self.enter(start.ok_or_else(|| self.lost(time))?);
                return Ok(());
            }
            if time < self.until {
                if wanted && !self.dense {
                    self.dense = true;
                    self.enter(self.start);
                }
                return Ok(());
            }
            // Swings on the way need no states between their ends.
            self.dense = wanted && self.until + 1.5 * (self.until - self.from) > time;
            let advanced = self.advance_towards(time);
            if advanced.is_err() {
                self.dense = wanted;
                return advanced;
            }
        }
    }

    fn lost(&self, time: f64) -> Error {
        let (reached, swings) = match &self.course {
            Course::Linear(chain) => {
                let last = chain.start(linear::MOST_SWINGS);
                (last.time(&self.reduced), last.index)
            }
            Course::Series(_) | Course::Stop(_) => (self.from, self.start.index),
        };
        Error::TooManySwings { time, reached, swings }
    }

    pub fn start(&self) -> &Start {
        &self.start
    }

    pub fn from(&self) -> f64 {
        self.from
    }

    pub fn until(&self) -> f64 {
        self.until
    }

    /// Until when, s, one formula gives the motion from this swing on: without dry friction it goes through turning
    /// points.
    pub fn formula_until(&self) -> f64 {
        match &self.course {
            Course::Linear(chain) => chain.formula_until().max(self.until),
            Course::Series(_) | Course::Stop(_) => self.until,
        }
    }

    /// The chain in closed form that the cursor is on, if it is on one.
    pub fn linear(&self) -> Option<&LinearChain> {
        match &self.course {
            Course::Linear(chain) => Some(chain),
            Course::Series(_) | Course::Stop(_) => None,
        }
    }

    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Time since the start of the swing, ω0 t, at `time` (s), which it must hold.
    pub fn tau(&self, time: f64) -> f64 {
        // So far out, where double-double would overflow, it has no digits to add.
        let coarse = self.reduced.omega0.hi() * time;
        if coarse > 1e200 {
            return coarse;
        }
        f64::from(self.reduced.omega0 * time - self.start.tau).max(0.0)
    }

    /// Duration of the swing, ω0 t; infinite if it never ends.
    pub fn duration(&self) -> f64 {
        let next = match &self.next {
            None => return f64::INFINITY,
            Some(Next::Start(next)) => *next,
            Some(Next::Tail(chain)) => chain.first(),
        };
        (next.tau - self.start.tau).into()
    }

    /// The frame of the swing.
    pub fn frame(&self) -> Frame {
        let side = -self.start.direction;
        match self.course {
            Course::Linear(_) | Course::Series(_) => {
                Frame { side, origin: side * self.reduced.offset.hi(), shift: 0.0 }
            }
            Course::Stop(_) => {
                let shift = self.start.framed(self.reduced.offset).0.into();
                Frame { side, origin: self.start.x.into(), shift }
            }
        }
    }

    /// (y, w) in the frame of the swing, `tau` after its start.
    pub fn framed_at(&self, tau: f64) -> (f64, f64) {
        let (y, w) = self.start.framed(self.reduced.offset);
        match &self.course {
            Course::Stop(_) => self.piece_at(tau).0.state(tau),
            _ if tau == 0.0 => (y.into(), w),
            Course::Linear(chain) => chain.propagator().state(tau, y.into(), w),
            Course::Series(_) => self.piece_at(tau).0.state(tau),
        }
    }

    /// The piece that holds the time `tau` of a swing that is a series, and where it ends.
    pub fn piece_at(&self, tau: f64) -> (&Piece, f64) {
        let later = self.pieces.partition_point(|piece| piece.start <= tau);
        let end = self.pieces.get(later).map_or_else(|| self.duration(), |piece| piece.start);
        (&self.pieces[later - 1], end)
    }
}
