//! Coulomb friction alone: the article's section 3.2.
//!
//! The article presses the mass down by its weight, F_N = m g; here F_N is whatever
//! [`NormalForce`](crate::NormalForce) says.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Derivatives, Equation, Formula, Reading, Shape, require};
use crate::error::{Error, Result};
use crate::friction::Mix;
use crate::oscillator::{Oscillator, State};
use crate::parameter;

/// The three sides of (68), which the article prints as equal. They are three different values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecaySides {
    /// Δx/(T/2) = 2μF_N/(π√(C m)), m/s: the right one, 2μg/(πω0) for a mass pressed down by its
    /// weight.
    pub left: f64,
    /// (2μF_N/C)/(2π√(m/C)), m/s: it divides by T in place of T/2, so it is half of the right one.
    pub middle: f64,
    /// (2μF_N/π)√(C/m), in N/s: wrong by the factor C, and in dimension. (69) and (79) use it as
    /// if it were in m/s.
    pub right: f64,
}

impl DecaySides {
    /// v_A by this reading of (68) where it is written out, as in (69) and (79): the right side in
    /// print, the left side corrected.
    fn written_out(&self, reading: Reading) -> f64 {
        match reading {
            Reading::Printed => self.right,
            Reading::Corrected => self.left,
        }
    }
}

/// (67): loss of amplitude per swing Δx = 2μF_N/C, m. For a motion released from rest it is exact.
///
/// # Errors
/// [`Error::NotInArticle`] for any mix but Coulomb friction alone.
pub fn eq_67(oscillator: &Oscillator) -> Result<f64> {
    require_coulomb(oscillator)?;
    Ok(2.0 * oscillator.offset())
}

/// (68): the velocity v_A at which the amplitude falls, all three sides as printed.
///
/// ```
/// use federpendel::article::eq_68;
/// use federpendel::{Coulomb, NormalForce, Oscillator};
///
/// let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81))?;
/// let sides = eq_68(&Oscillator::new(0.5, 20.0, dry)?)?;
/// assert!((sides.left - 0.019749).abs() < 1e-6);
/// assert!((sides.middle - 0.009875).abs() < 1e-6);
/// assert!((sides.right - 0.39498).abs() < 1e-5);
/// # Ok::<(), federpendel::Error>(())
/// ```
///
/// # Errors
/// As [`eq_67`].
pub fn eq_68(oscillator: &Oscillator) -> Result<DecaySides> {
    let loss = eq_67(oscillator)?;
    let (mass, stiffness) = (oscillator.mass(), oscillator.stiffness());
    let half_period = PI / oscillator.angular_frequency();
    Ok(DecaySides {
        left: loss / half_period,
        middle: loss / (2.0 * PI * (mass / stiffness).sqrt()),
        right: 2.0 * friction_force(oscillator) / PI * (stiffness / mass).sqrt(),
    })
}

/// (61): x = (x0 − v_A t) cos(ω0 t), m, released at rest at `position` x0 (m), with v_A the left
/// side of (68).
///
/// In print the amplitude *grows* for x0 < 0; corrected it is sign(x0)(|x0| − v_A t) cos(ω0 t).
/// Either way it is no solution of (57): it starts with x′(0) = −v_A instead of 0, meets the motion
/// only at the turning points, and never rests.
///
/// # Errors
/// [`Error::NotInArticle`] for any mix but Coulomb friction alone, [`Error::Parameter`] for a
/// position that is not finite.
pub fn eq_61(oscillator: &Oscillator, position: f64, reading: Reading) -> Result<Formula> {
    let decay = eq_68(oscillator)?.left;
    let shape = LinearDecay::from_rest(oscillator, position, decay, reading)?;
    Ok(Formula { equation: Equation::Eq61, shape: Shape::LinearDecay(shape) })
}

/// (69): (61) with v_A written out, x = (x0 − (2μF_N/π) ω0 t) cos(ω0 t), m.
///
/// In print this is the right side of (68), too large by the factor C in N/m; corrected it is the
/// left side, and so the same as (61).
///
/// # Errors
/// As [`eq_61`].
pub fn eq_69(oscillator: &Oscillator, position: f64, reading: Reading) -> Result<Formula> {
    let decay = eq_68(oscillator)?.written_out(reading);
    let shape = LinearDecay::from_rest(oscillator, position, decay, reading)?;
    Ok(Formula { equation: Equation::Eq69, shape: Shape::LinearDecay(shape) })
}

/// (76): amplitude A = √(x0² + (v0/ω0)²) of the motion without friction from this release, m.
///
/// # Errors
/// [`Error::NotInArticle`] with Stokes or Newton friction, [`Error::Parameter`] for a release that
/// is not finite.
pub fn eq_76(oscillator: &Oscillator, release: State) -> Result<f64> {
    require(oscillator, |mix| mix == Mix { coulomb: mix.coulomb, ..Mix::default() })?;
    let State { position, velocity } = State::new(release.position, release.velocity)?;
    Ok(position.hypot(velocity / oscillator.angular_frequency()))
}

