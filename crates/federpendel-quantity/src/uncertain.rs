//! Quantities with a standard uncertainty, as laboratories write them: "250(1) g", "12.0 ± 0.3 N/m",
//! "(12,0 +/- 0,3) N/m", "250 g ± 1 g".

use federpendel_fit::Measured;

use super::decimal::Decimal;
use super::{Dimension, Error, LONGEST, parse};

/// What may stand between a value and its uncertainty.
const SIGNS: [&str; 4] = ["±", "+/-", "+-", "\\pm"];

/// Reads `text` as a quantity of `dimension` with its standard uncertainty, both SI; one without is exact.
///
/// # Errors
/// As [`parse`] for either of them; an uncertainty that is negative, that alone has no unit, or whose parentheses do not
/// hold whole digits.
pub fn parse_uncertain(text: &str, dimension: Dimension) -> Result<Measured, Error> {
    if text.len() > LONGEST {
        return Err(Error::TooLong { length: text.len() });
    }
    let (value, uncertainty) = split(text.trim())?;
    let Some(uncertainty) = uncertainty else {
        return Ok(Measured { value: parse(&value, dimension)?, uncertainty: 0.0 });
    };
    let (value, uncertainty) = (parse(&value, dimension)?, parse(&uncertainty, dimension)?);
    if uncertainty < 0.0 {
        return Err(Error::NegativeUncertainty);
    }
    Ok(Measured { value, uncertainty })
}

/// The value and its uncertainty, each as a quantity of its own.
fn split(text: &str) -> Result<(String, Option<String>), Error> {
    let sign = SIGNS.iter().find_map(|sign| Some((text.find(sign)?, sign.len())));
    let Some((at, length)) = sign else { return last_digits(text) };
    let (value, uncertainty) = (text[..at].trim(), text[at + length..].trim());
    let broken = || Error::UncertaintyGrammar { text: text.to_owned() };
    if SIGNS.iter().any(|sign| uncertainty.contains(sign)) {
        return Err(broken());
    }
    if let Some(value) = value.strip_prefix('(') {
        let (uncertainty, unit) = uncertainty.split_once(')').ok_or_else(broken)?;
        return Ok((format!("{value} {unit}"), Some(format!("{uncertainty} {unit}"))));
    }
    let unit_of = |quantity| Ok(Decimal::read(quantity)?.1.trim());
    match (unit_of(value)?, unit_of(uncertainty)?) {
        // One unit for both stands behind them.
        ("", unit) => Ok((format!("{value} {unit}"), Some(uncertainty.to_owned()))),
        (_, "") => Err(Error::UncertaintyWithoutUnit),
        _ => Ok((value.to_owned(), Some(uncertainty.to_owned()))),
    }
}

/// "12.50(3) N/m" as "12.50 N/m" and "0.03 N/m".
fn last_digits(text: &str) -> Result<(String, Option<String>), Error> {
    let number = |c: char| c.is_ascii_digit() || ".,+-−".contains(c);
    let opening = text.find('(').filter(|at| *at > 0 && text[..*at].chars().all(number));
    let Some(opening) = opening else { return Ok((text.to_owned(), None)) };
    let (value, rest) = (&text[..opening], &text[opening + 1..]);
    let broken = || Error::UncertaintyGrammar { text: text.to_owned() };
    let (digits, rest) = rest.split_once(')').ok_or_else(broken)?;
    if digits.is_empty() || !digits.chars().all(|c| c.is_ascii_digit()) {
        return Err(broken());
    }
    // The digits count from the last place of the value.
    let places = value.find(['.', ',']).map_or(0, |at| value.len() - at - 1);
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    Ok((format!("{value}{rest}"), Some(format!("{whole}.{fraction}{rest}"))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use Dimension::{Mass, Stiffness};

    fn both(text: &str, dimension: Dimension) -> (f64, f64) {
        let found = parse_uncertain(text, dimension).unwrap_or_else(|e| panic!("{text}: {e}"));
        (found.value, found.uncertainty)
    }

    #[test]
    fn uncertainties_have_many_spellings() {
        for text in [
            "12.0 ± 0.3 N/m",
            "12,0 +/- 0,3 N/m",
            "(12.0 ± 0.3) N/m",
            "( 12,0+-0,3 )N/m",
            "12.0(3) N/m",
            "12.00(30)N/m",
            "12 N/m ± 0.3 N/m",
            "12 N/m ± 30 cN/m",
            "12.0 ± 0.3",
            "1.20(3)e1 N/m",
        ] {
            assert_eq!(both(text, Stiffness), (12.0, 0.3), "{text}");
        }
        for text in ["250(1) g", "250 ± 1 g", "0.250(1) kg", "0,2500(10) kg", "+250(1) g"] {
            assert_eq!(both(text, Mass), (0.25, 0.001), "{text}");
        }
        assert_eq!(both("0.250(1250) kg", Mass), (0.25, 1.25));
        assert_eq!(both("250 g", Mass), (0.25, 0.0));
        assert_eq!(both("250(0) g", Mass), (0.25, 0.0));
        assert_eq!(both("12 kg/(s·s)", Stiffness), (12.0, 0.0));
    }

    #[test]
    fn what_is_no_uncertainty_is_refused() {
        for (text, error) in [
            ("12.0 ± -0.3 N/m", Error::NegativeUncertainty),
            ("(12.0 ± −0.3) N/m", Error::NegativeUncertainty),
            ("12.0 N/m ± 0.3", Error::UncertaintyWithoutUnit),
            ("12.0 ± N/m", Error::NoNumber),
            ("± 0.3 N/m", Error::Empty),
            ("12.0 ± nan N/m", Error::NotFinite),
        ] {
            assert_eq!(parse_uncertain(text, Stiffness), Err(error), "{text}");
        }
        for text in [
            "12(a) N/m",
            "12() N/m",
            "12(3 N/m",
            "12(0.3) N/m",
            "12(-3) N/m",
            "(12 ± 1 N/m",
            "1 ± 2 ± 3 N/m",
        ] {
            let error = Error::UncertaintyGrammar { text: text.to_owned() };
            assert_eq!(parse_uncertain(text, Stiffness), Err(error), "{text}");
        }
        for text in ["250(1) g", "12 ± 1 g", "12 N/m ± 1 %", "12 N/m ± 1 g", "(12 ± 1) kg"] {
            let found = parse_uncertain(text, Stiffness);
            assert!(matches!(found, Err(Error::WrongDimension { .. })), "{text}: {found:?}");
        }
        for text in ["(12 N/m ± 1) N/m", "12.0(3) (N/m", "(12 ± 1) N/", "12 ± 1 kgg"] {
            assert!(parse_uncertain(text, Stiffness).is_err(), "{text}");
        }
        assert_eq!(parse_uncertain(&"1".repeat(201), Mass), Err(Error::TooLong { length: 201 }));
    }

    mod properties {
        use super::*;
        use proptest::prelude::*;

        proptest! {
            #[test]
            fn last_digits_are_an_uncertainty(whole in 0u32..1000, fraction in "[0-9]{1,6}", digits in 1u32..1000) {
                let written = format!("{whole}.{fraction}({digits}) kg");
                let scale = fraction.len();
                let expected: f64 = format!("{digits}e-{scale}").parse().unwrap();
                let found = both(&written, Mass);
                prop_assert_eq!(found, (format!("{whole}.{fraction}").parse().unwrap(), expected));
            }

            #[test]
            fn no_text_makes_it_panic(text in "[-+0-9.,e()± /Ng]{0,24}|\\PC{0,40}") {
                let _ = parse_uncertain(&text, Mass);
            }
        }
    }
}
