//! Numbers and quantities as a person reads them.

use crate::catalogue::Catalogue;
use crate::language::Language;

/// Units in which a quantity is shown, each with its size in the SI unit, largest first. A quantity
/// takes the first one of which it has at least one; units not listed are shown as they are.
const SCALES: &[(&str, &[(&str, f64)])] = &[
    ("m", &[("km", 1e3), ("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("µm", 1e-6), ("nm", 1e-9)]),
    ("s", &[("s", 1.0), ("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)]),
    ("kg", &[("kg", 1.0), ("g", 1e-3), ("mg", 1e-6), ("µg", 1e-9)]),
    ("m/s", &[("km/s", 1e3), ("m/s", 1.0), ("cm/s", 1e-2), ("mm/s", 1e-3), ("µm/s", 1e-6)]),
    ("J", &[("kJ", 1e3), ("J", 1.0), ("mJ", 1e-3), ("µJ", 1e-6), ("nJ", 1e-9)]),
    ("N", &[("MN", 1e6), ("kN", 1e3), ("N", 1.0), ("mN", 1e-3), ("µN", 1e-6)]),
    ("Hz", &[("MHz", 1e6), ("kHz", 1e3), ("Hz", 1.0), ("mHz", 1e-3), ("µHz", 1e-6)]),
];

/// Of this many of its largest unit a quantity reads better as a power of ten of the SI unit.
const LARGEST: f64 = 1e3;

impl Catalogue {
    /// `value` rounded to `digits` significant digits, without zeros at the end; very large and very
    /// small ones as a power of ten: `0.1234`, `1.5 × 10⁻⁷`.
    pub fn number(&self, value: f64, digits: usize) -> String {
        number(self.language(), value, digits)
    }

    /// `value` in the SI unit `unit`, rounded to `digits` significant digits, in a unit in which it
    /// reads well: `1.9 mm`, `4.967 s`. A pure number has the unit `1`.
    pub fn quantity(&self, value: f64, unit: &str, digits: usize) -> String {
        // Rounded first, so that 0.99996 m is not shown as 100 cm.
        let rounded = round(value, digits);
        let (unit, size) = match readable_unit(rounded.abs(), unit) {
            (_, size) if size > 1.0 && rounded.abs() >= LARGEST * size => (unit, 1.0),
            readable => readable,
        };
        join(number(self.language(), value / size, digits), unit)
    }

    /// `value` with so many decimals, zeros at the end included.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        fixed(self.language(), value, decimals)
    }

    /// `value` with all its digits (the shortest that give back the same number) and the SI unit:
    /// what was given, in a message that refuses it.
    pub fn exact_quantity(&self, value: f64, unit: &str) -> String {
        let magnitude = value.abs();
        let text = if value.is_nan() {
            return "NaN".to_owned();
        } else if value.is_infinite() {
            return if value > 0.0 { "∞" } else { "-∞" }.to_owned();
        } else if magnitude == 0.0 || (1e-5..1e15).contains(&magnitude) {
            format!("{value}")
        } else {
            format!("{value:e}")
        };
        join(localise(self.language(), text), unit)
    }
}

/// As [`readable_unit`] for the numbers along an axis, on which long times are in minutes, hours or
/// days.
pub(crate) fn axis_unit(magnitude: f64, unit: &str) -> (&str, f64) {
    match unit {
        "s" if magnitude >= 3.0 * 86400.0 => ("d", 86400.0),
        "s" if magnitude >= 3.0 * 3600.0 => ("h", 3600.0),
        "s" if magnitude >= 600.0 => ("min", 60.0),
        _ => readable_unit(magnitude, unit),
    }
}

/// The unit, and its size in SI, in which a quantity of `magnitude` in the SI unit `unit` reads well.
pub(crate) fn readable_unit(magnitude: f64, unit: &str) -> (&str, f64) {
    let scale = SCALES.iter().find(|(name, _)| *name == unit).map(|(_, scale)| *scale);
    let Some(scale) = scale.filter(|_| magnitude > 0.0 && magnitude.is_finite()) else {
        return (unit, 1.0);
    };
    let fits = scale.iter().find(|(_, size)| magnitude >= *size * (1.0 - 1e-12));
    // A thousandth of the smallest unit still reads well in it; below, a power of ten of the SI unit.
    let least = scale.last().filter(|(_, size)| magnitude >= *size * 1e-3);
    *fits.or(least).unwrap_or(&(unit, 1.0))
}

/// A unit as it is printed: `m/s^2` as `m/s²`, the pure number's `1` as nothing.
pub(crate) fn typeset_unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { unit.replace("^2", "²").replace("^3", "³") }
}

/// `value` rounded to `digits` significant digits, as a person reads it in `language`.
pub(crate) fn number(language: Language, value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "NaN".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_owned();
    }
    let scientific = format!("{:.*e}", digits.max(1) - 1, value);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if value == 0.0 {
        "0".to_owned()
    } else if (-4..6).contains(&exponent) {
        let decimals = (digits.max(1) as i32 - 1 - exponent).max(0) as usize;
        trim(&format!("{:.*}", decimals, round(value, digits))).to_owned()
    } else {
        format!("{} × 10{}", trim(mantissa), superscript(exponent))
    };
    localise(language, text).replace('-', "−")
}

/// `value` rounded to `digits` significant digits.
fn round(value: f64, digits: usize) -> f64 {
    format!("{:.*e}", digits.max(1) - 1, value).parse().unwrap_or(value)
}

pub(crate) fn fixed(language: Language, value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    // What is rounded to zero has no sign.
    let nothing = text.bytes().all(|sign| !sign.is_ascii_digit() || sign == b'0');
    let text = if nothing { text.trim_start_matches('-').to_owned() } else { text };
    localise(language, text).replace('-', "−")
}

/// A decimal number without the zeros at its end.
fn trim(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

pub(crate) fn localise(language: Language, number: String) -> String {
    number.replace('.', &language.decimal_sign().to_string())
}

pub(crate) fn join(number: String, unit: &str) -> String {
    let unit = typeset_unit(unit);
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

/// An exponent in raised digits.
pub(crate) fn superscript(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    exponent
        .to_string()
        .chars()
        .map(|sign| sign.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_fixed_and_nothing_has_no_sign() {
        let german = Catalogue::new(Language::German);
        for (value, expected) in
            [(-0.8, "−0,80"), (-0.004, "0,00"), (12.345, "12,35"), (0.0, "0,00")]
        {
            assert_eq!(german.fixed(value, 2), expected);
        }
    }

    #[test]
    fn numbers_are_rounded_and_trimmed() {
        for (value, digits, english) in [
            (0.0, 4, "0"),
            (1.9, 4, "1.9"),
            (4.96729413, 4, "4.967"),
            (100.0, 3, "100"),
            (1234567.0, 4, "1.235 × 10⁶"),
            (123456.0, 4, "123500"),
            (-0.05, 4, "−0.05"),
            (1.5e-7, 4, "1.5 × 10⁻⁷"),
            (f64::INFINITY, 4, "∞"),
            (f64::NAN, 4, "NaN"),
        ] {
            assert_eq!(number(Language::English, value, digits), english);
            assert_eq!(number(Language::German, value, digits), english.replace('.', ","));
        }
    }

    #[test]
    fn quantities_take_a_unit_that_reads_well() {
        let english = Catalogue::new(Language::English);
        for (value, unit, text) in [
            (0.0019, "m", "1.9 mm"),
            (0.1, "m", "10 cm"),
            (0.999999, "m", "1 m"),
            (-0.0019, "m", "−1.9 mm"),
            (4.96729413, "s", "4.967 s"),
            (9.81, "m/s^2", "9.81 m/s²"),
            (0.02, "1", "0.02"),
            (0.0, "m", "0 m"),
            (0.5, "kg", "500 g"),
            (1e-12, "m", "1 × 10⁻¹² m"),
            (4.7e-16, "m", "4.7 × 10⁻¹⁶ m"),
            (5e6, "s", "5 × 10⁶ s"),
            (5e3, "J", "5 kJ"),
            (2e6, "J", "2 × 10⁶ J"),
            (1e18, "J", "1 × 10¹⁸ J"),
        ] {
            assert_eq!(english.quantity(value, unit, 4), text);
        }
        assert_eq!(Catalogue::new(Language::German).quantity(0.0019, "m", 4), "1,9 mm");
    }

    #[test]
    fn exact_quantities_keep_what_was_given() {
        let german = Catalogue::new(Language::German);
        assert_eq!(german.exact_quantity(-0.1, "kg"), "-0,1 kg");
        assert_eq!(german.exact_quantity(-1e300, "kg"), "-1e300 kg");
        assert_eq!(german.exact_quantity(f64::NEG_INFINITY, "kg"), "-∞");
        assert_eq!(german.exact_quantity(f64::NAN, "kg"), "NaN");
    }
}
