//! Newton friction without Stokes friction: a first integral of the swing.
//!
//! Moving from rest at y = a > 0 towards the centre, with u = κy,
//! (κ y′/ω0)² = u + ½ − (u_a + ½) e^(−2(u_a − u)): a linear equation for the square of the velocity as
//! a function of the place. So the velocity is exact at every place and the next turning point
//! needs only Lambert's W; no elementary function gives x(t).

use lambert_w::lambert_w0;

use crate::error::{Error, Result};
use crate::parameter::Range;

/// The turning amplitude b that follows a swing from rest at distance `amplitude` a ≥ 0 (m) from
/// the centre of the swing, with Newton rate `kappa` κ > 0 (1/m) and no Stokes friction.
///
/// b solves ln(1 − 2κb) + 2κb = ln(1 + 2κa) − 2κa, that is
/// b = (1 + W₀(−(1 + 2κa) e^(−(1 + 2κa))))/(2κ); always b < 1/(2κ).
///
/// ```
/// let b = federpendel::first_integral::next_amplitude(0.1, 1.0)?;
/// assert!((b - 0.8821899862473064).abs() < 1e-15);
/// # Ok::<(), federpendel::Error>(())
/// ```
///
/// # Errors
/// [`Error::Parameter`] unless κ > 0 and a ≥ 0, both finite.
pub fn next_amplitude(kappa: f64, amplitude: f64) -> Result<f64> {
    check(kappa, amplitude)?;
    let a = kappa * amplitude;
    // Next to its branch point W loses half the digits, so it serves as a start only; where the
    // drag is weak even that fails, and b/a = 1 − 4κa/3 + O((κa)²) is the better one.
    let mut b = if a < 1e-3 {
        a / (1.0 + 4.0 / 3.0 * a)
    } else {
        let w = 1.0 + 2.0 * a;
        0.5 * (1.0 + lambert_w0(-w * (-w).exp()))
    };
    let target = log1p_minus(2.0 * a);
    for _ in 0..3 {
        if b > 0.0 && b < 0.5 {
            // Newton's method on the logarithmic form, whose slope is −4b/(1 − 2b).
            b += (log1p_minus(-2.0 * b) - target) * (1.0 - 2.0 * b) / (4.0 * b);
        }
    }
    Ok(b / kappa)
}

/// Speed |v|/ω0 (m) at the place `y` (m) of a swing from rest at distance `amplitude` from its centre;
/// `None` where the swing does not reach.
///
/// ```
/// use federpendel::first_integral::{next_amplitude, speed};
/// let b = next_amplitude(0.1, 1.0)?;
/// assert!(speed(0.1, 1.0, -b)?.unwrap_or(0.0) < 1e-7);
/// assert_eq!(speed(0.1, 1.0, 1.5)?, None);
/// # Ok::<(), federpendel::Error>(())
/// ```
///
/// # Errors
/// [`Error::Parameter`] unless κ > 0 and a ≥ 0, both finite.
pub fn speed(kappa: f64, amplitude: f64, y: f64) -> Result<Option<f64>> {
    check(kappa, amplitude)?;
    // With d = κ(a − y): κ²w² = 2κa d − (κa + ½)(e^(−2d) − 1 + 2d), where the bracket is of second order.
    let d = kappa * (amplitude - y);
    let a = kappa * amplitude;
    let square = 2.0 * a * d - (a + 0.5) * expm1_minus(-2.0 * d);
    Ok((d >= 0.0 && square >= 0.0).then(|| square.sqrt() / kappa))
}

fn check(kappa: f64, amplitude: f64) -> Result<()> {
    for (name, value, range) in
        [("kappa", kappa, Range::Positive), ("amplitude", amplitude, Range::NonNegative)]
    {
        if !range.contains(value) {
            return Err(Error::Parameter { name, value, range });
        }
    }
    Ok(())
}

/// e^x − 1 − x without cancellation.
fn expm1_minus(x: f64) -> f64 {
    if x.abs() > 0.5 {
        return x.exp_m1() - x;
    }
    (3..18).rev().fold(1.0, |sum, n| 1.0 + sum * x / f64::from(n)) * 0.5 * x * x
}

/// ln(1 + x) − x without cancellation.
fn log1p_minus(x: f64) -> f64 {
    if x.abs() > 0.5 {
        return x.ln_1p() - x;
    }
    // With s = x/(2 + x): ln(1 + x) = 2 artanh s, and x = 2s/(1 − s), so that the difference is
    // 2(s³/3 + s⁵/5 + …) − s x.
    let s = x / (2.0 + x);
    let square = s * s;
    let tail = (1..18).rev().fold(0.0, |sum, k| (sum + 1.0 / (2 * k + 1) as f64) * square);
    s * (2.0 * tail - x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Amplitudes found at 50 digits by another program; ω0 = 1, |x0| = 1.
    #[test]
    fn amplitudes_fall_as_published() {
        let chain = |kappa, count| (0..count).fold(1.0, |a, _| next_amplitude(kappa, a).unwrap());
        for (kappa, count, published) in [
            (0.1, 1, 0.8821899862473064),
            (0.1, 2, 0.789240320289402),
            (0.1, 3, 0.7140265200811302),
            (0.1, 6, 0.5553117408462527),
            (1.0, 1, 0.4107196860610394),
            (1.0, 3, 0.1945658418739881),
            (1.0, 6, 0.1092323127910894),
        ] {
            assert!((chain(kappa, count) - published).abs() < 1e-15, "{kappa} {count}");
        }
    }

    #[test]
    fn any_strength_of_drag_is_held() {
        for exponent in -300..=6 {
            let a = 10f64.powi(exponent);
            let b = next_amplitude(1.0, a).unwrap();
            assert!(b > 0.0 && b <= a && b <= 0.5, "{a} {b}");
            if a < 1e-5 {
                // Expansion of the defining equation.
                let series = a - 4.0 / 3.0 * a * a + 16.0 / 9.0 * a * a * a;
                assert!((b / series - 1.0).abs() < 3e-15, "{a} {b}");
            }
        }
    }
}
