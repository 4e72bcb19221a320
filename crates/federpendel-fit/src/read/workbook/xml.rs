//! XML as workbooks hold it: elements with attributes and the text in them, in UTF-8. What declares, comments or instructs
//! is left out, and names lose their prefixes.

use std::borrow::Cow;
use std::io::BufRead;

use super::{ReadError, damaged};

/// A part of a document.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Part<'a> {
    Start(&'a str, Attributes<'a>),
    End(&'a str),
    /// Text, as it stands in the document.
    Text(&'a str),
    /// Text without entities.
    Plain(&'a str),
}

/// The attributes of an element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Attributes<'a>(&'a str);

/// Walks through a document until `take` has enough. An element without content begins and ends.
pub(super) fn walk(
    input: &mut dyn BufRead,
    take: &mut dyn FnMut(Part) -> Result<bool, ReadError>,
) -> Result<(), ReadError> {
    let mut bytes = Vec::new();
    loop {
        bytes.clear();
        until(input, b'<', &mut bytes)?;
        if !bytes.is_empty() && !take(Part::Text(utf8(&bytes)?))? {
            return Ok(());
        }
        bytes.clear();
        markup(input, &mut bytes)?;
        if !told(utf8(&bytes)?, take)? {
            return Ok(());
        }
    }
}

/// Tells what stands between brackets; says whether more is wanted.
fn told(
    markup: &str,
    take: &mut dyn FnMut(Part) -> Result<bool, ReadError>,
) -> Result<bool, ReadError> {
    match markup.as_bytes() {
        [b'!', ..] => markup
            .strip_prefix(CDATA)
            .map_or(Ok(true), |text| take(Part::Plain(&text[..text.len() - 2]))),
        [b'?', ..] => Ok(true),
        [b'/', ..] => take(Part::End(local(markup[1..].trim_end()))),
        _ => {
            let element = markup.strip_suffix('/').unwrap_or(markup);
            let end = element.find(|sign: char| sign.is_ascii_whitespace());
            let (name, attributes) = element.split_at(end.unwrap_or(element.len()));
            let (name, empty) = (local(name), element.len() < markup.len());
            Ok(take(Part::Start(name, Attributes(attributes)))?
                && (!empty || take(Part::End(name))?))
        }
    }
}

/// How text begins that has no entities.
const CDATA: &str = "![CDATA[";

/// Reads on to a byte and leaves it out.
fn until(input: &mut dyn BufRead, end: u8, bytes: &mut Vec<u8>) -> Result<(), ReadError> {
    let read = input.read_until(end, bytes).map_err(damaged)?;
    match bytes.pop_if(|last| read > 0 && *last == end) {
        Some(_) => Ok(()),
        None => Err(damaged("XML cut off")),
    }
}

fn utf8(bytes: &[u8]) -> Result<&str, ReadError> {
    std::str::from_utf8(bytes).map_err(|_| damaged("no UTF-8"))
}

/// Reads on to the bracket that ends markup: not one in a comment, in text without entities or in quotes.
fn markup(input: &mut dyn BufRead, bytes: &mut Vec<u8>) -> Result<(), ReadError> {
    let mut quote = 0;
    loop {
        let from = bytes.len();
        until(input, b'>', bytes)?;
        let open = match bytes.as_slice() {
            [b'!', b'-', b'-', rest @ ..] => !rest.ends_with(b"--"),
            [b'!', ..] if bytes.starts_with(CDATA.as_bytes()) => !bytes.ends_with(b"]]"),
            [b'!' | b'?', ..] => false,
            _ => {
                for byte in &bytes[from..] {
                    match byte {
                        b'"' | b'\'' if quote == 0 => quote = *byte,
                        byte if *byte == quote => quote = 0,
                        _ => {}
                    }
                }
                quote != 0
            }
        };
        if !open {
            return Ok(());
        }
        bytes.push(b'>');
    }
}

fn local(name: &str) -> &str {
    name.rsplit(':').next().unwrap_or(name)
}

impl<'a> Iterator for Attributes<'a> {
    type Item = (&'a str, Cow<'a, str>);

    fn next(&mut self) -> Option<Self::Item> {
        let (name, rest) = self.0.split_once('=')?;
        let rest = rest.trim_ascii_start();
        let quote = rest.chars().next().filter(|sign| matches!(sign, '"' | '\''))?;
        let (value, rest) = rest[1..].split_once(quote)?;
        self.0 = rest;
        Some((local(name.trim_ascii()), unescape(value)))
    }
}

/// A text with signs for its entities, of which those stay as they are that XML does not know, and with the ends of
/// lines that XML has.
pub(super) fn unescape(text: &str) -> Cow<'_, str> {
    if !text.contains(['&', '\r']) {
        return text.into();
    }
    let text = text.replace("\r\n", "\n");
    let mut parts = text.split('&');
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(';').and_then(|(name, rest)| Some((entity(name)?, rest))) {
            Some((sign, rest)) => {
                plain.push(sign);
                plain.push_str(rest);
            }
            None => {
                plain.push('&');
                plain.push_str(part);
            }
        }
    }
    plain.into()
}

fn entity(name: &str) -> Option<char> {
    match name {
        "lt" => Some('<'),
        "gt" => Some('>'),
        "amp" => Some('&'),
        "quot" => Some('"'),
        "apos" => Some('\''),
        _ => {
            let number = name.strip_prefix('#')?;
            let number = match number.strip_prefix('x') {
                Some(number) => u32::from_str_radix(number, 16),
                None => number.parse(),
            };
            char::from_u32(number.ok()?)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(document: &str) -> (Vec<String>, Option<ReadError>) {
        let mut parts = Vec::new();
        let walked = walk(&mut document.as_bytes(), &mut |part| {
            parts.push(match part {
                Part::Start(name, attributes) => {
                    format!("<{name} {:?}>", attributes.collect::<Vec<_>>())
                }
                Part::End(name) => format!("</{name}>"),
                Part::Text(text) => unescape(text).into_owned(),
                Part::Plain(text) => text.to_owned(),
            });
            Ok(part != Part::End("a"))
        });
        (parts, walked.err())
    }

    #[test]
    fn documents_in_parts() {
        let document = "<?xml version='1.0' it's ?><!-- it's <b> -- > --><x:a  r:id = \"1 > '0'\" u='&lt;&#x41;&#66;\"'>\
            é &amp; &quot;&nbsp;<b/><c d=\"\" /><![CDATA[<&amp;]]></x:a ><z>";
        let parts = [
            "<a [(\"id\", \"1 > '0'\"), (\"u\", \"<AB\\\"\")]>",
            "é & \"&nbsp;",
            "<b []>",
            "</b>",
            "<c [(\"d\", \"\")]>",
            "</c>",
            "<&amp;",
            "</a>",
        ];
        assert_eq!(told(document), (parts.map(str::to_owned).to_vec(), None));
    }

    #[test]
    fn documents_that_are_cut_off() {
        for document in
            ["", "<", "<a", "<a><b></b>", "<a b=\"></a>", "<!-- <a></a>", "<a><![CDATA[</a>]>"]
        {
            let (_, error) = told(document);
            assert_eq!(error, Some(damaged("XML cut off")), "{document}");
        }
        assert!(told("<a>\u{e9}</a>").1.is_none());
        assert!(walk(&mut &b"<a>\xe9</a>"[..], &mut |_| Ok(true)).is_err());
    }
}
