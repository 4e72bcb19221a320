//! The right-hand side that numeric methods are given, in three readings of dry friction.

use crate::oscillator::{Oscillator, State};

/// Round numbers often put the mass on the very edge of the band; within a few roundings it holds there.
pub const EDGE: f64 = 1.0 + 8.0 * f64::EPSILON;

/// The coefficients of m x″ = −C x − D x′ − sign(x′)(μ F_N + k x′²), each over the mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equation {
    /// C/m, 1/s².
    pub spring: f64,
    /// D/m, 1/s.
    pub stokes: f64,
    /// μ F_N/m, m/s².
    pub coulomb: f64,
    /// μ_s F_N/m, m/s²: up to here friction holds what is at rest.
    pub holding: f64,
    /// ½ρc_wA/m, 1/m.
    pub newton: f64,
}

impl Equation {
    /// The equation of `oscillator`.
    pub fn new(oscillator: &Oscillator) -> Self {
        let (mass, friction) = (oscillator.mass(), oscillator.friction());
        // Both from one number: rounded apart, a place could be outside the band and yet not left.
        let pressing = friction.coulomb.map_or(0.0, |law| law.normal_force().force(mass) / mass);
        let (kinetic, holding) =
            friction.coulomb.map_or((0.0, 0.0), |law| (law.kinetic(), law.static_coefficient()));
        Equation {
            spring: oscillator.stiffness() / mass,
            stokes: friction.stokes.map_or(0.0, |law| law.damping()) / mass,
            coulomb: kinetic * pressing,
            holding: holding * pressing,
            newton: friction.newton.map_or(0.0, |law| law.coefficient()) / mass,
        }
    }

    /// Whether the mass holds at `position`, m, once it has no velocity.
    pub fn holds(&self, position: f64) -> bool {
        self.spring * position.abs() <= self.holding * EDGE
    }

    /// The acceleration with dry friction `dry`, from −1 to 1, and quadratic drag along `drag`, −1 or 1.
    #[inline]
    fn acceleration(&self, State { position: x, velocity: v }: State, dry: f64, drag: f64) -> f64 {
        -self.spring * x - self.stokes * v - dry * self.coulomb - drag * self.newton * v * v
    }
}

/// An acceleration that depends on the state alone.
pub trait Field {
    /// x″ at `state`, m/s².
    fn acceleration(&self, state: State) -> f64;
}

/// sign(x′) as it stands in a textbook, with sign(0) = 0.
#[derive(Debug, Clone, Copy)]
pub struct Signed(pub Equation);

impl Field for Signed {
    #[inline]
    fn acceleration(&self, state: State) -> f64 {
        let sign = if state.velocity == 0.0 { 0.0 } else { state.velocity.signum() };
        self.0.acceleration(state, sign, sign)
    }
}

/// One swing: the direction of friction stays what it was, whatever the sign of the velocity.
#[derive(Debug, Clone, Copy)]
pub struct Directed(pub Equation, pub f64);

impl Field for Directed {
    #[inline]
    fn acceleration(&self, state: State) -> f64 {
        self.0.acceleration(state, self.1, self.1)
    }
}

/// Dry friction made smooth, tanh(x′/width) in place of its sign, as programs for games and robots have it.
#[derive(Debug, Clone, Copy)]
pub struct Smoothed {
    /// The equation.
    pub equation: Equation,
    /// Velocity at which friction has reached 76 % of its strength, m/s.
    pub width: f64,
}

impl Field for Smoothed {
    #[inline]
    fn acceleration(&self, state: State) -> f64 {
        let sign = state.velocity.signum();
        self.equation.acceleration(state, (state.velocity / self.width).tanh(), sign)
    }
}
