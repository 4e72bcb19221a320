//! What can be wrong with an input, said by name, value and what is allowed.

use crate::parameter::Range;

/// Least magnitude of a derived quantity other than zero: below, double-double numbers lose digits.
pub const SMALLEST: f64 = 1e-280;

/// Largest magnitude of a derived quantity: above, double-double products overflow.
pub const LARGEST: f64 = 1e280;

/// `value` if its magnitude is one that is computed with, or if nothing `acts` that it stands for.
pub(crate) fn derived(
    quantity: &'static str,
    of: &'static [&'static str],
    value: f64,
    acts: bool,
) -> Result<f64> {
    if !acts || (SMALLEST..=LARGEST).contains(&value.abs()) {
        Ok(value)
    } else {
        Err(Error::Derived { quantity, value, of })
    }
}

/// Why a value was refused. Every variant names the field in the words of [`crate::parameter`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A parameter outside its range, NaN or infinite.
    #[error("{name} is {value}; allowed is {range}")]
    Parameter {
        /// Name of the parameter, as in [`crate::parameter`].
        name: &'static str,
        /// The value that was refused, SI.
        value: f64,
        /// What is allowed.
        range: Range,
    },
    /// The static coefficient lies below the kinetic one.
    #[error("static is {static_}; allowed is at least kinetic, {kinetic}")]
    StaticBelowKinetic {
        /// Static coefficient that was refused.
        static_: f64,
        /// Kinetic coefficient it must reach.
        kinetic: f64,
    },
    /// Coulomb friction without a force that presses the mass on its guide.
    #[error("{name} is {value}; Coulomb friction needs a normal force above zero")]
    NoNormalForce {
        /// `gravity` or `normal_force`.
        name: &'static str,
        /// Its value, SI.
        value: f64,
    },
    /// The inputs are allowed one by one, but a quantity made of them overflows or underflows.
    #[error(
        "{quantity} = {value}, made of {}; allowed are magnitudes from {SMALLEST:e} to {LARGEST:e}",
        .of.join(", ")
    )]
    Derived {
        /// Name of the derived quantity.
        quantity: &'static str,
        /// What it came out as, SI.
        value: f64,
        /// Names of the parameters that it is made of.
        of: &'static [&'static str],
    },
    /// Newton friction so strong that a swing would take too many steps.
    #[error("newton_rate times amplitude is {value}; allowed is at most {limit}")]
    DragTooStrong {
        /// κ times the larger of |x0| and |v0|/ω0.
        value: f64,
        /// The most that is allowed.
        limit: f64,
    },
    /// More swings would have to be followed than the limit allows.
    #[error("time is {time} s; this motion can be followed up to {reached} s ({swings} swings)")]
    TooManySwings {
        /// The time asked for, s.
        time: f64,
        /// How far the motion was followed, s.
        reached: f64,
        /// Number of swings until then.
        swings: u64,
    },
    /// Two buffers that belong together differ in length.
    #[error("{name} has {found} elements; {expected} are needed")]
    Length {
        /// Name of the buffer.
        name: &'static str,
        /// Its length.
        found: usize,
        /// The length needed.
        expected: usize,
    },
    /// Numbers that must not fall do.
    #[error("{name} holds {value} after {before}; allowed is an order that does not fall")]
    Order {
        /// Name of the list.
        name: &'static str,
        /// The value that lies too low.
        value: f64,
        /// The value ahead of it.
        before: f64,
    },
    /// The article gives no formula for this mix of friction.
    #[error("the article solves no friction, Stokes or Coulomb friction alone; not {mix}")]
    NotInArticle {
        /// The mix asked for.
        mix: crate::friction::Mix,
    },
    /// The article's solution holds in another regime of Stokes friction.
    #[error("solution {solution} of the article does not hold for a {} oscillator", .regime.name())]
    NoSuchSolution {
        /// Number of the equation, or `overdamped` or `critical`.
        solution: &'static str,
        /// The regime of the oscillator.
        regime: crate::oscillator::Regime,
    },
    /// The phase of a motion that does not move.
    #[error("position and velocity are 0; a phase (article eq. 77) needs one that is not")]
    NoPhase,
    /// A numeric scheme left the finite numbers.
    #[error("dt is {time_step} s; with it the scheme diverges at {time} s, a smaller one may hold")]
    Diverged {
        /// Time step of the scheme, s.
        time_step: f64,
        /// Time of the first step that is not finite, s.
        time: f64,
    },
    /// A method with a tolerance finds no step short enough for it.
    #[error("at {time} s the step has shrunk to {step} s, where time no longer advances")]
    StepUnderflow {
        /// The time reached, s.
        time: f64,
        /// The step, s.
        step: f64,
    },
    /// A method has used up the steps allowed.
    #[error("at {time} s the {limit} steps allowed are used up")]
    StepLimit {
        /// The time reached, s.
        time: f64,
        /// Number of steps allowed.
        limit: u64,
    },
    /// A numeric scheme would need more steps than the limit allows.
    #[error(
        "time is {time} s; with dt = {time_step} s it needs {steps} steps, at most {limit} are taken"
    )]
    TooManySteps {
        /// The time asked for, s.
        time: f64,
        /// Time step of the scheme, s.
        time_step: f64,
        /// Number of steps needed.
        steps: f64,
        /// Number of steps allowed.
        limit: u64,
    },
}

/// Result of everything here that checks its input.
pub type Result<T> = std::result::Result<T, Error>;
