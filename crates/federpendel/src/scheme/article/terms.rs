//! One step of the scheme, and the loop over steps, compiled for each mix by itself.

use crate::oscillator::Oscillator;
use crate::scheme::equation::Equation;

/// What a step is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terms {
    pub time_step: f64,
    pub per_step: f64,
    pub step_squared: f64,
    pub equation: Equation,
}

/// x_{i−1} and x_i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    pub previous: f64,
    pub current: f64,
}

/// `magnitude` with the sign of `velocity`, and 0 for velocity 0, the sign(0) of (57) that
/// [`f64::signum`] does not know. It compiles to two masks, without a branch or a product.
#[inline(always)]
fn signed(magnitude: f64, velocity: f64) -> f64 {
    if velocity == 0.0 { 0.0 } else { magnitude.copysign(velocity) }
}

impl Terms {
    pub fn new(oscillator: &Oscillator, time_step: f64) -> Self {
        Terms {
            time_step,
            per_step: 1.0 / time_step,
            step_squared: time_step * time_step,
            equation: Equation::new(oscillator),
        }
    }

    /// The bracket of (51), (59), (85): minus the acceleration at x with the quotient q.
    #[inline(always)]
    fn bracket<const STOKES: bool, const COULOMB: bool, const NEWTON: bool>(
        &self,
        position: f64,
        quotient: f64,
    ) -> f64 {
        let mut sum = self.equation.spring * position;
        if STOKES {
            sum += self.equation.stokes * quotient;
        }
        if COULOMB {
            sum += signed(self.equation.coulomb, quotient);
        }
        if NEWTON {
            // sign(q) q² without the sign: it is the same number.
            sum += self.equation.newton * (quotient * quotient.abs());
        }
        sum
    }

    /// The same where speed does not matter. Terms that do not act add 0, but for the square of a
    /// quotient that overflows.
    pub fn bracket_of_any_mix(&self, position: f64, quotient: f64) -> f64 {
        if self.equation.newton == 0.0 {
            self.bracket::<true, true, false>(position, quotient)
        } else {
            self.bracket::<true, true, true>(position, quotient)
        }
    }

    /// One step of (51), (59), (85).
    #[inline(always)]
    fn advance<const STOKES: bool, const COULOMB: bool, const NEWTON: bool>(
        &self,
        Pair { previous, current }: Pair,
    ) -> Pair {
        let quotient = (current - previous) * self.per_step;
        let bracket = self.bracket::<STOKES, COULOMB, NEWTON>(current, quotient);
        let next = 2.0 * current - previous - self.step_squared * bracket;
        Pair { previous: current, current: next }
    }

    /// One step for each of `slots`, which `record` is given with the new position.
    #[inline(always)]
    pub fn march<const STOKES: bool, const COULOMB: bool, const NEWTON: bool, Slot>(
        &self,
        mut pair: Pair,
        slots: impl Iterator<Item = Slot>,
        record: impl Fn(Slot, f64),
    ) -> Pair {
        for slot in slots {
            pair = self.advance::<STOKES, COULOMB, NEWTON>(pair);
            record(slot, pair.current);
        }
        pair
    }
}
