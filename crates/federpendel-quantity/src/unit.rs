//! Units and the little grammar that joins them: "N·s/m", "kg m^-3", "lbf/in", "g/(m·s)".

use super::Error;
use super::decimal::Scale;
use super::dimension::{Dimension, Powers};

/// A named unit: mantissa·10^exponent in SI, exactly.
struct Named {
    symbol: &'static str,
    mantissa: u64,
    exponent: i32,
    powers: Powers,
    prefixes: bool,
}

const fn si(symbol: &'static str, exponent: i32, powers: Powers) -> Named {
    Named { symbol, mantissa: 1, exponent, powers, prefixes: true }
}

const fn other(symbol: &'static str, mantissa: u64, exponent: i32, powers: Powers) -> Named {
    Named { symbol, mantissa, exponent, powers, prefixes: false }
}

/// SI brochure, 9th edition, tables 4 and 8; inch, foot, pound and pound-force by their
/// definitions of 1959 (lbf with the standard gravity 9.80665 m/s²).
const UNITS: &[Named] = &[
    si("g", -3, [1, 0, 0]),
    si("t", 3, [1, 0, 0]),
    si("m", 0, [0, 1, 0]),
    si("s", 0, [0, 0, 1]),
    si("N", 0, [1, 1, -2]),
    // Without a sign between its factors, as it is often written: "0.2 Ns/m".
    si("Ns", 0, [1, 1, -1]),
    si("Hz", 0, [0, 0, -1]),
    si("J", 0, [1, 2, -2]),
    si("W", 0, [1, 2, -3]),
    si("Pa", 0, [1, -1, -2]),
    si("bar", 5, [1, -1, -2]),
    si("l", -3, [0, 3, 0]),
    si("L", -3, [0, 3, 0]),
    other("%", 1, -2, [0, 0, 0]),
    other("1", 1, 0, [0, 0, 0]),
    other("min", 60, 0, [0, 0, 1]),
    other("h", 3600, 0, [0, 0, 1]),
    other("in", 254, -4, [0, 1, 0]),
    other("ft", 3048, -4, [0, 1, 0]),
    other("lb", 45_359_237, -8, [1, 0, 0]),
    other("oz", 28_349_523_125, -12, [1, 0, 0]),
    other("lbf", 44_482_216_152_605, -13, [1, 1, -2]),
    other("kgf", 980_665, -5, [1, 1, -2]),
];

