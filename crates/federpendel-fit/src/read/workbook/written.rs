//! The text of the cells of an .xlsx. ECMA-376, part 1, sections 18.3 and 18.4.

use super::xml::{Part, unescape};

/// What is written in elements of one name, put together, without how words are to be spoken.
#[derive(Default)]
pub(super) struct Written {
    element: &'static str,
    pub text: String,
    /// Where the text of the element begins that is read now.
    within: Option<usize>,
    /// Whether blanks around it count.
    blanks: bool,
    spoken: bool,
}

impl Written {
    /// Begins anew, with elements of this name.
    pub fn clear(&mut self, element: &'static str) {
        (self.element, self.within) = (element, None);
        self.text.clear();
    }

    pub fn take(&mut self, part: Part) {
        match part {
            Part::Start("rPh", _) => self.spoken = true,
            Part::End("rPh") => self.spoken = false,
            Part::Start(name, mut attributes) if name == self.element && !self.spoken => {
                self.within = Some(self.text.len());
                self.blanks =
                    attributes.any(|(name, value)| name == "space" && value == "preserve");
            }
            Part::End(name) if name == self.element => self.end(),
            Part::Text(text) if self.within.is_some() => self.text.push_str(&unescape(text)),
            Part::Plain(text) if self.within.is_some() => self.text.push_str(text),
            _ => {}
        }
    }

    fn end(&mut self) {
        let Some(from) = self.within.take() else { return };
        let whole = &self.text[from..];
        let text = if self.blanks { whole } else { whole.trim_matches([' ', '\t', '\r', '\n']) };
        if text.len() < whole.len() || text.contains("_x") {
            let text = characters(text);
            self.text.truncate(from);
            self.text.push_str(&text);
        }
    }
}

/// Signs that XML cannot hold are written as `_x000D_`. ECMA-376, part 1, section 22.9.2.19.
fn characters(text: &str) -> String {
    let (mut plain, mut rest) = (String::new(), text);
    while let Some(at) = rest.find("_x") {
        let (before, from) = rest.split_at(at);
        plain.push_str(before);
        let code = from.get(2..7).and_then(|code| code.strip_suffix('_'));
        let code = code.and_then(|code| u32::from_str_radix(code, 16).ok());
        let (sign, length) = match code {
            Some(code) => (char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER), 7),
            None => ('_', 1),
        };
        plain.push(sign);
        rest = &from[length..];
    }
    plain + rest
}
