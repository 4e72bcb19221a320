//! Reference problems with their known answers, for tests, examples and benches.
//!
//! The answers do not come from this crate: they are closed forms and recurrences evaluated with
//! 40 digits, or numbers of the named source that were recomputed so.
//!
//! ```
//! use federpendel::{Motion, Outcome, problems};
//!
//! let problem = problems::coulomb_reference();
//! let motion = Motion::new(problem.oscillator, problem.release)?;
//! let known = problem.known.rest.expect("it rests");
//! let Outcome::Rests(rest) = motion.outcome() else { panic!("it swings on") };
//! assert_eq!(rest.swings, known.swings);
//! assert!((rest.position - known.position).abs() < 1e-15);
//! # Ok::<(), federpendel::Error>(())
//! ```

mod references;
mod textbook;
mod turning;

pub use references::{
    all_three_reference, coulomb_reference, newton_reference, references, stokes_reference,
};
pub use textbook::textbook;
pub use turning::turning_amplitudes;

use crate::friction::{Coulomb, Friction, Newton, NormalForce, Stokes};
use crate::oscillator::{Oscillator, State};

/// An experiment whose answer is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// What it is called; a textbook case by its number, W01 to W23.
    pub name: &'static str,
    /// Where it is from.
    pub source: &'static str,
    /// The oscillator.
    pub oscillator: Oscillator,
    /// The release.
    pub release: State,
    /// What is known of its motion.
    pub known: Known,
}

/// What is known of a motion, good to at least 1e-13 of the amplitude.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Known {
    /// Turning amplitudes: number n ≥ 1 of the turning point, |x_n| in m.
    pub amplitudes: &'static [(usize, f64)],
    /// Time of the first turning point, s.
    pub first_turn: Option<f64>,
    /// Where and when it comes to rest.
    pub rest: Option<KnownRest>,
    /// States on the way.
    pub states: &'static [KnownState],
}

/// The known end of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownRest {
    /// Number of swings until rest.
    pub swings: u64,
    /// Time, s.
    pub time: f64,
    /// Position, m.
    pub position: f64,
}

/// A known state of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownState {
    /// Time, s.
    pub time: f64,
    /// Position, m.
    pub position: f64,
    /// Velocity, m/s.
    pub velocity: f64,
}

impl Known {
    const NOTHING: Known = Known { amplitudes: &[], first_turn: None, rest: None, states: &[] };

    const fn rest(swings: u64, time: f64, position: f64) -> Known {
        Known { rest: Some(KnownRest { swings, time, position }), ..Known::NOTHING }
    }

    const fn states(states: &'static [KnownState]) -> Known {
        Known { states, ..Known::NOTHING }
    }
}

/// A state for the tables below.
const fn state(time: f64, position: f64, velocity: f64) -> KnownState {
    KnownState { time, position, velocity }
}

/// An oscillator of the tables; they hold only values that every check lets pass.
fn oscillator(mass: f64, stiffness: f64, friction: Friction) -> Oscillator {
    Oscillator::new(mass, stiffness, friction).expect("values of the table are allowed")
}

fn stokes(damping: f64) -> Stokes {
    Stokes::new(damping).expect("values of the table are allowed")
}

fn newton(coefficient: f64) -> Newton {
    Newton::new(coefficient).expect("values of the table are allowed")
}

fn coulomb(kinetic: f64, static_: f64, normal_force: NormalForce) -> Coulomb {
    Coulomb::new(kinetic, static_, normal_force).expect("values of the table are allowed")
}