const PREFIXES: &[(&str, i32)] = &[
    ("p", -12),
    ("n", -9),
    ("µ", -6),
    ("μ", -6),
    ("u", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("da", 1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// Largest power that is read; "m^10" is a slip of the keyboard.
const LARGEST_POWER: i32 = 9;

/// A product of powers of named units.
#[derive(Debug)]
pub(super) struct Unit {
    pub(super) scale: Scale,
    pub(super) powers: Powers,
}

impl Unit {
    /// Reads all of `text`; `wanted` guides the suggestion for an unknown unit.
    pub(super) fn parse(text: &str, wanted: Dimension) -> Result<Self, Error> {
        let mut unit = Unit { scale: Scale::one(), powers: [0; 3] };
        let mut parser = Parser { text, rest: text, wanted };
        parser.product(&mut unit, 1, false)?;
        if parser.rest.is_empty() { Ok(unit) } else { Err(parser.broken()) }
    }

    fn multiply(&mut self, named: &Named, prefix: i32, power: i32) {
        self.scale.multiply(named.mantissa, named.exponent + prefix, power);
        for (sum, own) in self.powers.iter_mut().zip(named.powers) {
            *sum += own * power;
        }
    }
}

struct Parser<'a> {
    text: &'a str,
    rest: &'a str,
    wanted: Dimension,
}

impl Parser<'_> {
    fn broken(&self) -> Error {
        Error::UnitGrammar { unit: self.text.to_owned() }
    }

    /// factor { (· | * | space | /) factor }. After a solidus only a further solidus may follow:
    /// "kg/m·s" is read in two ways by different people.
    fn product(&mut self, unit: &mut Unit, sign: i32, nested: bool) -> Result<(), Error> {
        self.factor(unit, sign, nested)?;
        let mut divided = false;
        loop {
            let before = self.rest;
            self.skip_spaces();
            if self.rest.is_empty() || nested && self.rest.starts_with(')') {
                return Ok(());
            }
            if self.skip_any(&['/']) {
                divided = true;
            } else if divided || !self.skip_any(&['·', '⋅', '*', '×']) && self.rest == before {
                return Err(self.broken());
            }
            self.skip_spaces();
            self.factor(unit, if divided { -sign } else { sign }, nested)?;
        }
    }

    /// A unit with its power, or a product in parentheses (not nested).
    fn factor(&mut self, unit: &mut Unit, sign: i32, nested: bool) -> Result<(), Error> {
        if !nested && self.skip_any(&['(']) {
            self.product(unit, sign, true)?;
            return if self.skip_any(&[')']) { Ok(()) } else { Err(self.broken()) };
        }
        let end = self.rest.find(ends_symbol).unwrap_or(self.rest.len());
        // "1/s" and "0.5 1": the one unit that is a digit.
        let end = if end == 0 && begins_with_one(self.rest) { 1 } else { end };
        let (symbol, rest) = self.rest.split_at(end);
        if symbol.is_empty() {
            return Err(self.broken());
        }
        let (named, prefix) =
            look_up(symbol).ok_or_else(|| unknown(symbol, self.text, self.wanted))?;
        self.rest = rest;
        let power = self.power()?;
        unit.multiply(named, prefix, sign * power);
        Ok(())
    }

    /// "^2", "^-1", "²", "⁻¹" or "2" straight after the symbol.
    fn power(&mut self) -> Result<i32, Error> {
        let marked = self.skip_any(&['^']);
        let mut digits = String::new();
        while let Some(c) = self.rest.chars().next() {
            let Some(plain) = plain_exponent(c) else { break };
            digits.push(plain);
            self.rest = &self.rest[c.len_utf8()..];
        }
        if digits.is_empty() {
            return if marked { Err(self.broken()) } else { Ok(1) };
        }
        match digits.parse::<i32>() {
            Ok(power) if power != 0 && power.abs() <= LARGEST_POWER => Ok(power),
            _ => Err(self.broken()),
        }
    }

    fn skip_spaces(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn skip_any(&mut self, marks: &[char]) -> bool {
        let rest = self.rest.strip_prefix(marks);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }
}

fn ends_symbol(c: char) -> bool {
    !(c.is_alphabetic() || c == '%')
}

/// A one that stands alone or is divided; "1 12 N" has two numbers.
fn begins_with_one(text: &str) -> bool {
    text.strip_prefix('1').is_some_and(|rest| {
        let rest = rest.trim_start();
        rest.is_empty() || rest.starts_with('/')
    })
}

fn plain_exponent(c: char) -> Option<char> {
    match c {
        '0'..='9' | '-' => Some(c),
        '⁻' | '\u{2212}' => Some('-'),
        '¹' => Some('1'),
        '²' => Some('2'),
        '³' => Some('3'),
        '⁴' => Some('4'),
        _ => None,
    }
}

/// The unit and the power of ten of its prefix. A unit's own name wins: "min" is a minute.
fn look_up(symbol: &str) -> Option<(&'static Named, i32)> {
    if let Some(named) = UNITS.iter().find(|named| named.symbol == symbol) {
        return Some((named, 0));
    }
    PREFIXES.iter().find_map(|(prefix, exponent)| {
        let base = symbol.strip_prefix(prefix)?;
        let named = UNITS.iter().find(|named| named.prefixes && named.symbol == base)?;
        Some((named, *exponent))
    })
}

/// The unknown `symbol` of `text` beside the right unit that looks most like it: whole expressions
/// first, held against all of `text`, then symbols.
fn unknown(symbol: &str, text: &str, wanted: Dimension) -> Error {
    let candidates = wanted.units().iter().map(|unit| (*unit, text));
    let symbols = UNITS.iter().map(|named| (named.symbol, symbol));
    let near = candidates
        .chain(symbols)
        .map(|(unit, written)| (distance(unit, written), unit, written))
        .filter(|(distance, unit, _)| *distance <= 0.5 * unit.chars().count().max(2) as f64)
        .min_by(|(a, ..), (b, ..)| a.total_cmp(b));
    match near {
        Some((_, unit, written)) => {
            Error::UnknownUnit { unit: written.to_owned(), nearest: Some(unit.to_owned()) }
        }
        None => Error::UnknownUnit { unit: symbol.to_owned(), nearest: None },
    }
}

/// Edits between two spellings; a wrong case counts half.
fn distance(unit: &str, written: &str) -> f64 {
    let (unit_lower, written_lower) = (unit.to_lowercase(), written.to_lowercase());
    let edits = strsim::damerau_levenshtein(&unit_lower, &written_lower) as f64;
    let case_differs = edits == 0.0 && unit != written;
    edits + if case_differs { 0.5 } else { 0.0 }
}
