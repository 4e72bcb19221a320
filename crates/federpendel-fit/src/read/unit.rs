//! Units of times, positions, velocities and accelerations, as headers write them.

use std::f64::consts::PI;

use crate::Quantity;

/// A unit that is understood.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    /// What it measures; `None` is a time.
    pub quantity: Option<Quantity>,
    /// The SI unit.
    pub si: &'static str,
    /// Value in SI = value · numerator / denominator: two roundings, where a factor like 0.001 would be a third.
    pub numerator: f64,
    /// See `numerator`.
    pub denominator: f64,
}

impl Unit {
    /// The value in SI.
    #[inline]
    pub fn to_si(self, value: f64) -> f64 {
        value * self.numerator / self.denominator
    }
}

/// Units of time to name where one is asked for.
pub(super) const TIMES: &[&str] = &["s", "ms", "µs", "ns", "min", "h"];

/// Spellings of units of time.
const TIME: &[(&str, f64, f64)] = &[
    ("s", 1.0, 1.0),
    ("sec", 1.0, 1.0),
    ("secs", 1.0, 1.0),
    ("sek", 1.0, 1.0),
    ("second", 1.0, 1.0),
    ("seconds", 1.0, 1.0),
    ("sekunde", 1.0, 1.0),
    ("sekunden", 1.0, 1.0),
    ("ms", 1.0, 1e3),
    ("msec", 1.0, 1e3),
    ("millis", 1.0, 1e3),
    ("milliseconds", 1.0, 1e3),
    ("millisekunden", 1.0, 1e3),
    ("us", 1.0, 1e6),
    ("µs", 1.0, 1e6),
    ("microseconds", 1.0, 1e6),
    ("mikrosekunden", 1.0, 1e6),
    ("ns", 1.0, 1e9),
    ("nanoseconds", 1.0, 1e9),
    ("nanosekunden", 1.0, 1e9),
    ("min", 60.0, 1.0),
    ("minutes", 60.0, 1.0),
    ("minuten", 60.0, 1.0),
    ("h", 3600.0, 1.0),
    ("hours", 3600.0, 1.0),
    ("stunden", 3600.0, 1.0),
];

/// Spellings of units of length; foot and inch by their definitions of 1959.
const LENGTH: &[(&str, f64, f64)] = &[
    ("m", 1.0, 1.0),
    ("meter", 1.0, 1.0),
    ("meters", 1.0, 1.0),
    ("metre", 1.0, 1.0),
    ("metres", 1.0, 1.0),
    ("dm", 1.0, 10.0),
    ("cm", 1.0, 1e2),
    ("mm", 1.0, 1e3),
    ("um", 1.0, 1e6),
    ("µm", 1.0, 1e6),
    ("nm", 1.0, 1e9),
    ("km", 1e3, 1.0),
    ("in", 254.0, 1e4),
    ("inch", 254.0, 1e4),
    ("ft", 3048.0, 1e4),
];

/// Spellings of units of angle.
const ANGLE: &[(&str, f64, f64)] = &[
    ("rad", 1.0, 1.0),
    ("radian", 1.0, 1.0),
    ("radians", 1.0, 1.0),
    ("mrad", 1.0, 1e3),
    ("deg", PI, 180.0),
    ("degree", PI, 180.0),
    ("degrees", PI, 180.0),
    ("grad", PI, 180.0),
    ("°", PI, 180.0),
    ("rev", 2.0 * PI, 1.0),
];

/// Units with a name of their own; the standard acceleration is that of the CGPM, 1901.
const NAMED: &[(&str, Quantity, &str, f64, f64)] = &[
    ("km/h", Quantity::Velocity, "m/s", 10.0, 36.0),
    ("rpm", Quantity::Velocity, "rad/s", PI, 30.0),
    ("dps", Quantity::Velocity, "rad/s", PI, 180.0),
    ("mps", Quantity::Velocity, "m/s", 1.0, 1.0),
    ("g", Quantity::Acceleration, "m/s^2", 9.80665, 1.0),
    ("g0", Quantity::Acceleration, "m/s^2", 9.80665, 1.0),
    ("gn", Quantity::Acceleration, "m/s^2", 9.80665, 1.0),
    ("mg", Quantity::Acceleration, "m/s^2", 9.80665, 1e3),
    ("gal", Quantity::Acceleration, "m/s^2", 1.0, 1e2),
];

