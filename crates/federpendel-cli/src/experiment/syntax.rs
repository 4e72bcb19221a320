//! What is wrong with a file that is not TOML, in kinds for which there are sentences.

use federpendel_text::excerpt;
use toml::de::DeTable;

use super::repair::{repaired, straightened};

/// Why a file is not TOML.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Syntax {
    /// A quantity that stands without quotes: `mass = 300 g`, `mass = 0,3`.
    Unquoted {
        /// Its key, as it is written.
        key: String,
        /// What stands behind the `=`.
        value: String,
    },
    /// Quotes that TOML does not know: `mass = „300 g“`.
    Typographic,
    /// Any other value that must stand in quotes.
    UnquotedText,
    /// A key or a section that stands twice.
    Twice {
        /// Its name.
        key: String,
    },
    /// A text without its closing quote, or with signs that none may hold.
    BadText,
    /// `[section` without its bracket.
    UnclosedSection,
    /// `{ key = value` without its brace.
    UnclosedTable,
    /// `[1, 2` without its bracket.
    UnclosedList,
    /// A key without `=`.
    NoEquals,
    /// A key and `=`, and nothing behind.
    NoValue,
    /// `=` without a key, or a key with signs that none may hold.
    BadKey,
    /// A comma missing or too many, in braces or brackets.
    Comma,
    /// A number that is no TOML number: `01`, `1__0`.
    BadNumber,
    /// Something behind the end of a value or a section.
    Trailing,
    /// Tables or lists within one another without end.
    TooDeep,
    /// None of these; in the words of the TOML library.
    Other(String),
}

impl Syntax {
    /// The kind of an error at `offset` of `text`, on line `number` from 1, and that line as it may
    /// have been meant.
    pub(super) fn of(
        text: &str,
        offset: usize,
        number: usize,
        error: &toml::de::Error,
    ) -> (Self, Option<String>) {
        let line = text.lines().nth(number.saturating_sub(1)).unwrap_or_default();
        if let Some(straight) = straightened(line) {
            return (Syntax::Typographic, Some(excerpt(&straight)));
        }
        let kind = Self::kind(text, offset, error);
        let example = repaired(line, &kind);
        (kind, example)
    }

    fn kind(text: &str, offset: usize, error: &toml::de::Error) -> Self {
        if let Some((key, value)) = unquoted(text, offset) {
            return Syntax::Unquoted { key: excerpt(key), value: excerpt(value) };
        }
        if assigned(text, offset)
            .is_some_and(|(_, rest)| rest.trim_start().starts_with('#') || rest.trim().is_empty())
        {
            return Syntax::NoValue;
        }
        let message = error.message();
        if message == "duplicate key" {
            let key = error.span().and_then(|span| text.get(span)).unwrap_or_default();
            return Syntax::Twice { key: excerpt(key) };
        }
        KINDS
            .iter()
            .find(|(beginning, _)| message.starts_with(beginning))
            .map(|(_, kind)| kind.clone())
            .unwrap_or_else(|| Syntax::Other(message.lines().collect::<Vec<_>>().join("; ")))
    }
}

/// How the messages of the TOML library begin, the longer beginnings first.
const KINDS: &[(&str, Syntax)] = &[
    ("unclosed inline table", Syntax::UnclosedTable),
    ("unclosed table", Syntax::UnclosedSection),
    ("unclosed array table", Syntax::UnclosedSection),
    ("unclosed array", Syntax::UnclosedList),
    ("key with no value", Syntax::NoEquals),
    ("missing value for key", Syntax::NoEquals),
    ("missing assignment", Syntax::NoEquals),
    ("missing value", Syntax::NoValue),
    ("missing key", Syntax::BadKey),
    ("invalid key-value pair", Syntax::BadKey),
    ("invalid unquoted key", Syntax::BadKey),
    ("unquoted keys cannot be empty", Syntax::BadKey),
    ("keys cannot be", Syntax::BadKey),
    ("extra comma", Syntax::Comma),
    ("missing comma", Syntax::Comma),
    ("extra assignment", Syntax::Comma),
    ("string values must be quoted", Syntax::UnquotedText),
    ("invalid string", Syntax::BadText),
    ("invalid basic string", Syntax::BadText),
    ("invalid literal string", Syntax::BadText),
    ("invalid multi-line", Syntax::BadText),
    ("missing escaped value", Syntax::BadText),
    ("too few unicode", Syntax::BadText),
    ("invalid integer", Syntax::BadNumber),
    ("invalid float", Syntax::BadNumber),
    ("unexpected leading zero", Syntax::BadNumber),
    ("redundant numeric sign", Syntax::BadNumber),
    ("`_` may only", Syntax::BadNumber),
    ("unexpected key or value", Syntax::Trailing),
    ("unexpected content", Syntax::Trailing),
    ("extra `=`", Syntax::Trailing),
    ("cannot recurse further", Syntax::TooDeep),
    ("recursion limit", Syntax::TooDeep),
];

