//! The motion of a mass on a spring, slowed by Stokes (viscous), Coulomb (dry, it sticks) or Newton
//! (quadratic) friction, or any mix of them: swing by swing, as exactly as each mix allows.

pub mod energy;
pub mod error;
pub mod friction;
pub mod motion;
pub mod oscillator;
pub mod parameter;

pub use energy::{Heat, Ledger};
pub use error::{Error, Result};
pub use friction::{Coulomb, Friction, Mix, Newton, NormalForce, Stokes};
pub use motion::{Kind, Mode, Motion, Outcome, Rest, Sample, Ties, TurningPoint};
pub use oscillator::{Oscillator, Regime, State};
