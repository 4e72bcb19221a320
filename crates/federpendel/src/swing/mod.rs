//! One swing, the stretch between two turning points, one file per way of solving it.
//!
//! All work in the same frame: time τ = ω0 t since the start of the swing, lengths in metres,
//! velocity w = dy/dτ, and the mass moving in the negative direction about the centre of the swing,
//! which Coulomb friction has shifted: y″ + 2ζ y′ − κ y′² + y = 0 with y′ ≤ 0. Only [`stop`] measures from the
//! start of the swing instead.

pub(crate) mod collocation;
pub(crate) mod first_integral;
pub(crate) mod linear;
pub(crate) mod piece;
pub(crate) mod stiff;
pub(crate) mod stop;
pub(crate) mod taylor;

use crate::double::Double;

/// The swing could not be followed in a bounded number of steps: far outside the range of use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NotFollowed;

/// How a swing ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum End {
    /// The velocity becomes zero after the time `tau`, at `y`.
    Reversal { tau: Double, y: Double },
    /// From here on Newton friction is below rounding: the linear motion takes over.
    Linear { tau: f64, y: f64, w: f64 },
}
