//! Experiment files: TOML, walked by hand so that every message can name field, value and line.

use std::ops::Range;

use federpendel_text::excerpt;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Allowed, Draft, Error, Field, Origin, Syntax};

/// Largest experiment file that is read, bytes.
pub const LARGEST_FILE: usize = 1 << 20;

/// Reads the bytes of an experiment file.
///
/// # Errors
/// What is wrong with the file itself, its keys or its values; not yet whether they fit together.
pub fn parse(bytes: &[u8]) -> Result<Draft, Error> {
    if bytes.len() > LARGEST_FILE {
        return Err(Error::TooLarge);
    }
    let text = std::str::from_utf8(bytes)
        .map_err(|error| Error::NotUtf8 { offset: error.valid_up_to() })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let root = DeTable::parse(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        let line = line_at(text, at);
        let (problem, example) = Syntax::of(text, at, line, &error);
        Error::Syntax { line, problem, example }
    })?;
    if root.get_ref().is_empty() {
        return Err(Error::EmptyFile);
    }
    let mut reader = Reader { text, draft: Draft::default() };
    reader.table(root.get_ref(), "")?;
    Ok(reader.draft)
}

struct Reader<'a> {
    text: &'a str,
    draft: Draft,
}

impl Reader<'_> {
    /// Reads a table whose keys continue `prefix` ("", "friction.", "friction.coulomb.").
    fn table(&mut self, table: &DeTable<'_>, prefix: &str) -> Result<(), Error> {
        for (key, value) in table {
            let path = format!("{prefix}{}", key.get_ref());
            let inner = format!("{path}.");
            if let Some(field) = Field::at(&path) {
                self.field(field, value)?;
            } else if Field::ALL.iter().any(|field| field.path().starts_with(&inner)) {
                self.section(&inner, value)?;
            } else {
                let line = line_at(self.text, key.span().start);
                return Err(unknown_key(excerpt(key.get_ref()), prefix, line));
            }
        }
        Ok(())
    }

    fn section(&mut self, prefix: &str, value: &Spanned<DeValue<'_>>) -> Result<(), Error> {
        let path = prefix.trim_end_matches('.');
        let Some(table) = value.get_ref().as_table() else {
            return Err(self.wrong_type(path, value.span(), Allowed::Keys(keys_of(prefix))));
        };
        if table.is_empty() && prefix.matches('.').count() > 1 {
            // "stokes = {}" names a law and says nothing about it.
            let written = "{}".to_owned();
            let allowed = Allowed::Keys(keys_of(prefix));
            let line = line_at(self.text, value.span().start);
            return Err(Error::WrongType { path: path.to_owned(), line, written, allowed });
        }
        self.table(table, prefix)
    }

    fn field(&mut self, field: Field, value: &Spanned<DeValue<'_>>) -> Result<(), Error> {
        let quantity = match value.get_ref() {
            DeValue::String(text) => text.to_string(),
            DeValue::Float(float) => float.as_str().to_owned(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().to_owned(),
            _ => {
                let allowed = Allowed::Quantity(field);
                return Err(self.wrong_type(field.path(), value.span(), allowed));
            }
        };
        let line = line_at(self.text, value.span().start);
        let written = self.excerpt(value.span());
        self.draft.set(field, &quantity, written, Origin::File { line })
    }

    fn wrong_type(&self, path: &str, span: Range<usize>, allowed: Allowed) -> Error {
        let line = line_at(self.text, span.start);
        Error::WrongType { path: path.to_owned(), line, written: self.excerpt(span), allowed }
    }

    fn excerpt(&self, span: Range<usize>) -> String {
        excerpt(self.text.get(span).unwrap_or_default())
    }
}

fn line_at(text: &str, offset: usize) -> usize {
    1 + text.bytes().take(offset).filter(|byte| *byte == b'\n').count()
}

/// The keys that may stand in the table `prefix`.
fn keys_of(prefix: &str) -> Vec<&'static str> {
    let mut keys: Vec<_> = Field::ALL
        .iter()
        .filter_map(|field| field.path().strip_prefix(prefix))
        .map(|rest| rest.split('.').next().unwrap_or(rest))
        .collect();
    keys.dedup();
    keys
}

fn unknown_key(key: String, prefix: &str, line: usize) -> Error {
    let allowed = keys_of(prefix);
    // The nearest spelling in this section first, then the same key in another.
    let elsewhere = Field::ALL
        .iter()
        .map(|field| field.path())
        .find(|path| path.rsplit('.').next() == Some(&key) || path.ends_with(&format!(".{key}")));
    let near = allowed
        .iter()
        .map(|known| (strsim::jaro_winkler(known, &key.to_lowercase()), *known))
        .filter(|(likeness, _)| *likeness > 0.75)
        .max_by(|(a, _), (b, _)| a.total_cmp(b));
    let nearest = near.map(|(_, known)| format!("{prefix}{known}"));
    let nearest = nearest.or_else(|| elsewhere.map(str::to_owned));
    Error::UnknownKey { path: format!("{prefix}{key}"), line, nearest, allowed }
}
