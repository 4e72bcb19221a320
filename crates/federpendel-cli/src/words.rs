//! What is wrong, in the user's language: field, value, what is allowed.

mod experiment;
mod quantity;
mod remark;
mod syntax;
mod too_long;

pub use experiment::experiment_error;
pub use quantity::{allowed, flag_value, quantity_problem};
pub(crate) use remark::remark;
pub(crate) use too_long::too_long_step;

/// Longest part of what a user wrote that a message repeats, characters.
const LONGEST_EXCERPT: usize = 60;

/// What a user wrote, in one line and shortened, for a message.
pub(crate) fn excerpt(text: &str) -> String {
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let mut short: String = line.chars().take(LONGEST_EXCERPT).collect();
    if short.len() < line.len() {
        short.push('…');
    }
    short
}