/// Ways to write "per second squared" and "per second" behind a length or an angle.
const PER: &[(&str, usize)] = &[
    ("/s2", 2),
    ("/s/s", 2),
    ("/sec2", 2),
    ("/(ss)", 2),
    ("s-2", 2),
    ("/s", 1),
    ("/sec", 1),
    ("s-1", 1),
];

/// SI units of lengths and angles, of their rates and the rates of these.
const SI: [[&str; 3]; 2] = [["m", "m/s", "m/s^2"], ["rad", "rad/s", "rad/s^2"]];

const QUANTITIES: [Quantity; 3] = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration];

/// Reads a unit: one of time first.
pub(super) fn parse(text: &str) -> Option<Unit> {
    let plain = normalised(text);
    time(&plain).or_else(|| motion(&plain))
}

fn time(plain: &str) -> Option<Unit> {
    let (_, numerator, denominator) = *TIME.iter().find(|(name, ..)| *name == plain)?;
    Some(Unit { quantity: None, si: "s", numerator, denominator })
}

fn motion(plain: &str) -> Option<Unit> {
    if let Some(&(_, quantity, si, numerator, denominator)) =
        NAMED.iter().find(|(name, ..)| *name == plain)
    {
        return Some(Unit { quantity: Some(quantity), si, numerator, denominator });
    }
    let (base, order) = PER
        .iter()
        .find_map(|(per, order)| Some((plain.strip_suffix(per)?, *order)))
        .unwrap_or((plain, 0));
    let base = base.strip_suffix('*').unwrap_or(base);
    [LENGTH, ANGLE].iter().zip(SI).find_map(|(table, si)| {
        let (_, numerator, denominator) = *table.iter().find(|(name, ..)| *name == base)?;
        Some(Unit { quantity: Some(QUANTITIES[order]), si: si[order], numerator, denominator })
    })
}

/// One spelling of many: without blanks and powers' signs, small letters. "Mm" and "MS" are nothing that is recorded
/// here, and programs write "Sec" and "Deg".
fn normalised(text: &str) -> String {
    text.chars()
        .filter(|c| !c.is_whitespace() && !matches!(c, '^' | '·' | '⋅' | '*' | '.'))
        .map(|c| match c {
            '²' => '2',
            '¹' => '1',
            '⁻' | '\u{2212}' => '-',
            'μ' => 'µ',
            'º' | '˚' => '°',
            c => c,
        })
        .flat_map(char::to_lowercase)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use Quantity::*;

    fn si(text: &str) -> Option<(Option<Quantity>, &'static str, f64)> {
        parse(text).map(|unit| (unit.quantity, unit.si, unit.to_si(1.0)))
    }

    #[test]
    fn one_unit_has_many_spellings() {
        for text in
            ["m/s^2", "m/s²", "m s^-2", "m·s⁻²", "ms-2", "m/s/s", "m/(s·s)", "m/s2", " m / s^2 "]
        {
            assert_eq!(si(text), Some((Some(Acceleration), "m/s^2", 1.0)), "{text}");
        }
        for text in ["deg/s", "°/s", "º/s", "dps", "Deg/sec"] {
            assert_eq!(si(text), Some((Some(Velocity), "rad/s", PI / 180.0)), "{text}");
        }
    }

    #[test]
    fn values_come_in_si() {
        assert_eq!(si("cm"), Some((Some(Position), "m", 0.01)));
        assert_eq!(si("mm"), Some((Some(Position), "m", 0.001)));
        assert_eq!(si("km/h"), Some((Some(Velocity), "m/s", 10.0 / 36.0)));
        assert_eq!(si("g"), Some((Some(Acceleration), "m/s^2", 9.80665)));
        assert_eq!(si("rad/s²"), Some((Some(Acceleration), "rad/s^2", 1.0)));
        assert_eq!(si("ms"), Some((None, "s", 0.001)));
        assert_eq!(si("min"), Some((None, "s", 60.0)));
        for text in ["V", "", "mV", "N", "a.u.", "1", "/s"] {
            assert_eq!(si(text), None, "{text}");
        }
    }
}
