//! The report on *Das Federpendel mit verschiedenen Arten von Reibung*, the article that
//! [`federpendel::article`] holds by equation number: its claims, checked by computation for one experiment.

pub mod check;
mod figure;
mod laboratory;
mod measure;
mod report;
mod section;
mod writer;

pub use check::{Check, Checks, Figure};
pub use laboratory::{Case, Laboratory};
pub use report::{Edition, document, picture, result};
pub use writer::check_claim;
