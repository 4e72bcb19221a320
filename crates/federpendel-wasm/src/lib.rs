//! The engine of the page: what a browser asks of the core, the texts and the fit.
//!
//! Plain functions over plain values, one file for each part, that any Rust test can call; [`exports`] hands them to
//! JavaScript: lists as JSON, samples as arrays of numbers one behind the other. Nothing here computes physics.
//! Everything is in SI units, and what is refused is refused with a [`Refusal`].

pub mod asked;
pub mod compare;
pub mod decrement;
pub mod experiment;
pub mod exports;
pub mod link;
mod many;
pub mod motion;
pub mod parameters;
pub mod presets;
pub mod recording;
mod refusal;
pub mod section;
pub mod simulated;
pub mod words;

pub use experiment::Experiment;
pub use refusal::Refusal;
