//! What the double-double numbers of `twofloat` lack: an exponential of full precision. The one in
//! version 0.8.4 is good to 1e-11 only.

use twofloat::TwoFloat;
use twofloat::consts::LN_2;

/// e^x to about 1e-30, relative; zero where it underflows. For x ≤ 0.
pub(crate) fn exp(x: TwoFloat) -> TwoFloat {
    let power = (x.hi() / LN_2.hi()).round();
    if power < -1000.0 {
        return 0.0.into();
    }
    // With x = power·ln 2 + 64 r, the series of e^r needs few terms.
    let r = (x - LN_2 * power) * (1.0 / 64.0);
    let series = (1..=13).rev().fold(TwoFloat::from(1.0), |sum, n| 1.0 + sum * r / f64::from(n));
    let root = (0..6).fold(series, |root, _| root * root);
    root * 2f64.powi(power as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values to 32 digits by mpmath at 50 digits, as unevaluated sums of two doubles.
    #[test]
    fn exponentials_have_thirty_digits() {
        for (x, hi, lo) in VALUES {
            let error = exp(x.into()) - hi - lo;
            assert!((f64::from(error) / hi).abs() < 1e-29, "{x}: {error:?}");
        }
        assert_eq!(exp(TwoFloat::from(-1e300)).hi(), 0.0);
    }

    const VALUES: [(f64, f64, f64); 7] = [
        (0.0, 1.0, 0.0),
        (-1e-9, 0.999999999, -2.778193152587354e-17),
        (-0.1, 0.9048374180359595, 5.055984668733208e-17),
        (-0.6931471805599453, 0.5, 1.1595234069231498e-17),
        (-1.69274, 0.184014632514451, -3.1484092425661745e-18),
        (-10.0, 4.5399929762484854e-05, -2.637554055327531e-21),
        (-300.5, 3.1225412772322846e-131, 2.3777947889417906e-147),
    ];
}
