//! The report on *Das Federpendel mit verschiedenen Arten von Reibung*, the article that
//! [`federpendel::article`] holds by equation number: its claims, checked by computation for one experiment.

pub mod check;
mod laboratory;

pub use laboratory::{Case, Laboratory};
