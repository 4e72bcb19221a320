//! One cell: a number, nothing, or something else.
//!
//! A file has one decimal sign. Digits are never grouped: "1,234.5" and "1.234,5" are no numbers, since "1,234" alone
//! could be either of two.

/// The decimal sign of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Decimal {
    /// 0.5
    Point,
    /// 0,5
    Comma,
}

/// What a cell holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Cell {
    /// A number, correctly rounded; infinite if it is too large for one.
    Number(f64),
    /// Nothing, or a word for it.
    Missing,
    /// Anything else.
    Text,
}

/// How programs write that there is no number.
const MISSING: &[&str] = &[
    "nan",
    "-nan",
    "+nan",
    "na",
    "n/a",
    "#n/a",
    "#na",
    "null",
    "none",
    "nil",
    "-",
    "--",
    "---",
    "inf",
    "+inf",
    "-inf",
    "infinity",
    "+infinity",
    "-infinity",
    "∞",
    "-∞",
    "undefined",
    "undef",
    "#div/0!",
    "#value!",
    "#num!",
    "#ref!",
    "#null!",
    "#name?",
    "#wert!",
    "#zahl!",
    "#nv",
    "n. def.",
];

/// Longest number with a decimal comma.
const LONGEST: usize = 100;

/// Reads a cell that has no blanks around it.
#[inline]
pub(super) fn read(cell: &[u8], decimal: Decimal) -> Cell {
    match cell {
        [] => Cell::Missing,
        [b'0'..=b'9' | b'-' | b'+' | b'.' | b',', ..] => match digits(cell, decimal) {
            Some(number) => Cell::Number(number),
            None => word(cell, decimal),
        },
        _ => word(cell, decimal),
    }
}

#[inline]
fn digits(cell: &[u8], decimal: Decimal) -> Option<f64> {
    // "-inf" and the like are words.
    if !matches!(cell.last()?, b'0'..=b'9' | b'.') {
        return None;
    }
    if decimal == Decimal::Point {
        return std::str::from_utf8(cell).ok()?.parse().ok();
    }
    let mut plain = [0; LONGEST];
    let plain = plain.get_mut(..cell.len())?;
    for (to, from) in plain.iter_mut().zip(cell) {
        *to = match from {
            b',' => b'.',
            b'.' => return None,
            other => *other,
        };
    }
    std::str::from_utf8(plain).ok()?.parse().ok()
}

#[cold]
fn word(cell: &[u8], decimal: Decimal) -> Cell {
    // The true minus sign.
    if let Some(rest) = cell.strip_prefix("\u{2212}".as_bytes())
        && let Some(number) = digits(rest, decimal)
        && rest.first().is_some_and(|first| !matches!(first, b'-' | b'+'))
    {
        return Cell::Number(-number);
    }
    let is_missing = MISSING.iter().any(|word| cell.eq_ignore_ascii_case(word.as_bytes()));
    if is_missing { Cell::Missing } else { Cell::Text }
}

/// Reads a time of day or a duration, "14:32:10,5", in seconds, with either decimal sign.
pub(super) fn clock(cell: &[u8]) -> Option<f64> {
    let mut parts = cell.split(|byte| *byte == b':');
    let parts = [parts.next()?, parts.next()?, parts.next()?, parts.next().unwrap_or_default()];
    let [hours, minutes, seconds, []] = parts else { return None };
    let number = |part: &[u8], decimal| match read(part, decimal) {
        Cell::Number(number) if part[0].is_ascii_digit() => Some(number),
        _ => None,
    };
    let whole = |part: &[u8]| {
        let digits = part.iter().all(u8::is_ascii_digit);
        digits.then(|| number(part, Decimal::Point)).flatten()
    };
    let sixty = |number: &f64| *number < 60.0;
    let seconds = number(seconds, Decimal::Point).or_else(|| number(seconds, Decimal::Comma));
    let minutes = whole(minutes).filter(sixty)?;
    Some((whole(hours)? * 60.0 + minutes) * 60.0 + seconds.filter(sixty)?)
}

