//! The chain of a throw that dry friction ends in its first swing: one swing and the rest.

use crate::chain::Start;
use crate::oscillator::Reduced;
use crate::swing::NotFollowed;
use crate::swing::piece::Piece;
use crate::swing::stop::{Stop, Stopped};

/// One swing and the rest.
#[derive(Debug, Clone)]
pub(crate) struct StopChain {
    first: Start,
    rest: Start,
    pieces: Vec<Piece>,
}

/// An offset so many times the amplitude stops a throw in its first swing, and makes distances from the
/// centre of that swing inaccurate.
const LARGE_OFFSET: f64 = 2.0;

impl StopChain {
    /// The chain of a throw, if it is one that ends so.
    ///
    /// # Errors
    /// [`NotFollowed`] if the swing comes to no end.
    pub fn new(
        reduced: &Reduced,
        first: Start,
        amplitude: f64,
    ) -> Result<Option<Self>, NotFollowed> {
        if first.w == 0.0 || reduced.offset.hi() < LARGE_OFFSET * amplitude {
            return Ok(None);
        }
        let pull = (reduced.offset + first.direction * first.x).into();
        let stop = Stop { zeta: reduced.zeta.into(), kappa: reduced.kappa, pull };
        let mut pieces = Vec::new();
        let Stopped { tau, distance } = stop.solve(first.w.abs(), &mut pieces)?;
        let rest = Start {
            index: 1,
            tau: tau.into(),
            x: first.x + first.direction * distance,
            w: 0.0,
            direction: 0.0,
            error: 0.0,
        };
        Ok(Some(StopChain { first, rest, pieces }))
    }

    pub fn first(&self) -> Start {
        self.first
    }

    pub fn rest(&self) -> Start {
        self.rest
    }

    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }
}
