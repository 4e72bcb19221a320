//! How a motion ends: at rest, creeping, swinging for ever.

use crate::chain::linear::{self, Last, LinearChain};
use crate::chain::{Chain, Start};
use crate::motion::Motion;
use crate::oscillator::Regime;

/// Where and when the mass comes to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// Time, s; zero if it is released at rest.
    pub time: f64,
    /// Position, m.
    pub position: f64,
    /// Number of swings until then; the first one may be a partial one.
    pub swings: u64,
    /// Distance of the place inside the edge of the sticking band, over the offset (over the half
    /// width of the band where the kinetic coefficient is zero); negative if only [`Ties::Stick`](crate::Ties::Stick)
    /// made it stick, zero without Coulomb friction.
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
    /// The mass swings for ever with one amplitude: nothing slows it.
    Swings,
    /// The mass swings for ever with falling amplitude.
    Decays,
    /// Nothing is known after the time at which the search for a rest was given up.
    Unknown {
        /// Time of the last turning point followed, s.
        after: f64,
        /// Number of swings until then.
        swings: u64,
    },
}

impl Motion {
    /// How the motion ends. With Newton friction this follows up to 1e7 swings, or as many as
    /// [`Motion::with_most_swings`] says, once.
    pub fn outcome(&self) -> Outcome {
        *self.outcome.get_or_init(|| self.find_outcome())
    }

    fn find_outcome(&self) -> Outcome {
        let sticks = self.oscillator().sticking_offset() > 0.0;
        let mut cursor = self.cursor(false);
        loop {
            if cursor.start().rests() {
                return Outcome::Rests(self.rest(cursor.start()));
            }
            if let Some(chain) = cursor.linear() {
                return self.linear_outcome(chain);
            }
            let endless = matches!(self.chain(), Chain::Series(chain) if chain.swings_on());
            if endless && !sticks {
                return Outcome::Decays;
            }
            if cursor.is_given_up() || !cursor.advance() {
                return self.unknown(cursor.start());
            }
        }
    }

    fn linear_outcome(&self, chain: &LinearChain) -> Outcome {
        match chain.last() {
            Last::At(index) => Outcome::Rests(self.rest(&chain.start(index))),
            Last::Beyond => self.unknown(&chain.start(linear::MOST_SWINGS)),
            // As the label says: what is critical up to rounding creeps.
            Last::Never if self.oscillator().period().is_some() => {
                let undamped = self.oscillator().regime() == Regime::Undamped;
                if undamped { Outcome::Swings } else { Outcome::Decays }
            }
            Last::Never if chain.propagator().frequency().is_some() => {
                Outcome::Creeps { limit: 0.0 }
            }
            Last::Never => {
                let mut start = chain.first();
                while let Some(next) = chain.next(&start) {
                    start = next;
                }
                Outcome::Creeps { limit: -start.direction * self.oscillator().offset() }
            }
        }
    }

    fn unknown(&self, start: &Start) -> Outcome {
        Outcome::Unknown { after: start.time(self.oscillator().reduced()), swings: start.index }
    }

    fn rest(&self, start: &Start) -> Rest {
        let verdict = self.sticking.verdict(start.x, start.index, start.error);
        Rest {
            time: start.time(self.oscillator().reduced()),
            position: start.x.into(),
            swings: start.index,
            margin: verdict.margin,
            tie: verdict.tie,
        }
    }
}
