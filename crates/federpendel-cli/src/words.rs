//! What is wrong, in the user's language: field, value, what is allowed.

mod experiment;
mod remark;
mod samples;
mod syntax;
mod too_long;

pub use experiment::experiment_error;
pub use federpendel_quantity::words::{allowed, flag, flag_value, flag_value_of, quantity_problem};
pub(crate) use remark::remark;
pub(crate) use samples::samples_fault;
pub(crate) use too_long::too_long_step;

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
