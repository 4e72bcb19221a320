//! The few operations on complex numbers that (25)–(28) and (36) need.

use std::ops::{Add, Mul, Sub};

/// A complex number re + i im.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Complex {
    /// The imaginary unit.
    pub const I: Complex = Complex { re: 0.0, im: 1.0 };

    /// re + i im.
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// The exponential function, by Euler's formula e^(a + ib) = e^a (cos b + i sin b).
    ///
    /// ```
    /// use federpendel::article::Complex;
    /// let minus_one = Complex::new(0.0, std::f64::consts::PI).exp();
    /// assert!((minus_one.re + 1.0).abs() < 1e-15 && minus_one.im.abs() < 1e-15);
    /// ```
    pub fn exp(self) -> Self {
        let (sin, cos) = self.im.sin_cos();
        let modulus = self.re.exp();
        Self::new(modulus * cos, modulus * sin)
    }
}

impl From<f64> for Complex {
    fn from(re: f64) -> Self {
        Self::new(re, 0.0)
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }
}
