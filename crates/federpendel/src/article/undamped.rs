//! No friction: the article's section 1, in real and in complex form.

use super::stokes::Underdamped;
use super::{Complex, Equation, Formula, Reading, Shape, require};
use crate::error::Result;
use crate::friction::Mix;
use crate::oscillator::{Oscillator, State};

/// (16), also (8) and (80): the angular frequency ω0 = √(C/m), 1/s.
///
/// (8) and (16) print ±; the positive root is meant everywhere.
pub fn eq_16(oscillator: &Oscillator) -> f64 {
    oscillator.angular_frequency()
}

/// (70): ω0 = √(C/m) beside the solution (69), 1/s; the C is a c in (61), a slip of the pen.
pub fn eq_70(oscillator: &Oscillator) -> f64 {
    eq_16(oscillator)
}

/// (20), also (71): x = x0 cos(ω0 t) + (v0/ω0) sin(ω0 t), m.
///
/// # Errors
/// [`Error::NotInArticle`](crate::Error::NotInArticle) with any friction,
/// [`Error::Parameter`](crate::Error::Parameter) for a release that is not finite.
pub fn eq_20(oscillator: &Oscillator, release: State) -> Result<Formula> {
    require(oscillator, |mix| mix == Mix::default())?;
    let shape = Underdamped::new(oscillator, release)?;
    Ok(Formula { equation: Equation::Eq20, shape: Shape::Underdamped(shape) })
}

/// The solution (25) by two complex exponentials, with constants that fit the release, and its
/// rewritings (26) to (28).
///
/// The article leaves the constants open. x(0) = x0 and x′(0) = v0 give
/// C̃1 = (x0 − i v0/ω0)/2 and C̃2 its conjugate, so that x is real.
///
/// ```
/// use federpendel::article::{ComplexForm, Reading};
/// use federpendel::{Friction, Oscillator, State};
///
/// let form = ComplexForm::new(&Oscillator::new(0.5, 2.0, Friction::NONE)?, State::new(1.0, 3.0)?)?;
/// assert_eq!(form.eq_28_constants(Reading::Corrected)[1].re, 1.5); // v0/ω0, as in (19)
/// assert_eq!(form.eq_28_constants(Reading::Printed)[1].im, -1.5); // imaginary: the i is lost
/// # Ok::<(), federpendel::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplexForm {
    /// C̃1 and C̃2 of (25), m.
    pub constants: [Complex; 2],
    omega0: f64,
}

impl ComplexForm {
    /// The constants for this release.
    ///
    /// # Errors
    /// As [`eq_20`].
    pub fn new(oscillator: &Oscillator, release: State) -> Result<Self> {
        require(oscillator, |mix| mix == Mix::default())?;
        let State { position, velocity } = State::new(release.position, release.velocity)?;
        let omega0 = eq_16(oscillator);
        let first = Complex::new(0.5 * position, -0.5 * velocity / omega0);
        let second = Complex::new(first.re, -first.im);
        Ok(Self { constants: [first, second], omega0 })
    }

    /// (25): x = C̃1 e^(iω0t) + C̃2 e^(−iω0t), m.
    pub fn eq_25(&self, time: f64) -> Complex {
        let [first, second] = self.constants;
        let phase = Complex::new(0.0, self.omega0 * time);
        first * phase.exp() + second * (Complex::from(0.0) - phase).exp()
    }

    /// (26): the exponentials by Euler's formula, m.
    pub fn eq_26(&self, time: f64) -> Complex {
        let [first, second] = self.constants;
        let phase = self.omega0 * time;
        let euler = |angle: f64| Complex::new(angle.cos(), angle.sin());
        first * euler(phase) + second * euler(-phase)
    }

    /// (27): x = (C̃1 + C̃2) cos(ω0t) + i (C̃1 − C̃2) sin(ω0t), m. This line is right; only its
    /// brace is not, see [`ComplexForm::eq_28_constants`].
    pub fn eq_27(&self, time: f64) -> Complex {
        let [first, second] = self.constants;
        let (sin, cos) = (self.omega0 * time).sin_cos();
        (first + second) * cos.into() + Complex::I * (first - second) * sin.into()
    }

    /// C1 and C2 of (28), m, named by the braces under (27).
    ///
    /// In print the second brace spans C̃1 − C̃2 only, so (28) loses the i in front and x comes out
    /// complex. Corrected: C2 = i (C̃1 − C̃2), which is real because C̃2 is the conjugate of C̃1.
    pub fn eq_28_constants(&self, reading: Reading) -> [Complex; 2] {
        let [first, second] = self.constants;
        let difference = first - second;
        match reading {
            Reading::Printed => [first + second, difference],
            Reading::Corrected => [first + second, Complex::I * difference],
        }
    }

    /// (28): x = C1 cos(ω0t) + C2 sin(ω0t), m; as printed its imaginary part is not zero.
    pub fn eq_28(&self, time: f64, reading: Reading) -> Complex {
        let [first, second] = self.eq_28_constants(reading);
        let (sin, cos) = (self.omega0 * time).sin_cos();
        first * cos.into() + second * sin.into()
    }
}
