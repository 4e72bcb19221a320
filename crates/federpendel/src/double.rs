//! Double-double numbers: unevaluated sums of two `f64`, about 31 digits.
//!
//! The phase of a motion after a million periods needs them. Algorithms with proven bounds from
//! Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic", ACM TOMS 44 (2017). They stand here because the crate `twofloat` 0.8.4
//! divides to 1e-16 only and takes exponentials to 1e-11 only, which lost the phase.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

use crate::sampling::lanes::product_error;

/// `hi` + `lo`, with `lo` at most half an ulp of `hi`.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub(crate) struct Double {
    hi: f64,
    lo: f64,
}

/// π.
pub(crate) const PI: Double = Double { hi: std::f64::consts::PI, lo: 1.224_646_799_147_353_2e-16 };
/// ln 2.
const LN_2: Double = Double { hi: std::f64::consts::LN_2, lo: 2.319_046_813_846_299_6e-17 };

impl Double {
    pub fn hi(self) -> f64 {
        self.hi
    }

    pub fn lo(self) -> f64 {
        self.lo
    }

    /// The exact sum of two numbers.
    pub fn sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let b_part = hi - a;
        Double { hi, lo: (a - (hi - b_part)) + (b - b_part) }
    }

    /// The exact sum of two numbers, the first of which is the larger or zero.
    fn quick_sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        Double { hi, lo: b - (hi - a) }
    }

    /// The exact product of two numbers.
    pub fn product(a: f64, b: f64) -> Self {
        let hi = a * b;
        Double { hi, lo: product_error::<{ cfg!(target_feature = "fma") }>(a, b, hi) }
    }

    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// √x, x ≥ 0: one step of Newton's method from the rounded root.
    pub fn sqrt(self) -> Self {
        if self.hi == 0.0 {
            return self;
        }
        let root = self.hi.sqrt();
        let rest = self - Double::product(root, root);
        Double::quick_sum(root, rest.hi / (2.0 * root))
    }

    /// e^x for x ≤ 0; zero where it underflows.
    pub fn exp(self) -> Self {
        let power = (self.hi / LN_2.hi).round();
        if power < -1000.0 {
            return 0.0.into();
        }
        // With x = power·ln 2 + 64 r, the series of e^r needs few terms.
        let r = (self - LN_2 * power) * (1.0 / 64.0);
        let series = (1..=13).rev().fold(Double::from(1.0), |sum, n| sum * r / f64::from(n) + 1.0);
        let root = (0..6).fold(series, |root, _| root * root);
        root * 2f64.powi(power as i32)
    }
}

impl From<f64> for Double {
    fn from(hi: f64) -> Self {
        Double { hi, lo: 0.0 }
    }
}

impl From<Double> for f64 {
    fn from(number: Double) -> f64 {
        number.hi
    }
}

impl Neg for Double {
    type Output = Double;
    fn neg(self) -> Double {
        Double { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for Double {
    type Output = Double;
    fn add(self, other: Double) -> Double {
        let high = Double::sum(self.hi, other.hi);
        let low = Double::sum(self.lo, other.lo);
        let sum = Double::quick_sum(high.hi, high.lo + low.hi);
        Double::quick_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Mul for Double {
    type Output = Double;
    fn mul(self, other: Double) -> Double {
        let product = Double::product(self.hi, other.hi);
        let low = self.hi * other.lo + self.lo * other.hi;
        Double::quick_sum(product.hi, product.lo + low)
    }
}

impl Div for Double {
    type Output = Double;
    fn div(self, other: Double) -> Double {
        let first = self.hi / other.hi;
        let rest = self - other * first;
        let second = rest.hi / other.hi;
        let rest = rest - other * second;
        Double::quick_sum(first, second) + rest.hi / other.hi
    }
}

impl Sub for Double {
    type Output = Double;
    fn sub(self, other: Double) -> Double {
        self + -other
    }
}

/// The same operations with an `f64` on either side.
macro_rules! with_f64 {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait<f64> for Double {
            type Output = Double;
            fn $method(self, other: f64) -> Double {
                self.$method(Double::from(other))
            }
        }

        impl $trait<Double> for f64 {
            type Output = Double;
            fn $method(self, other: Double) -> Double {
                Double::from(self).$method(other)
            }
        }
    )*};
}

with_f64!(Add add, Sub sub, Mul mul, Div div);

impl AddAssign<f64> for Double {
    fn add_assign(&mut self, other: f64) {
        *self = *self + other;
    }
}

impl AddAssign for Double {
    fn add_assign(&mut self, other: Double) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values by mpmath at 50 digits, as unevaluated sums of two doubles.
    #[test]
    fn operations_have_thirty_digits() {
        let (a, b) = (Double::from(0.2) / 3.0, Double::product(0.1, 0.7));
        let checks = [
            (a, 0.06666666666666667, 4.625929269271485e-18),
            (b, 0.06999999999999999, 6.661338147750939e-18),
            (a + b, 0.13666666666666666, 1.1287267417022425e-17),
            (a - b, -0.003333333333333329, 1.3299546649155547e-19),
            (a * b, 0.004666666666666667, -1.6422048905913776e-19),
            (a / b, 0.9523809523809524, 2.265761274745221e-18),
            (1.0 / a, 15.0, -8.326672684688674e-16),
            (PI / b, 44.87989505128276, 2.1054003761297527e-15),
            (b.sqrt(), 0.2645751311064591, -2.4718240479332197e-17),
            ((1.0 - a) * (1.0 + a), 0.9955555555555555, 2.8125649957170635e-17),
            (Double::from(-1e-9).exp(), 0.999999999, -2.778193152587354e-17),
            ((-a).exp(), 0.9355069850316178, -4.281378438173288e-17),
            ((PI * -0.5).exp(), 0.2078795763507619, 6.4431858349907894e-18),
            ((b * -1e3).exp(), 3.975449735908649e-31, 4.2154645155769987e-47),
            ((a * -4e3).exp(), 1.5421909815891436e-116, 4.2991552854725226e-135),
        ];
        for (i, (found, hi, lo)) in checks.into_iter().enumerate() {
            let error = found - hi - lo;
            assert!((error.hi() / hi).abs() < 5e-30, "{i}: {found:?}, off by {error:?}");
        }
        assert_eq!(Double::from(-1e300).exp().hi(), 0.0);
    }
}
