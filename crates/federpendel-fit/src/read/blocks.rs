//! Lines of a text, as many at a time as a small buffer holds.

use std::io::ErrorKind;

use memchr::{memchr, memrchr};

use super::error::ReadError;
use super::text::Stream;

/// Longest line that is read, with its end, bytes.
pub(super) const LONGEST_LINE: usize = 1 << 20;

/// What a buffer holds at first, bytes; it grows to the longest line at most.
const BUFFER: usize = 1 << 16;

/// What comes next in a text.
pub(super) enum Block<'b> {
    /// Whole lines, at least one; the last of a text may lack its end.
    Lines(&'b [u8]),
    /// A line longer than [`LONGEST_LINE`].
    LongLine,
    /// Nothing.
    End,
}

/// Walks along a text. What is not consumed comes again.
pub(super) struct Blocks<'a> {
    stream: Box<dyn Stream + 'a>,
    end: u8,
    buffer: Vec<u8>,
    /// The part of the buffer that is not consumed.
    from: usize,
    to: usize,
    /// The byte of the text that this part begins with.
    at: u64,
    /// Nothing is left behind the buffer.
    ended: bool,
}

impl<'a> Blocks<'a> {
    /// From the byte `at` of a text, where the stream is; lines end with `end`.
    pub fn new(stream: Box<dyn Stream + 'a>, end: u8, at: u64) -> Self {
        Blocks { stream, end, buffer: vec![0; BUFFER], from: 0, to: 0, at, ended: false }
    }

    /// Where it is.
    pub fn at(&self) -> u64 {
        self.at
    }

    /// The lines from where it is.
    pub fn next(&mut self) -> Result<Block<'_>, ReadError> {
        loop {
            let ready = &self.buffer[self.from..self.to];
            let whole = memrchr(self.end, ready).map_or(0, |last| last + 1);
            match (whole, ready.len()) {
                (0, 0) if self.ended => return Ok(Block::End),
                (0, rest) if self.ended => {
                    return Ok(Block::Lines(&self.buffer[self.from..self.from + rest]));
                }
                (0, LONGEST_LINE..) => return Ok(Block::LongLine),
                (0, _) => self.fill()?,
                _ => return Ok(Block::Lines(&self.buffer[self.from..self.from + whole])),
            }
        }
    }

    pub fn consume(&mut self, bytes: usize) {
        self.from += bytes;
        self.at += bytes as u64;
    }

    /// On to this byte, unless it is behind.
    pub fn skip_to(&mut self, at: u64) -> Result<(), ReadError> {
        let (ahead, ready) = (at.saturating_sub(self.at), self.to - self.from);
        let within = ahead.min(ready as u64);
        self.consume(within as usize);
        if ahead > within {
            self.stream.skip(ahead - within)?;
            self.at = at;
        }
        Ok(())
    }

    /// On to the next line, however long this one is.
    pub fn skip_line(&mut self) -> Result<(), ReadError> {
        loop {
            let ready = &self.buffer[self.from..self.to];
            let found = memchr(self.end, ready);
            self.consume(found.map_or(ready.len(), |at| at + 1));
            if found.is_some() || self.ended {
                return Ok(());
            }
            self.fill()?;
        }
    }

    /// Fills the buffer behind what is not consumed.
    fn fill(&mut self) -> Result<(), ReadError> {
        self.buffer.copy_within(self.from..self.to, 0);
        (self.from, self.to) = (0, self.to - self.from);
        if self.to == self.buffer.len() {
            self.buffer.resize(2 * self.to, 0);
        }
        while self.to < self.buffer.len() && !self.ended {
            match self.stream.read(&mut self.buffer[self.to..]) {
                Ok(0) => self.ended = true,
                Ok(read) => self.to += read,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error.into()),
            }
        }
        Ok(())
    }
}
