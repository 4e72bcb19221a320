//! What can be wrong with an experiment.

use super::{Field, Given, Syntax};
use crate::quantity;

/// What may stand at a place of an experiment file.
#[derive(Debug, Clone, PartialEq)]
pub enum Allowed {
    /// A quantity for this field.
    Quantity(Field),
    /// A table with these keys.
    Keys(Vec<&'static str>),
}

/// Why an experiment is refused. Said in words by [`crate::words`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The file is larger than [`LARGEST_FILE`](super::LARGEST_FILE).
    #[error("file too large")]
    TooLarge,
    /// The file is not UTF-8.
    #[error("not UTF-8 at byte {offset}")]
    NotUtf8 {
        /// Offset of the first bad byte.
        offset: usize,
    },
    /// The file says nothing.
    #[error("empty file")]
    EmptyFile,
    /// The file is not TOML.
    #[error("line {line}: {problem:?}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// What is wrong.
        problem: Syntax,
        /// The line as it may have been meant, where that can be guessed.
        example: Option<String>,
    },
    /// A key or section that no experiment has.
    #[error("unknown key {path}")]
    UnknownKey {
        /// The key with its section.
        path: String,
        /// Line, from 1.
        line: usize,
        /// The right key that is nearest to it, with its section.
        nearest: Option<String>,
        /// The keys allowed at this place.
        allowed: Vec<&'static str>,
    },
    /// A truth value, list, date or table where a quantity should be, or the other way round.
    #[error("{path} is {written}")]
    WrongType {
        /// The key with its section.
        path: String,
        /// Line, from 1.
        line: usize,
        /// What stands there.
        written: String,
        /// What may.
        allowed: Allowed,
    },
    /// A value that is no quantity of the right dimension.
    #[error("{}: {error}", given.field.path())]
    Quantity {
        /// As given; its value is NaN.
        given: Given,
        /// What is wrong with it.
        error: quantity::Error,
    },
    /// A quantity outside its range.
    #[error("{} = {} is out of range", .0.field.path(), .0.value)]
    Range(Given),
    /// Two forms of one thing.
    #[error("both {} and {}", first.field.path(), second.field.path())]
    Both {
        /// The one read first.
        first: Given,
        /// The other.
        second: Given,
    },
    /// A value that must be given is not.
    #[error("{} is missing", .0.path())]
    Missing(Field),
    /// Some of density, drag coefficient and area are given, but not all.
    #[error("{} without {}", given.field.path(), missing.path())]
    Incomplete {
        /// One that is given.
        given: Given,
        /// One that is not.
        missing: Field,
    },
    /// A static coefficient without a kinetic one.
    #[error("static without kinetic")]
    StaticWithoutKinetic(Given),
    /// A static coefficient below the kinetic one.
    #[error("static below kinetic")]
    StaticBelowKinetic {
        /// The static coefficient.
        static_: Given,
        /// The kinetic coefficient.
        kinetic: Given,
    },
    /// Coulomb friction, but nothing presses the mass on its guide.
    #[error("Coulomb friction without a normal force")]
    NoNormalForce(Given),
    /// More samples than fit into memory.
    #[error("{} samples do not fit into memory", given.value)]
    TooManySamples {
        /// As given.
        given: Given,
        /// How many fit.
        fit: usize,
    },
    /// Values allowed one by one that do not go together.
    #[error(transparent)]
    Core(#[from] federpendel::Error),
}
