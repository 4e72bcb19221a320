//! Records of an .xls and the texts in them. [MS-XLS], sections 2.1.4 and 2.5.

/// A record that goes on with the one before.
const CONTINUE: u16 = 0x3c;

/// A record, read from its front, and what follows it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Record<'a> {
    pub kind: u16,
    pub data: &'a [u8],
    pub rest: &'a [u8],
}

impl<'a> Record<'a> {
    /// The first record of a stream; none where the stream is cut off.
    pub fn first(stream: &'a [u8]) -> Option<Self> {
        let (kind, rest) = stream.split_first_chunk()?;
        let (length, rest) = rest.split_first_chunk()?;
        let (data, rest) = rest.split_at_checked(u16::from_le_bytes(*length).into())?;
        Some(Record { kind: u16::from_le_bytes(*kind), data, rest })
    }

    /// Goes over to the record that continues this one.
    fn go_on(&mut self) -> Option<()> {
        let next = Record::first(self.rest).filter(|next| next.kind == CONTINUE)?;
        *self = Record { kind: self.kind, ..next };
        Some(())
    }

    /// Whether nothing is left, in those that continue it neither.
    pub fn is_over(&mut self) -> bool {
        while self.data.is_empty() {
            if self.go_on().is_none() {
                return true;
            }
        }
        false
    }

    pub fn bytes<const COUNT: usize>(&mut self) -> Option<[u8; COUNT]> {
        let (bytes, data) = self.data.split_first_chunk()?;
        self.data = data;
        Some(*bytes)
    }

    pub fn u8(&mut self) -> Option<u8> {
        self.bytes().map(u8::from_le_bytes)
    }

    pub fn u16(&mut self) -> Option<u16> {
        self.bytes().map(u16::from_le_bytes)
    }

    pub fn u32(&mut self) -> Option<u32> {
        self.bytes().map(u32::from_le_bytes)
    }

    pub fn f64(&mut self) -> Option<f64> {
        self.bytes().map(f64::from_le_bytes)
    }

    fn skip(&mut self, mut count: usize) -> Option<()> {
        while count > 0 && !self.is_over() {
            let (_, data) = self.data.split_at(count.min(self.data.len()));
            count -= self.data.len() - data.len();
            self.data = data;
        }
        (count == 0).then_some(())
    }

    /// Adds a text of `count` signs, one byte each or, if `wide`, of UTF-16; each record that continues it says anew
    /// which. Single bytes are taken for Latin-1, which they are in BIFF8.
    pub fn signs(&mut self, count: usize, wide: bool, text: &mut String) -> Option<()> {
        let (mut left, mut wide) = (count, wide);
        let mut units = Vec::new();
        while left > 0 {
            if self.data.is_empty() {
                self.go_on()?;
                wide = self.u8()? & 1 != 0;
            }
            let width = 1 + usize::from(wide);
            let here = left.min(self.data.len() / width);
            if here == 0 {
                return None;
            }
            let (signs, data) = self.data.split_at(here * width);
            let sign = |sign: &[u8]| u16::from_le_bytes([sign[0], *sign.get(1).unwrap_or(&0)]);
            units.extend(signs.chunks(width).map(sign));
            (self.data, left) = (data, left - here);
        }
        let signs = char::decode_utf16(units);
        text.extend(signs.map(|sign| sign.unwrap_or(char::REPLACEMENT_CHARACTER)));
        Some(())
    }

    /// Adds a text with its flags in front, as texts that cells share have them: what they say of its looks and how it is
    /// spoken follows, and is left out.
    pub fn rich_text(&mut self, text: &mut String) -> Option<()> {
        let count = self.u16()?.into();
        let flags = self.u8()?;
        let runs = if flags & 8 != 0 { self.u16()? } else { 0 };
        let spoken = if flags & 4 != 0 { self.u32()? } else { 0 };
        self.signs(count, flags & 1 != 0, text)?;
        self.skip(4 * usize::from(runs))?;
        self.skip(spoken as usize)
    }
}