/// What stands before and behind the `=` on the line at `offset`: the last one before that place.
fn assigned(text: &str, offset: usize) -> Option<(&str, &str)> {
    let begin = text.get(..offset)?.rfind('\n').map_or(0, |end| end + 1);
    let line = text[begin..].lines().next()?;
    // The error may lie on the value or behind it.
    let equals = line
        .match_indices('=')
        .map(|(at, _)| at)
        .take_while(|at| begin + at < offset.max(begin + 1))
        .last()
        .or_else(|| line.find('='))?;
    Some((line[..equals].trim_end(), &line[equals + 1..]))
}

/// Key and value of the assignment at `offset`, if the value is a number with something that only a
/// text may hold. The library knows such a value under many names, so the line itself is looked at.
fn unquoted(text: &str, offset: usize) -> Option<(&str, &str)> {
    let (key, rest) = assigned(text, offset)?;
    let key = &key[key.rfind(|sign| !is_of_key(sign)).map_or(0, |at| at + sign_length(key, at))..];
    let end = rest
        .char_indices()
        .find(|(at, sign)| match sign {
            '#' | '}' => true,
            // `kinetic = 0,02, static = 0,03`: only the second comma ends the value.
            ',' => begins_with_key(&rest[at + 1..]),
            _ => false,
        })
        .map_or(rest.len(), |(at, _)| at);
    let value = rest[..end].trim().trim_end_matches(',');
    let number = value.trim_start_matches(['+', '-', '.', ',']);
    let looks_like_one = number.starts_with(|sign: char| sign.is_ascii_digit())
        && !value.contains(['"', '\'', '[', ']', '{', '=']);
    let alone = format!("value = {value}");
    (looks_like_one && !key.is_empty() && DeTable::parse(&alone).is_err()).then_some((key, value))
}

fn is_of_key(sign: char) -> bool {
    sign.is_ascii_alphanumeric() || ['_', '-', '.'].contains(&sign)
}

fn sign_length(text: &str, at: usize) -> usize {
    text[at..].chars().next().map_or(1, char::len_utf8)
}

fn begins_with_key(text: &str) -> bool {
    let text = text.trim_start();
    let behind = text.trim_start_matches(is_of_key);
    text.starts_with(|sign: char| sign.is_ascii_alphabetic())
        && behind.trim_start().starts_with('=')
        || text.starts_with('}')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(text: &str) -> Syntax {
        match super::super::parse(text.as_bytes()) {
            Err(super::super::Error::Syntax { problem, .. }) => problem,
            other => panic!("{text}: {other:?}"),
        }
    }

    #[test]
    fn unquoted_quantities_are_recognised_wherever_they_stand() {
        for (text, key, value) in [
            ("[oscillator]\nmass = 300 g\nstiffness = 1", "mass", "300 g"),
            ("[oscillator]\nmass = 0,3", "mass", "0,3"),
            ("mass=0,3 kg # heavy", "mass", "0,3 kg"),
            ("a = 1\r\nmass = 300g\r\n", "mass", "300g"),
            ("mass = -.5", "mass", "-.5"),
            ("mass = 9.81 m/s^2", "mass", "9.81 m/s^2"),
            ("mass = 3 %", "mass", "3 %"),
            ("oscillator.mass = 3 g", "oscillator.mass", "3 g"),
            ("stokes = { damping = 0.2 kg/s }", "damping", "0.2 kg/s"),
            ("coulomb = { kinetic = 0,02, static = 0,03 }", "kinetic", "0,02"),
            ("coulomb = { kinetic = 0.02, static = 0,03 }", "static", "0,03"),
            ("coulomb = { kinetic = \"0,02\", static = 3 % }", "static", "3 %"),
            ("a = { k = 5 µm }", "k", "5 µm"),
        ] {
            let expected = Syntax::Unquoted { key: key.into(), value: value.into() };
            assert_eq!(kind(text), expected, "{text}");
        }
    }

    #[test]
    fn the_library_s_messages_have_their_kinds() {
        for (text, expected) in [
            ("a = 1\na = 2", Syntax::Twice { key: "a".into() }),
            ("[b]\n[b]", Syntax::Twice { key: "b".into() }),
            ("a = { b = 1, b = 2 }", Syntax::Twice { key: "b".into() }),
            ("[oscillator\nmass = 1", Syntax::UnclosedSection),
            ("a = { b = 1", Syntax::UnclosedTable),
            ("a = [1, 2", Syntax::UnclosedList),
            ("a = \"300 g", Syntax::BadText),
            ("a = '300 g", Syntax::BadText),
            ("a = \"\\q\"", Syntax::BadText),
            ("mass", Syntax::NoEquals),
            ("mass \"300 g\"", Syntax::NoEquals),
            ("mass: 3", Syntax::NoEquals),
            ("a = { b 1 }", Syntax::NoEquals),
            ("mass =", Syntax::NoValue),
            ("= 3", Syntax::BadKey),
            ("a = abc", Syntax::UnquotedText),
            ("a = { b = 1,, c = 2 }", Syntax::Comma),
            ("a = { b = 1 c = 2 }", Syntax::Comma),
            ("a = \"1\" kg", Syntax::Trailing),
            ("[a] b = 1", Syntax::Trailing),
        ] {
            assert_eq!(kind(text), expected, "{text}");
        }
    }
}
