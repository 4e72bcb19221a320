//! What a person reads: every sentence, in German and English, from one catalogue; and plots,
//! described once and drawn by several back ends.
//!
//! A sentence is added to a file of `locales/en` and of `locales/de` under the same id, in the syntax of
//! [Project Fluent](https://projectfluent.org), and fetched by that id:
//!
//! ```
//! use federpendel_text::{Catalogue, Language};
//!
//! let catalogue = Catalogue::new(Language::German);
//! assert_eq!(catalogue.text("term-turning-point"), "Umkehrpunkt");
//! assert_eq!(catalogue.quantity(0.0019, "m", 4), "1,9 mm");
//! assert_eq!(catalogue.format("count-swings", &[("swings", 2.into())]), "2 Halbschwingungen");
//! ```
//!
//! The tests of this crate read the sources of the whole workspace: they fail on an id that a
//! source asks for and a language lacks, and on one that no source asks for.

mod catalogue;
mod derived;
mod describe;
mod error;
mod excerpt;
mod language;
mod lens;
mod measured;
mod number;
pub mod plot;
pub mod table;

pub use catalogue::{Catalogue, Value};
pub use describe::ParameterText;
pub use excerpt::{excerpt, plain};
pub use language::Language;