/// Whether a cell is a number with a decimal sign and its digits in groups of three before it, by the other sign: "1.234,5".
pub(super) fn is_grouped(cell: &[u8], decimal: Decimal) -> bool {
    let (sign, between) = match decimal {
        Decimal::Point => (b'.', b','),
        Decimal::Comma => (b',', b'.'),
    };
    let cell = cell.strip_prefix(b"-").unwrap_or(cell);
    let Some(at) = cell.iter().position(|byte| *byte == sign) else { return false };
    let digits = |part: &[u8]| !part.is_empty() && part.iter().all(u8::is_ascii_digit);
    let mut groups = cell[..at].split(|byte| *byte == between);
    let first = groups.next().is_some_and(|group| digits(group) && group.len() <= 3);
    let mut others = groups.peekable();
    first
        && others.peek().is_some()
        && others.all(|group| digits(group) && group.len() == 3)
        && digits(&cell[at + 1..])
}

/// Whether a line begins with a word for nothing, which may look like a comment.
pub(super) fn begins_missing(line: &[u8]) -> bool {
    let starts = |word: &&&str| {
        line.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word.as_bytes()))
    };
    MISSING.iter().filter(|word| word.starts_with('#')).any(|word| starts(&word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_correctly() {
        let point = |text: &str| read(text.as_bytes(), Decimal::Point);
        let comma = |text: &str| read(text.as_bytes(), Decimal::Comma);
        assert_eq!(point("9.364549000E-3"), Cell::Number(9.364549e-3));
        assert_eq!(comma("9,364549000E-3"), Cell::Number(9.364549e-3));
        assert_eq!(point("+.5"), Cell::Number(0.5));
        assert_eq!(point("5."), Cell::Number(5.0));
        assert_eq!(point("\u{2212}2"), Cell::Number(-2.0));
        // Half way between two doubles but for the last digit.
        assert_eq!(
            point("9007199254740993.00000000000000000001"),
            Cell::Number(9007199254740994.0)
        );
        assert_eq!(point("1e400"), Cell::Number(f64::INFINITY));
    }

    #[test]
    fn grouped_digits_are_no_numbers() {
        for text in
            ["1,234.5", "1,234", "1.234.567", "1 234", "1_000", "1'000", "--1", "\u{2212}-1"]
        {
            assert_eq!(read(text.as_bytes(), Decimal::Point), Cell::Text, "{text}");
        }
        for text in ["1.234,5", "1.5", "1,2,3", "5,"] {
            assert_eq!(read(text.as_bytes(), Decimal::Comma), Cell::Text, "{text}");
        }
    }

    #[test]
    fn grouped_digits_are_known() {
        for (text, comma, point) in [
            ("1.234,5", true, false),
            ("-12.234.567,50", true, false),
            ("1,234.5", false, true),
            ("1.234", false, false),
            ("1234,5", false, false),
            ("1.23,4", false, false),
            (".234,5", false, false),
            ("1.234,", false, false),
        ] {
            assert_eq!(is_grouped(text.as_bytes(), Decimal::Comma), comma, "{text}");
            assert_eq!(is_grouped(text.as_bytes(), Decimal::Point), point, "{text}");
        }
    }

    #[test]
    fn times_of_day() {
        assert_eq!(clock(b"14:32:10,5"), Some(52_330.5));
        assert_eq!(clock(b"0:00:07.25"), Some(7.25));
        for text in ["12:30", "1:60:00", "1:00:60", "1:2:3:4", "-1:00:00", "a:b:c", "::", "1:1.5:0"]
        {
            assert_eq!(clock(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn words_for_nothing() {
        for text in ["", "NaN", "-inf", "N/A", "#N/A", "--", "null", "Infinity"] {
            assert_eq!(read(text.as_bytes(), Decimal::Point), Cell::Missing, "{text}");
        }
        for text in ["ok", "0x10", "1s", "12:30:05", "e5", "-", "inf1"] {
            let expected = if text == "-" { Cell::Missing } else { Cell::Text };
            assert_eq!(read(text.as_bytes(), Decimal::Point), expected, "{text}");
        }
    }
}
