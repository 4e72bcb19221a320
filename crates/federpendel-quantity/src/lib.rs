//! Quantities as people write them, "250 g" or "0,2 kg/s", read into SI numbers.
//!
//! A decimal quantity is converted correctly rounded: "100 mm" is the `f64` nearest to 0.1, not
//! the product of two rounded numbers. [`words`] says in a sentence why a text is none.

mod decimal;
mod dimension;
pub mod inputs;
mod uncertain;
mod unit;
pub mod words;

pub use dimension::Dimension;
pub use uncertain::parse_uncertain;

use decimal::Decimal;
use unit::Unit;

/// Longest text that is read as a quantity, bytes.
pub const LONGEST: usize = 200;

/// Why a text is not a quantity of the dimension that is needed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// Nothing but spaces.
    #[error("empty")]
    Empty,
    /// Longer than [`LONGEST`].
    #[error("{length} bytes; at most {LONGEST} are read")]
    TooLong {
        /// Length found, bytes.
        length: usize,
    },
    /// It does not begin with a number.
    #[error("does not begin with a number")]
    NoNumber,
    /// "1,000": one and one thousand are both possible.
    #[error("may mean {decimal} or {grouped}")]
    Ambiguous {
        /// The reading with a decimal comma, written with a point.
        decimal: String,
        /// The reading with a thousands separator.
        grouped: String,
    },
    /// "1.000,5": several separators in one number.
    #[error("has thousands separators")]
    Grouped {
        /// The likely meaning without separators.
        plain: String,
    },
    /// NaN or an infinity, by name.
    #[error("not finite")]
    NotFinite,
    /// Too large for an `f64`.
    #[error("too large")]
    Overflow,
    /// Not zero, but so small that an `f64` cannot hold it to full precision.
    #[error("too small")]
    Underflow,
    /// The number is followed by something that no unit is called.
    #[error("unknown unit {unit}")]
    UnknownUnit {
        /// The text that is no unit.
        unit: String,
        /// The nearest right one, if one is near.
        nearest: Option<String>,
    },
    /// The unit's grammar is broken ("N/", "kg/m·s").
    #[error("unit {unit} cannot be read")]
    UnitGrammar {
        /// The text that cannot be read.
        unit: String,
    },
    /// A good unit, but of another dimension.
    #[error("{unit} is a unit of another dimension")]
    WrongDimension {
        /// The unit as written.
        unit: String,
        /// What it measures, if that has a name here.
        found: Option<Dimension>,
    },
    /// "12.0 ± -0.3 N/m".
    #[error("the uncertainty is negative")]
    NegativeUncertainty,
    /// "12.0 N/m ± 0.3": the uncertainty may be in any unit.
    #[error("the uncertainty has no unit")]
    UncertaintyWithoutUnit,
    /// "12(a) N/m", "(12 ± 1 N/m", "1 ± 2 ± 3 N/m".
    #[error("{text} is not a value and its uncertainty")]
    UncertaintyGrammar {
        /// The text that cannot be read.
        text: String,
    },
}

/// Reads `text` as a quantity of `dimension`, in SI units. A bare number is SI.
///
/// # Errors
/// Every way in which `text` can fail to be one number and one unit, see [`Error`].
pub fn parse(text: &str, dimension: Dimension) -> Result<f64, Error> {
    if text.len() > LONGEST {
        return Err(Error::TooLong { length: text.len() });
    }
    let (number, rest) = Decimal::read(text.trim())?;
    let rest = rest.trim();
    if rest.is_empty() {
        return number.to_f64();
    }
    let unit = Unit::parse(rest, dimension)?;
    if unit.powers != dimension.powers() {
        let found = Dimension::from_powers(unit.powers);
        return Err(Error::WrongDimension { unit: rest.to_owned(), found });
    }
    number.times(&unit.scale).to_f64()
}

#[cfg(test)]
mod tests;
