//! Measured values and their intervals as a person reads them: no more digits than they deserve.

use crate::catalogue::Catalogue;
use crate::language::Language;
use crate::number::{fixed, join, number, superscript};

impl Catalogue {
    /// A measured value with its standard error in the unit `unit`, both rounded to two digits of the error: `0.304 ±
    /// 0.010 m/s²`.
    pub fn measured(&self, value: f64, error: f64, unit: &str) -> String {
        let Some(rounding) = Rounding::of(value, error) else {
            return join(number(self.language(), value, 4), unit);
        };
        let fixed = |value| rounding.fixed(value, self.language());
        let both = format!("{} ± {}", fixed(value), fixed(error));
        join(rounding.with_power(both), unit)
    }

    /// An interval of a measured value, open where an end is none, rounded as [`measured`](Self::measured) rounds the value:
    /// `0.284 to 0.324 m/s²`.
    pub fn interval(
        &self,
        (low, high): (Option<f64>, Option<f64>),
        value: f64,
        error: f64,
        unit: &str,
    ) -> String {
        let rounding = Rounding::of(value, error);
        let end = |end: Option<f64>, open: &str| match (end, rounding) {
            (None, _) => open.to_owned(),
            // An end that cannot be passed is exact.
            (Some(0.0), _) => "0".to_owned(),
            (Some(end), None) => number(self.language(), end, 4),
            (Some(end), Some(rounding)) => rounding.fixed(end, self.language()),
        };
        let ends = [("low", end(low, "−∞").into()), ("high", end(high, "∞").into())];
        let both = self.format("measured-interval", &ends);
        join(rounding.map_or(both.clone(), |rounding| rounding.with_power(both)), unit)
    }
}

/// How a measured value and what belongs to it are rounded: to two digits of its error.
#[derive(Debug, Clone, Copy)]
struct Rounding {
    /// The power of ten that serves all of them, zero where none is needed.
    power: i32,
    decimals: usize,
}

impl Rounding {
    /// None where no error is known.
    fn of(value: f64, error: f64) -> Option<Self> {
        if !(error.is_finite() && error > 0.0 && value.is_finite()) {
            return None;
        }
        // The larger of both leads: its power of ten serves both where they are very large or small.
        let exponent = value.abs().max(error).log10().floor() as i32;
        let power = if (-4..6).contains(&exponent) { 0 } else { exponent };
        let digit = (error / 10f64.powi(power)).log10().floor() as i32;
        Some(Self { power, decimals: (1 - digit).max(0) as usize })
    }

    fn fixed(self, value: f64, language: Language) -> String {
        fixed(language, value / 10f64.powi(self.power), self.decimals)
    }

    fn with_power(self, numbers: String) -> String {
        match self.power {
            0 => numbers,
            power => format!("({numbers}) × 10{}", superscript(power)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measured_values_have_two_digits_of_their_error() {
        let [english, german] = Language::ALL.map(Catalogue::new);
        for (value, error, expected) in [
            (0.30412, 0.0099, "0.3041 ± 0.0099 m/s²"),
            (0.30412, 0.01, "0.304 ± 0.010 m/s²"),
            (12.3456, 2.34, "12.3 ± 2.3 m/s²"),
            (-1234.5, 56.0, "−1234 ± 56 m/s²"),
            (3.2e-7, 1.1e-8, "(3.20 ± 0.11) × 10⁻⁷ m/s²"),
            (0.5, f64::NAN, "0.5 m/s²"),
            (0.5, 0.0, "0.5 m/s²"),
        ] {
            assert_eq!(english.measured(value, error, "m/s^2"), expected);
        }
        assert_eq!(german.measured(0.30412, 0.01, "m/s^2"), "0,304 ± 0,010 m/s²");
    }

    #[test]
    fn intervals_are_rounded_as_their_value_is() {
        let [english, german] = Language::ALL.map(Catalogue::new);
        for (ends, value, error, expected) in [
            ((Some(0.2845), Some(0.3237)), 0.30412, 0.01, "0.284 to 0.324 m/s²"),
            ((Some(0.0), Some(0.0039)), 0.001, 0.0012, "0 to 0.0039 m/s²"),
            ((Some(2.98e-7), None), 3.2e-7, 1.1e-8, "(2.98 to ∞) × 10⁻⁷ m/s²"),
            ((None, Some(1.25)), 1.0, f64::NAN, "−∞ to 1.25 m/s²"),
        ] {
            assert_eq!(english.interval(ends, value, error, "m/s^2"), expected);
        }
        let ends = (Some(-0.2845), Some(0.3237));
        assert_eq!(german.interval(ends, 0.02, 0.15, "1"), "−0,28 bis 0,32");
    }
}