/// (77): phase φ in A sin(ω0 t + φ), rad.
///
/// In print φ = arctan(x0ω0/v0), which loses the quadrant: for v0 < 0 the motion starts mirrored.
/// For v0 = 0 it is the limit ±π/2 with the sign of x0. Corrected: φ = atan2(x0ω0, v0).
///
/// # Errors
/// As [`eq_76`], and [`Error::NoPhase`] at x0 = v0 = 0, where the quotient is 0/0 and no phase is
/// right.
pub fn eq_77(oscillator: &Oscillator, release: State, reading: Reading) -> Result<f64> {
    let amplitude = eq_76(oscillator, release)?;
    if amplitude == 0.0 {
        return Err(Error::NoPhase);
    }
    let (opposite, adjacent) =
        (release.position * oscillator.angular_frequency(), release.velocity);
    Ok(match reading {
        Reading::Printed if adjacent == 0.0 => FRAC_PI_2.copysign(opposite),
        Reading::Printed => (opposite / adjacent).atan(),
        Reading::Corrected => opposite.atan2(adjacent),
    })
}

/// (78): x = (A − v_A t) sin(ω0 t + φ), m, with A of (76), v_A the left side of (68) and φ of (77)
/// by the same reading.
///
/// For v0 ≠ 0 not even the turning points are met.
///
/// # Errors
/// [`Error::NotInArticle`] for any mix but Coulomb friction alone, [`Error::Parameter`] for a
/// release that is not finite, [`Error::NoPhase`] at x0 = v0 = 0.
pub fn eq_78(oscillator: &Oscillator, release: State, reading: Reading) -> Result<Formula> {
    let decay = eq_68(oscillator)?.left;
    let shape = LinearDecay::with_phase(oscillator, release, decay, reading)?;
    Ok(Formula { equation: Equation::Eq78, shape: Shape::LinearDecay(shape) })
}

/// (79): (78) with everything written out, m; in print with the right side of (68), corrected the
/// same as (78).
///
/// # Errors
/// As [`eq_78`].
pub fn eq_79(oscillator: &Oscillator, release: State, reading: Reading) -> Result<Formula> {
    let decay = eq_68(oscillator)?.written_out(reading);
    let shape = LinearDecay::with_phase(oscillator, release, decay, reading)?;
    Ok(Formula { equation: Equation::Eq79, shape: Shape::LinearDecay(shape) })
}

fn require_coulomb(oscillator: &Oscillator) -> Result<()> {
    require(oscillator, |mix| mix == Mix { coulomb: true, ..Mix::default() })
}

/// μ F_N of (55), N.
fn friction_force(oscillator: &Oscillator) -> f64 {
    let law = oscillator.friction().coulomb;
    law.map_or(0.0, |law| law.kinetic() * law.normal_force().force(oscillator.mass()))
}

/// x = (A − v_A t) sin(ω0 t + φ).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LinearDecay {
    amplitude: f64,
    decay: f64,
    omega0: f64,
    /// sin φ and cos φ, so that a phase of ±π/2 is exact.
    phase: (f64, f64),
}

impl LinearDecay {
    fn from_rest(
        oscillator: &Oscillator,
        position: f64,
        decay: f64,
        reading: Reading,
    ) -> Result<Self> {
        let position = parameter::POSITION.check(position)?;
        let (amplitude, sign) = match reading {
            Reading::Corrected if position < 0.0 => (-position, -1.0),
            Reading::Corrected | Reading::Printed => (position, 1.0),
        };
        let omega0 = oscillator.angular_frequency();
        Ok(Self { amplitude, decay, omega0, phase: (sign, 0.0) })
    }

    fn with_phase(
        oscillator: &Oscillator,
        release: State,
        decay: f64,
        reading: Reading,
    ) -> Result<Self> {
        let amplitude = eq_76(oscillator, release)?;
        let phase = eq_77(oscillator, release, reading)?.sin_cos();
        Ok(Self { amplitude, decay, omega0: oscillator.angular_frequency(), phase })
    }

    pub(super) fn at(&self, time: f64) -> Derivatives {
        let (sin_phase, cos_phase) = self.phase;
        let (sin_time, cos_time) = (self.omega0 * time).sin_cos();
        let sin = sin_time * cos_phase + cos_time * sin_phase;
        let cos = cos_time * cos_phase - sin_time * sin_phase;
        let amplitude = self.amplitude - self.decay * time;
        let swing = amplitude * self.omega0;
        Derivatives {
            position: amplitude * sin,
            velocity: swing * cos - self.decay * sin,
            acceleration: -self.omega0 * (2.0 * self.decay * cos + swing * sin),
        }
    }

    pub(super) fn amplitude_end(&self) -> Option<f64> {
        (self.decay > 0.0).then(|| (self.amplitude / self.decay).max(0.0))
    }
}
