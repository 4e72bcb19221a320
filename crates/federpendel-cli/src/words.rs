//! What is wrong, in the user's language: field, value, what is allowed.

mod experiment;
mod fit;
mod quantity;
mod remark;
mod samples;
mod syntax;
mod too_long;

pub use experiment::experiment_error;
pub use fit::{edge, fit_error, read_error, read_note};
pub use quantity::{allowed, flag_value, quantity_problem};
pub(crate) use remark::remark;
pub(crate) use samples::samples_fault;
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

/// Least likeness of two words (Jaro and Winkler) of which one is taken for the other's misspelling.
const LIKE: f64 = 0.8;

/// The one of `known` of which `word` looks like a misspelling.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    known
        .into_iter()
        .map(|known| (strsim::jaro_winkler(known, &word.to_lowercase()), known))
        .filter(|(likeness, _)| *likeness > LIKE)
        .max_by(|(a, _), (b, _)| a.total_cmp(b))
        .map(|(_, known)| known.to_owned())
}
