//! Excel workbooks, their sheets and the cells in them, and nothing else that they hold.
//!
//! A library for all that workbooks hold brings the tables of all encodings, more than the whole page has room for; this
//! reads what a sheet of numbers needs, never more than [`LARGEST_UNPACKED`] at a time, and the tests hold it to that library.

mod biff;
mod compound;
mod format;
mod written;
mod xls;
mod xlsx;
mod xml;

use std::fmt::Display;

use super::LARGEST_UNPACKED;
use super::error::ReadError;

pub(super) use xls::Xls;
pub(super) use xlsx::Xlsx;

/// What a cell holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Value<'a> {
    Number(f64),
    /// Days since the last day of 1899, or a duration in days.
    Time {
        days: f64,
        duration: bool,
    },
    Text(&'a str),
    Truth(bool),
    /// A formula has no result.
    Error,
}

/// Takes a cell at its row and column, from 0; says whether it wants more.
pub(super) type Take<'a> = dyn FnMut(u32, u32, Value) -> Result<bool, ReadError> + 'a;

/// A workbook.
pub(super) trait Book {
    /// The names of its sheets.
    fn sheets(&self) -> Vec<String>;

    /// Hands out the cells of a sheet that hold something, row after row.
    fn cells(&mut self, sheet: &str, take: &mut Take) -> Result<(), ReadError>;
}

fn damaged(reason: impl Display) -> ReadError {
    ReadError::Damaged { reason: reason.to_string() }
}

/// Texts that cells share, one behind the other: a workbook may have millions of them.
#[derive(Debug, Default)]
struct Texts {
    text: String,
    ends: Vec<usize>,
}

impl Texts {
    /// What has been written to `text` since the last is one more.
    fn end(&mut self) -> Result<(), ReadError> {
        self.ends.push(self.text.len());
        let (bytes, most) = (self.text.len() as u64, LARGEST_UNPACKED);
        if bytes > most { Err(ReadError::TooLarge { bytes, most }) } else { Ok(()) }
    }

    fn get(&self, at: usize) -> Option<&str> {
        let from = if at == 0 { 0 } else { *self.ends.get(at - 1)? };
        self.text.get(from..*self.ends.get(at)?)
    }
}

#[cfg(test)]
mod tests;
