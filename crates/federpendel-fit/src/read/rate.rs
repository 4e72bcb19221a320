//! The rate of even times, told above the numbers: "sample rate: 1000 Hz", "Abtastintervall;0,01 s", or a name with its
//! number in the line below.

use super::heading::Heading;
use super::line::{Cells, Separator};
use super::number::{self, Cell, Decimal};
use super::unit;

const RATES: &[&str] = &["rate", "frequenz", "frequency", "fs", "samples per second"];
const STEPS: &[&str] = &[
    "interval",
    "intervall",
    "time step",
    "timestep",
    "zeitschritt",
    "dt",
    "increment",
    "delta t",
];

/// The rate, 1/s, if the preamble tells one.
pub(super) fn of(preamble: &[String]) -> Option<f64> {
    preamble.iter().enumerate().find_map(|(at, line)| {
        let below = preamble.get(at + 1).map_or("", String::as_str);
        [':', '=', ';', '\t', ','].iter().find_map(|mark| {
            let cells: Vec<&str> = line.split(*mark).collect();
            let separator = match mark {
                ';' => Separator::Semicolon,
                '\t' => Separator::Tab,
                _ => Separator::Comma,
            };
            cells.iter().enumerate().find_map(|(at, cell)| {
                let beside = cells.get(at + 1).copied().unwrap_or("");
                let under = Cells::new(below.as_bytes(), separator).nth(at).unwrap_or_default();
                let under = std::str::from_utf8(under).unwrap_or("");
                rate(cell, beside).or_else(|| rate(cell, under))
            })
        })
    })
}

/// The rate that a name and its value tell.
fn rate(name: &str, value: &str) -> Option<f64> {
    let heading = Heading::parse(name.trim().trim_matches(['"', '#', '%', ' ']));
    let small = heading.name.to_lowercase().replace('_', " ");
    let is = |words: &[&str]| {
        words.iter().any(|word| small == *word || word.len() > 2 && small.ends_with(word))
    };
    let (is_rate, is_step) = (is(RATES), is(STEPS));
    if !(is_rate || is_step) {
        return None;
    }
    let value = value.trim().trim_matches('"').trim();
    let end =
        value.find(|c: char| c.is_whitespace() || c.is_alphabetic() && !matches!(c, 'e' | 'E'));
    let (digits, behind) = value.split_at(end.unwrap_or(value.len()));
    let decimal = if digits.contains('.') { Decimal::Point } else { Decimal::Comma };
    let Cell::Number(number) = number::read(digits.as_bytes(), decimal) else { return None };
    let text = if behind.trim().is_empty() { heading.unit.as_str() } else { behind.trim() };
    let rate = if is_step {
        let second = unit::parse("s")?;
        let unit = if text.is_empty() { second } else { unit::parse(text)? };
        1.0 / unit.quantity.is_none().then(|| unit.to_si(number))?
    } else {
        number * hertz(text)?
    };
    (rate.is_finite() && rate > 0.0).then_some(rate)
}

fn hertz(unit: &str) -> Option<f64> {
    match unit.to_lowercase().as_str() {
        "" | "hz" | "1/s" | "s^-1" | "sps" | "samples/s" | "samples/sec" => Some(1.0),
        "khz" => Some(1e3),
        "mhz" => Some(1e6),
        "1/min" => Some(1.0 / 60.0),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_found_in_many_forms() {
        for (preamble, expected) in [
            ("trigger_start_deg, sample_rate, duration_sec\n90, 1000, 5 ", 1000.0),
            ("sample rate: 1 kHz", 1000.0),
            ("# rate = 50", 50.0),
            ("Abtastrate (Hz);250", 250.0),
            ("Abtastintervall;0,01 s", 100.0),
            ("Sampling interval\t20 ms", 50.0),
            ("dt=0.5", 2.0),
            ("Sample Rate (Hz),Other\n200,3", 200.0),
            ("some words\nsampling frequency: 1e2 Hz", 100.0),
        ] {
            let lines: Vec<String> = preamble.lines().map(str::to_owned).collect();
            assert_eq!(of(&lines), Some(expected), "{preamble}");
        }
        for preamble in
            ["rate: fast", "rate: 0", "heart rate monitor", "Width: 5", "rate: 5 apples", ""]
        {
            assert_eq!(of(&[preamble.to_owned()]), None, "{preamble}");
        }
    }
}
