//! The error lens: what a method makes of a motion, beside the exact one.
//!
//! ```
//! use federpendel::lens::{self, Course};
//! use federpendel::scheme::{self, Setting};
//! use federpendel::{Coulomb, Motion, NormalForce, Oscillator, State};
//!
//! let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81))?;
//! let motion = Motion::new(Oscillator::new(0.5, 20.0, dry)?, State::new(0.1, 0.0)?)?;
//! let setting = Setting::of(&motion);
//! let rk4 = scheme::named("rk4").expect("a name of the list");
//! let errors = lens::errors(&motion, &mut Course::new(rk4, &setting)?, 5.5)?;
//! assert!(errors.largest > 1e-6); // m: reversals that are stepped over
//! let located = scheme::named("rk4-located").expect("a name of the list");
//! let errors = lens::errors(&motion, &mut Course::new(located, &setting)?, 5.5)?;
//! assert!(errors.largest < 1e-10);
//! # Ok::<(), federpendel::Error>(())
//! ```

mod candidate;
mod course;
mod ending;
mod findings;
mod gauge;
mod ladder;
mod remark;

pub use candidate::Candidate;
pub use course::{Course, MOST_STEPS};
pub use ending::{Ending, ending};
pub use findings::Findings;
pub use gauge::{Errors, Gauge, errors};
pub use ladder::{FailedRung, Ladder, Rung, ladder, order};
pub use remark::Remark;
