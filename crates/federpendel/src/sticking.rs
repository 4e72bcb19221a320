//! The one place that decides whether a turning point holds.

use crate::double::Double;
use crate::motion::Ties;
use crate::oscillator::Reduced;

/// The sticking band and what is known of its edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sticking {
    band: Double,
    offset: f64,
    amplitude: f64,
    ties: Ties,
}

/// Rounding of double-double numbers, in which a turning point is held against the edge, in units of that
/// of `f64`: what lies outside by no more than this lies on the edge.
const DOUBLE_ROUNDING: f64 = f64::EPSILON * 32.0;

/// What the band says of a turning point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Verdict {
    pub sticks: bool,
    /// Distance inside the edge over the offset.
    pub margin: f64,
    /// Whether rounding decides.
    pub tie: bool,
}

impl Sticking {
    pub fn new(reduced: &Reduced, amplitude: f64, ties: Ties) -> Self {
        let offset = reduced.offset.into();
        Self { band: reduced.sticking_offset, offset, amplitude, ties }
    }

    /// Whether a mass without velocity holds at distance `position` from the centre after
    /// `swings` swings; `error` bounds the arithmetic behind `position`, m.
    pub fn verdict(&self, position: Double, swings: u64, error: f64) -> Verdict {
        let band: f64 = self.band.into();
        let inside: f64 = (self.band - position.abs()).into();
        if band == 0.0 {
            return Verdict { sticks: inside >= 0.0, margin: 0.0, tie: false };
        }
        let rounding = self.rounding(swings);
        let tie = inside.abs() <= rounding + error;
        let sticks = inside >= -rounding * DOUBLE_ROUNDING || tie && self.ties == Ties::Stick;
        let unit = if self.offset > 0.0 { self.offset } else { band };
        Verdict { sticks, margin: inside / unit, tie }
    }

    /// How far the rounding of the inputs (half an ulp each) can move a turning point against the
    /// edge: x0, v0 and the rates move it by a few parts of the amplitude, and the three or four
    /// factors of the offset by so many parts of the way 2nf that it took off the amplitude.
    fn rounding(&self, swings: u64) -> f64 {
        let way = 2.0 * swings as f64 * self.offset + f64::from(self.band);
        f64::EPSILON * (3.0 * self.amplitude + 2.0 * way)
    }
}
