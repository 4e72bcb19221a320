//! Lines and the cells in them, without copying.

use memchr::memchr;

use super::number;

/// What stands between the cells of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Separator {
    /// A tab.
    Tab,
    /// A semicolon.
    Semicolon,
    /// A comma.
    Comma,
    /// Blanks, as many as there are.
    Space,
}

impl Separator {
    /// All of them, the least likely to stand within a cell first.
    pub const ALL: [Separator; 4] =
        [Separator::Tab, Separator::Semicolon, Separator::Comma, Separator::Space];

    fn byte(self) -> Option<u8> {
        match self {
            Separator::Tab => Some(b'\t'),
            Separator::Semicolon => Some(b';'),
            Separator::Comma => Some(b','),
            Separator::Space => None,
        }
    }
}

/// The byte that ends lines: a carriage return in old files of the Macintosh, else a line feed.
pub(super) fn line_end(bytes: &[u8]) -> u8 {
    if memchr(b'\n', bytes).is_none() && memchr(b'\r', bytes).is_some() { b'\r' } else { b'\n' }
}

/// A line and where it stands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    /// From 1.
    pub number: usize,
    /// Its first byte.
    pub start: usize,
    /// Without its end.
    pub text: &'a [u8],
    /// Whether an end follows.
    pub ended: bool,
}

impl Line<'_> {
    /// Nothing but blanks and separators.
    pub fn is_blank(&self) -> bool {
        self.text
            .iter()
            .all(|byte| byte.is_ascii_whitespace() || matches!(byte, b';' | b',' | b'"'))
    }

    /// Begins with a sign of a comment.
    pub fn is_comment(&self) -> bool {
        let text = self.text.trim_ascii_start();
        matches!(text, [b'#' | b'%', ..] | [b'/', b'/', ..])
            && !(text[0] == b'#' && number::begins_missing(text))
    }
}

/// Walks along lines.
#[derive(Debug, Clone)]
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    end: u8,
    at: usize,
    number: usize,
}

impl<'a> Lines<'a> {
    /// From the byte `at`, which begins the line of this number.
    pub fn new(bytes: &'a [u8], end: u8, at: usize, number: usize) -> Self {
        Lines { bytes, end, at, number }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    #[inline]
    fn next(&mut self) -> Option<Line<'a>> {
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        let found = memchr(self.end, rest);
        let text = &rest[..found.unwrap_or(rest.len())];
        let line = Line {
            number: self.number,
            start: self.at,
            text: text.strip_suffix(b"\r").unwrap_or(text),
            ended: found.is_some(),
        };
        self.at += text.len() + 1;
        self.number += 1;
        Some(line)
    }
}

/// The cells of a line: without blanks around them and without their quotes.
#[derive(Debug, Clone)]
pub(super) struct Cells<'a> {
    rest: Option<&'a [u8]>,
    separator: Option<u8>,
}

impl<'a> Cells<'a> {
    pub fn new(line: &'a [u8], separator: Separator) -> Self {
        Cells { rest: Some(line), separator: separator.byte() }
    }

    /// A cell in quotes: up to the quote that ends it.
    fn quoted(&mut self, text: &'a [u8]) -> &'a [u8] {
        let mut close = 0;
        while let Some(found) = memchr(b'"', &text[close..]) {
            close += found;
            if text.get(close + 1) != Some(&b'"') {
                break;
            }
            close += 2;
        }
        let close = if text.get(close) == Some(&b'"') { close } else { text.len() };
        let after = text.get(close + 1..).unwrap_or_default();
        self.rest = match self.separator {
            Some(byte) => memchr(byte, after).map(|at| &after[at + 1..]),
            None => Some(after),
        };
        text[..close].trim_ascii()
    }
}

impl<'a> Iterator for Cells<'a> {
    type Item = &'a [u8];

    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest?;
        let Some(separator) = self.separator else {
            let rest = rest.trim_ascii();
            return match rest {
                [] => None,
                [b'"', inner @ ..] => Some(self.quoted(inner)),
                _ => {
                    let end =
                        rest.iter().position(|b| b.is_ascii_whitespace()).unwrap_or(rest.len());
                    let (cell, rest) = rest.split_at(end);
                    self.rest = Some(rest);
                    Some(cell)
                }
            };
        };
        if let [first, ..] = rest
            && (*first == b'"' || first.is_ascii_whitespace())
        {
            // A tab that separates is no blank.
            let blank = |byte: &&u8| **byte != separator && byte.is_ascii_whitespace();
            let blanks = rest.iter().take_while(blank).count();
            if let [b'"', inner @ ..] = &rest[blanks..] {
                return Some(self.quoted(inner));
            }
        }
        let (cell, after) = match memchr(separator, rest) {
            Some(at) => (&rest[..at], Some(&rest[at + 1..])),
            None => (rest, None),
        };
        self.rest = after;
        Some(cell.trim_ascii())
    }
}

/// Text of a cell or line: UTF-8, else Latin-1.
pub(super) fn decode(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => plain(text.chars()),
        Err(_) => plain(bytes.iter().map(|byte| char::from(*byte))),
    }
}

/// A text without what a terminal would obey: blanks for control characters. Tabs stay, which may separate.
pub(super) fn plain(text: impl Iterator<Item = char>) -> String {
    text.map(|c| if c.is_control() && c != '\t' { ' ' } else { c }).collect()
}

/// The beginning of a text, as errors quote it: printable, on one line.
pub(super) fn excerpt(bytes: &[u8]) -> String {
    const MOST: usize = 60;
    let text = decode(&bytes[..bytes.len().min(4 * MOST)]);
    let text = text.trim().replace('\t', " ");
    let mut short: String = text.chars().take(MOST).collect();
    if text.chars().count() > MOST {
        short.push('…');
    }
    short
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(line: &str, separator: Separator) -> Vec<String> {
        Cells::new(line.as_bytes(), separator).map(decode).collect()
    }

    #[test]
    fn cells_of_every_kind() {
        use Separator::*;
        assert_eq!(
            cells(r#""Time (s)","a ""x"", b",3"#, Comma),
            ["Time (s)", r#"a ""x"", b"#, "3"]
        );
        assert_eq!(cells("1\t\t 3\t", Tab), ["1", "", "3", ""]);
        assert_eq!(cells("\t2", Tab), ["", "2"]);
        assert_eq!(cells("  1   2\t3 ", Space), ["1", "2", "3"]);
        assert_eq!(cells(r#" "0,1" ; "0,2""#, Semicolon), ["0,1", "0,2"]);
        assert_eq!(cells(r#"5" 1/2,2"#, Comma), [r#"5" 1/2"#, "2"]);
        assert_eq!(cells(r#""open,2"#, Comma), ["open,2"]);
        assert_eq!(cells(r#""a" "b c" d"#, Space), ["a", "b c", "d"]);
        assert_eq!(cells("", Comma), [""]);
    }

    #[test]
    fn lines_of_every_system() {
        for text in ["a\nb\n\nc", "a\r\nb\r\n\r\nc", "a\rb\r\rc"] {
            let end = line_end(text.as_bytes());
            let lines: Vec<_> = Lines::new(text.as_bytes(), end, 0, 1)
                .map(|l| (l.number, decode(l.text)))
                .collect();
            let expected = [(1, "a"), (2, "b"), (3, ""), (4, "c")].map(|(n, t)| (n, t.to_owned()));
            assert_eq!(lines, expected, "{text:?}");
        }
    }
}
