//! Decimal numbers kept as written, so that a change of unit costs no rounding of its own.

use num_bigint::BigUint;

use super::Error;

/// Exponents are cut off here: far beyond any `f64`, far below any overflow of `i64`.
const EXPONENT_LIMIT: i64 = 1_000_000;

/// Decimal digits of a quotient that are kept. A number halfway between two `f64` has at most 767
/// significant digits, so with these and a mark for the remainder the rounding is right.
const QUOTIENT_DIGITS: u32 = 800;

/// An exact ratio times a power of ten.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Scale {
    pub(super) numerator: BigUint,
    pub(super) denominator: BigUint,
    pub(super) exponent: i64,
}

impl Scale {
    pub(super) fn one() -> Self {
        Self { numerator: 1u8.into(), denominator: 1u8.into(), exponent: 0 }
    }

    /// Multiplies by (`mantissa`·10^`exponent`)^`power`.
    pub(super) fn multiply(&mut self, mantissa: u64, exponent: i32, power: i32) {
        let factor = BigUint::from(mantissa).pow(power.unsigned_abs());
        if power >= 0 {
            self.numerator *= factor;
        } else {
            self.denominator *= factor;
        }
        self.exponent += i64::from(exponent) * i64::from(power);
    }
}

/// ± magnitude·10^exponent, exactly.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Decimal {
    negative: bool,
    scale: Scale,
}

impl Decimal {
    /// Reads the number at the beginning of `text`; returns it and what follows.
    pub(super) fn read(text: &str) -> Result<(Self, &str), Error> {
        if text.is_empty() {
            return Err(Error::Empty);
        }
        let (negative, unsigned) = sign(text);
        if names_no_finite_number(unsigned) {
            return Err(Error::NotFinite);
        }
        let end = unsigned
            .find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ','))
            .unwrap_or(unsigned.len());
        let (mantissa, rest) = unsigned.split_at(end);
        let (whole, fraction) = separate(mantissa)?;
        let (exponent, rest) = exponent(rest);
        let digits = format!("{whole}{fraction}");
        let numerator = BigUint::parse_bytes(digits.as_bytes(), 10).ok_or(Error::NoNumber)?;
        let exponent = exponent - fraction.len() as i64;
        let scale = Scale { numerator, denominator: 1u8.into(), exponent };
        Ok((Self { negative, scale }, rest))
    }

    /// The number in other units, exactly.
    pub(super) fn times(mut self, factor: &Scale) -> Self {
        self.scale.numerator *= &factor.numerator;
        self.scale.denominator *= &factor.denominator;
        self.scale.exponent += factor.exponent;
        self
    }

    /// The nearest `f64`.
    pub(super) fn to_f64(&self) -> Result<f64, Error> {
        let Scale { numerator, denominator, exponent } = &self.scale;
        let zero = BigUint::ZERO;
        let text = if *denominator == BigUint::from(1u8) {
            format!("{numerator}e{exponent}")
        } else {
            let shifted = numerator * BigUint::from(10u8).pow(QUOTIENT_DIGITS);
            let quotient = &shifted / denominator;
            let remains = shifted - &quotient * denominator != zero;
            // One more digit stands for the remainder: it says on which side of a tie we are.
            let mark = u8::from(remains);
            format!("{quotient}{mark}e{}", exponent - i64::from(QUOTIENT_DIGITS) - 1)
        };
        // The standard library rounds decimal text of any length correctly.
        let magnitude: f64 = text.parse().map_err(|_| Error::NoNumber)?;
        if magnitude.is_infinite() {
            Err(Error::Overflow)
        } else if *numerator != zero && !magnitude.is_normal() {
            Err(Error::Underflow)
        } else {
            Ok(if self.negative { -magnitude } else { magnitude })
        }
    }
}

fn sign(text: &str) -> (bool, &str) {
    for (mark, negative) in [('-', true), ('\u{2212}', true), ('+', false)] {
        if let Some(rest) = text.strip_prefix(mark) {
            return (negative, rest.trim_start());
        }
    }
    (false, text)
}

fn names_no_finite_number(text: &str) -> bool {
    let word = text.split_whitespace().next().unwrap_or("").to_ascii_lowercase();
    matches!(word.as_str(), "nan" | "inf" | "infinity" | "∞")
}

/// Splits a mantissa at its decimal sign, or says why that cannot be known.
fn separate(mantissa: &str) -> Result<(&str, &str), Error> {
    let separators = mantissa.matches(['.', ',']).count();
    match separators {
        0 => Ok((mantissa, "")),
        1 => {
            let at = mantissa.find(['.', ',']).unwrap_or(0);
            let (whole, fraction) = (&mantissa[..at], &mantissa[at + 1..]);
            if mantissa.contains(',') && looks_grouped(whole, fraction) {
                let decimal = format!("{whole}.{fraction}");
                let decimal = decimal.trim_end_matches('0').trim_end_matches('.').to_owned();
                return Err(Error::Ambiguous { decimal, grouped: format!("{whole}{fraction}") });
            }
            Ok((whole, fraction))
        }
        _ => Err(Error::Grouped { plain: without_groups(mantissa) }),
    }
}

/// Whether `whole`,`fraction` may be a whole number with a thousands separator.
fn looks_grouped(whole: &str, fraction: &str) -> bool {
    fraction.len() == 3 && (1..=3).contains(&whole.len()) && !whole.starts_with('0')
}

/// "1.000,5" as "1000.5", "1.000.000" as "1000000".
fn without_groups(mantissa: &str) -> String {
    let last = mantissa.rfind(['.', ',']).unwrap_or(0);
    let kinds_differ = mantissa.contains('.') && mantissa.contains(',');
    mantissa
        .char_indices()
        .filter_map(|(at, c)| match c {
            '.' | ',' if at == last && kinds_differ => Some('.'),
            '.' | ',' => None,
            digit => Some(digit),
        })
        .collect()
}

/// Reads "e-3"; a lone "e" is left to the unit.
fn exponent(text: &str) -> (i64, &str) {
    let Some(after) = text.strip_prefix(['e', 'E']) else {
        return printed_exponent(text).unwrap_or((0, text));
    };
    let (negative, digits) = match after.strip_prefix(['-', '\u{2212}']) {
        Some(digits) => (true, digits),
        None => (false, after.strip_prefix('+').unwrap_or(after)),
    };
    let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    if end == 0 {
        return (0, text);
    }
    let size = digits[..end].parse().unwrap_or(EXPONENT_LIMIT).min(EXPONENT_LIMIT);
    (if negative { -size } else { size }, &digits[end..])
}

/// " × 10⁻⁵", as numbers are printed, and " · 10^-5".
fn printed_exponent(text: &str) -> Option<(i64, &str)> {
    let after = text.trim_start().strip_prefix(['×', '·'])?.trim_start().strip_prefix("10")?;
    let after = after.strip_prefix('^').unwrap_or(after);
    let end = after.find(|c| plain(c).is_none()).unwrap_or(after.len());
    let digits: String = after[..end].chars().filter_map(plain).collect();
    let size: i64 = digits.parse().ok()?;
    Some((size.clamp(-EXPONENT_LIMIT, EXPONENT_LIMIT), &after[end..]))
}

/// A digit or minus sign that stands raised, or as it is.
fn plain(c: char) -> Option<char> {
    match c {
        '0'..='9' | '-' => Some(c),
        '\u{2212}' | '⁻' => Some('-'),
        '¹' => Some('1'),
        '²' => Some('2'),
        '³' => Some('3'),
        '⁰' | '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10),
        _ => None,
    }
}
