//! The encoding of a text, told from its first bytes, and UTF-16 turned into UTF-8.

use std::io::{self, Read};

use super::error::{Found, ReadError};
use super::line::excerpt;
use super::text::{Stream, read_past};

/// First bytes of files that are no tables.
const MAGIC: &[(&[u8], Found)] = &[
    (b"\x89PNG", Found::Picture),
    (b"\xff\xd8\xff", Found::Picture),
    (b"GIF8", Found::Picture),
    (b"%PDF", Found::Pdf),
    (b"\x1f\x8b", Found::Gzip),
    (b"RIFF", Found::Media),
    (b"\x89HDF", Found::Hdf5),
    (b"MATLAB 5", Found::Hdf5),
];

/// Makes a unit of UTF-16 of two bytes.
type Unit = fn([u8; 2]) -> u16;

/// How a text is encoded.
#[derive(Debug, Clone, Copy)]
pub(super) struct Encoding {
    /// Bytes before the text that tell its encoding.
    pub mark: u64,
    /// UTF-16, if it is; else an encoding that has ASCII in it.
    pub wide: Option<Unit>,
}

impl Encoding {
    pub const PLAIN: Encoding = Encoding { mark: 0, wide: None };

    /// The encoding of a text that begins so.
    pub fn of(bytes: &[u8]) -> Result<Self, ReadError> {
        let refused = |found| Err(ReadError::NoTable { found, line: 1, text: excerpt(bytes) });
        if let Some((_, found)) = MAGIC.iter().find(|(magic, _)| bytes.starts_with(magic)) {
            return refused(*found);
        }
        let wide = |mark, unit: Unit| Ok(Encoding { mark, wide: Some(unit) });
        match bytes {
            [0xef, 0xbb, 0xbf, ..] => return Ok(Encoding { mark: 3, wide: None }),
            [0xff, 0xfe, ..] => return wide(2, u16::from_le_bytes),
            [0xfe, 0xff, ..] => return wide(2, u16::from_be_bytes),
            [first, 0, second, 0, ..] if *first != 0 && *second != 0 => {
                return wide(0, u16::from_le_bytes);
            }
            [0, first, 0, second, ..] if *first != 0 && *second != 0 => {
                return wide(0, u16::from_be_bytes);
            }
            _ => {}
        }
        let start = &bytes[..bytes.len().min(1 << 16)];
        let control = |byte: &&u8| matches!(byte, 0..=8 | 14..=26 | 28..=31);
        if start.contains(&0) || start.iter().filter(control).count() * 20 > start.len() {
            return refused(Found::Binary);
        }
        match start.trim_ascii_start() {
            [b'<', ..] => refused(Found::Xml),
            [b'{', ..] | [b'[', b'{' | b'[' | b'\n', ..] => refused(Found::Json),
            _ => Ok(Encoding::PLAIN),
        }
    }
}

/// UTF-16 read as UTF-8, with U+FFFD for what is no character.
pub(super) struct Utf16<'a> {
    stream: Box<dyn Stream + 'a>,
    unit: Unit,
    /// What is decoded, and how much of it is handed out.
    text: Vec<u8>,
    given: usize,
    /// The first half of a character whose other half is not read yet.
    half: Option<u16>,
}

impl<'a> Utf16<'a> {
    pub fn new(stream: Box<dyn Stream + 'a>, unit: Unit) -> Self {
        Utf16 { stream, unit, text: Vec::new(), given: 0, half: None }
    }

    /// Decodes some more; nothing at the end, where a byte without a second is left out.
    fn decode(&mut self) -> io::Result<()> {
        const BYTES: u64 = 1 << 14;
        let mut bytes = Vec::with_capacity(BYTES as usize);
        (&mut self.stream).take(BYTES).read_to_end(&mut bytes)?;
        let (pairs, _) = bytes.as_chunks::<2>();
        let mut units: Vec<u16> = self.half.take().into_iter().collect();
        units.extend(pairs.iter().map(|pair| (self.unit)(*pair)));
        if bytes.len() as u64 == BYTES {
            self.half = units.pop_if(|unit| (0xd800..0xdc00).contains(unit));
        }
        self.given = 0;
        self.text = match units
            .iter()
            .map(|unit| u8::try_from(*unit).ok().filter(u8::is_ascii))
            .collect()
        {
            // Numbers are nothing else; this is several times as fast.
            Some(ascii) => ascii,
            None => String::from_utf16_lossy(&units).into_bytes(),
        };
        Ok(())
    }
}

impl Read for Utf16<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.given == self.text.len() {
            self.decode()?;
        }
        let read = (&self.text[self.given..]).read(buffer)?;
        self.given += read;
        Ok(read)
    }
}

impl Stream for Utf16<'_> {
    fn skip(&mut self, bytes: u64) -> io::Result<()> {
        read_past(self, bytes)
    }
}
