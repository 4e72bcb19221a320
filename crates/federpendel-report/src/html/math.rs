//! Texts with formulas in the notation of TeX, as HTML with MathML, which browsers set themselves.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use minijinja::{HtmlEscape, Value};

use super::PageError;

/// What must not begin a line by itself, behind a formula.
const CLOSING: [char; 6] = [')', ',', '.', ':', ';', '!'];

/// Stands for a dollar sign that begins no formula while the formulas are looked for; no text holds it.
const DOLLAR: &str = "\u{0}";

/// A text that is HTML already.
pub type Html = Value;

/// Sets formulas.
#[derive(Default)]
pub struct Typesetter(LatexToMathML);

impl Typesetter {
    /// Without macros and with every unknown command an error.
    pub fn new() -> Result<Self, PageError> {
        let plain = LatexToMathML::new(MathCoreConfig::default());
        plain.map(Self).map_err(|(error, _, tex)| failure(&tex, &error))
    }

    /// `text`, in which formulas stand between dollar signs.
    pub fn text(&self, text: &str) -> Result<Html, PageError> {
        Ok(Value::from_safe_string(self.markup(text)?))
    }

    /// A formula on a line of its own.
    pub fn formula(&self, tex: &str) -> Result<Html, PageError> {
        Ok(Value::from_safe_string(self.mathml(tex, MathDisplay::Block)?))
    }

    /// `text` where no markup can stand: what its formulas say, letter by letter.
    pub fn plain(&self, text: &str) -> Result<Html, PageError> {
        let markup = self.markup(text)?;
        let mut pieces = markup.split('<');
        let first = pieces.next().unwrap_or_default().to_owned();
        let rest = pieces.filter_map(|piece| Some(piece.split_once('>')?.1));
        Ok(Value::from_safe_string(first + &rest.collect::<String>()))
    }

    fn markup(&self, text: &str) -> Result<String, PageError> {
        let marked = text.replace(r"\$", DOLLAR);
        let pieces: Vec<_> = marked.split('$').collect();
        if pieces.len() % 2 == 0 {
            return Err(PageError::Dollar(text.to_owned()));
        }
        let mut markup = String::new();
        // What a formula has taken of the text behind it.
        let mut taken = 0;
        for (place, piece) in pieces.iter().enumerate() {
            if place % 2 == 0 {
                markup += &HtmlEscape(&unbroken(&piece[taken..])).to_string();
            } else {
                let behind = pieces.get(place + 1).copied().unwrap_or_default();
                taken = behind.len() - behind.trim_start_matches(CLOSING).len();
                let math = self.mathml(piece, MathDisplay::Inline)?;
                markup += &match taken {
                    0 => math,
                    _ => format!("<span class=\"joined\">{math}{}</span>", &behind[..taken]),
                };
            }
        }
        Ok(markup.replace(DOLLAR, "$"))
    }

    fn mathml(&self, tex: &str, display: MathDisplay) -> Result<String, PageError> {
        let set = self.0.convert_with_local_state(tex, display);
        let mathml = set.map_err(|error| failure(tex, &error))?.mathml;
        // `0{,}5` comes out as two numbers and a comma; it is one number to whoever hears it read.
        Ok(mathml.replace("</mn><mo rspace=\"0\">,</mo><mn>", ","))
    }
}

/// `text` with every number on the line of its unit, of its power of ten and of its error.
fn unbroken(text: &str) -> String {
    let mut before = None;
    let mut signs = text.chars().peekable();
    let mut unbroken = String::with_capacity(text.len());
    while let Some(sign) = signs.next() {
        let joins = match before {
            Some('×' | '±') => true,
            Some(last) => {
                last.is_numeric()
                    && signs
                        .peek()
                        .is_some_and(|next| next.is_alphabetic() || matches!(next, '×' | '±'))
            }
            None => false,
        };
        unbroken.push(if sign == ' ' && joins { '\u{a0}' } else { sign });
        before = Some(sign);
    }
    unbroken
}

fn failure(tex: &str, error: &math_core::LatexError) -> PageError {
    PageError::Formula { tex: tex.to_owned(), reason: error.to_string() }
}
