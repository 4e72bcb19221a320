//! Where the ticks of an axis are, and what is written at them.

use super::{Scale, Span};
use crate::language::Language;
use crate::number::{localise, number, superscript};

/// A tick: its value in the unit of the axis, and its label.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub value: f64,
    pub label: String,
}

/// At most `most` ticks at round values (1, 2 or 5 times a power of ten, or whole decades).
pub(crate) fn ticks(span: &Span, most: usize, language: Language) -> Vec<Tick> {
    let values = match span.scale {
        Scale::Linear => multiples(span, step(span, most)),
        Scale::Logarithmic => decades(span, most),
    };
    values
        .into_iter()
        .map(|value| Tick { value, label: label(value, span, most, language) })
        .collect()
}

/// The distance of the ticks of a linear axis.
pub(crate) fn step(span: &Span, most: usize) -> f64 {
    let rough = (span.high - span.low) / most.max(1) as f64;
    let decade = 10f64.powf(rough.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|factor| factor * decade)
        .find(|step| multiples(span, *step).len() <= most.max(1))
        .unwrap_or(20.0 * decade)
}

/// What is written at the tick `value`.
pub(crate) fn label(value: f64, span: &Span, most: usize, language: Language) -> String {
    if span.scale == Scale::Logarithmic {
        return logarithmic(value, span, most, language);
    }
    let step = step(span, most);
    // The multiple of the step that is meant, so that 0 is 0 and not a rounding error.
    let value = (value / step).round() * step;
    let largest = span.low.abs().max(span.high.abs());
    if value == 0.0 {
        "0".to_owned()
    } else if !(1e-4..1e6).contains(&largest) {
        // As many digits as tell neighbouring ticks apart.
        let digits = (largest / step).log10().floor().max(0.0) as usize + 1;
        number(language, value, digits)
    } else {
        let decimals = (-step.log10() - 1e-9).ceil().max(0.0) as usize;
        localise(language, format!("{value:.decimals$}")).replace('-', "−")
    }
}

/// Plain numbers where all along the axis are short, else powers of ten; nothing between the strides of an axis
/// of many decades.
fn logarithmic(value: f64, span: &Span, most: usize, language: Language) -> String {
    let exponent = value.log10();
    let power = exponent.round() as i32;
    let whole = (exponent - exponent.round()).abs() < 1e-9;
    if whole && power.rem_euclid(stride(span, most)) != 0 {
        String::new()
    } else if span.low >= 0.9e-3 && span.high <= 1.1e4 {
        number(language, value, 4)
    } else if whole {
        format!("10{}", superscript(power))
    } else {
        let power = exponent.floor() as i32;
        let times = number(language, value / 10f64.powi(power), 2);
        format!("{times} × 10{}", superscript(power))
    }
}

fn multiples(span: &Span, step: f64) -> Vec<f64> {
    // A hair of slack keeps the tick at the very end of the axis.
    let slack = 1e-9 * (span.high - span.low) / step;
    let first = (span.low / step - slack).ceil();
    let last = (span.high / step + slack).floor();
    if !(last - first).is_finite() || last - first > 1e4 {
        return Vec::new();
    }
    (0..=(last - first).max(-1.0) as i64).map(|i| (first + i as f64) * step).collect()
}

fn decades(span: &Span, most: usize) -> Vec<f64> {
    let (first, last) = powers(span);
    let stride = stride(span, most);
    let whole: Vec<_> = (first..=last)
        .filter(|power| power.rem_euclid(stride) == 0)
        .map(|power| 10f64.powi(power))
        .collect();
    if last - first >= 1 {
        return whole;
    }
    // Too short for whole decades to say much.
    let within = |value: &f64| (span.low..=span.high).contains(value);
    (first - 1..=last + 1)
        .flat_map(|power| [1.0, 2.0, 5.0].map(|times| times * 10f64.powi(power)))
        .filter(within)
        .take(most.max(1))
        .collect()
}

/// The first and the last power of ten within the span.
fn powers(span: &Span) -> (i32, i32) {
    let first = (span.low.log10() - 1e-9).ceil() as i32;
    (first, (span.high.log10() + 1e-9).floor() as i32)
}

/// How many decades lie between two ticks.
fn stride(span: &Span, most: usize) -> i32 {
    let (first, last) = powers(span);
    ((last - first + 1).max(1) as usize).div_ceil(most.max(1)) as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64, most: usize, scale: Scale) -> Vec<String> {
        ticks(&Span { low, high, scale }, most, Language::German)
            .into_iter()
            .map(|tick| tick.label)
            .collect()
    }

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(labels(0.0, 6.0, 7, Scale::Linear), ["0", "1", "2", "3", "4", "5", "6"]);
        assert_eq!(labels(-1.05, 1.05, 5, Scale::Linear), ["−1,0", "−0,5", "0", "0,5", "1,0"]);
        assert_eq!(labels(0.0, 0.3, 4, Scale::Linear), ["0", "0,1", "0,2", "0,3"]);
        assert_eq!(labels(1.99996, 2.0, 3, Scale::Linear), ["1,99996", "1,99998", "2,00000"]);
        assert_eq!(labels(0.0, 5e7, 3, Scale::Linear), ["0", "2 × 10⁷", "4 × 10⁷"]);
        assert_eq!(
            labels(1e-6, 1e2, 5, Scale::Logarithmic),
            ["10⁻⁶", "10⁻⁴", "10⁻²", "10⁰", "10²"]
        );
        assert_eq!(
            labels(1e-3, 1e2, 6, Scale::Logarithmic),
            ["0,001", "0,01", "0,1", "1", "10", "100"]
        );
        assert_eq!(labels(1.5, 7.0, 5, Scale::Logarithmic), ["2", "5"]);
    }

    #[test]
    fn there_are_ticks_for_any_range() {
        for magnitude in [1e-300, 1e-9, 1.0, 1e9, 1e300] {
            for most in 2..12 {
                let span = Span { low: -magnitude, high: magnitude, scale: Scale::Linear };
                let ticks = ticks(&span, most, Language::English);
                assert!((1..=most).contains(&ticks.len()), "{magnitude} {most}: {ticks:?}");
            }
        }
    }
}
