//! What a user wrote, as a message repeats it.

/// Longest part that a message repeats, characters.
const LONGEST: usize = 60;

/// What a user wrote, in one line and shortened.
pub fn excerpt(text: &str) -> String {
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let mut short: String = line.chars().take(LONGEST).collect();
    if short.len() < line.len() {
        short.push('…');
    }
    short
}
