//! What a user wrote, as a message repeats it.

/// Longest part that a message repeats, characters.
const LONGEST: usize = 60;

/// What a user wrote, in one line and shortened.
pub fn excerpt(text: &str) -> String {
    let line = plain(text);
    let mut short: String = line.chars().take(LONGEST).collect();
    if short.len() < line.len() {
        short.push('…');
    }
    short
}

/// A text, a file's name perhaps, in one line: blanks for what a terminal would obey, and for what turns the direction of
/// writing.
pub fn plain(text: &str) -> String {
    let obeyed = |c: char| {
        c.is_control()
            || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    text.chars().map(|c| if obeyed(c) { ' ' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_left_to_obey() {
        assert_eq!(plain("a\u{1b}[31m\nb\u{202e}c ä"), "a [31m b c ä");
        assert_eq!(excerpt(&"x".repeat(100)).chars().count(), LONGEST + 1);
    }
}
