//! Short forms for tests of the reader.
#![allow(dead_code)]

use federpendel_fit::read::{Choice, ColumnName, Read, ReadError, recordings};

/// The only recording of a text.
#[track_caller]
pub fn read(text: &str) -> Read {
    read_with(text, &Choice::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The only recording of a text, under a choice.
#[track_caller]
pub fn read_with(text: &str, choice: &Choice) -> Result<Read, ReadError> {
    let mut all = recordings(text.as_bytes(), choice)?;
    assert_eq!(all.len(), 1, "{text}");
    Ok(all.remove(0))
}

/// Why a text is refused.
#[track_caller]
pub fn fails(text: &str) -> ReadError {
    match recordings(text.as_bytes(), &Choice::default()) {
        Ok(read) => panic!("read as {read:?}\n{text}"),
        Err(error) => error,
    }
}

/// The heading of the value.
pub fn label(read: &Read) -> &str {
    &read.value.label
}

/// Headings of columns.
pub fn labels(columns: &[ColumnName]) -> Vec<&str> {
    columns.iter().map(|column| column.label.as_str()).collect()
}
