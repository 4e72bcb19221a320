//! The core's values in words: parameters, mixes, kinds, how a motion ends.

use federpendel::parameter::{ParameterInfo, Range};
use federpendel::{Kind, Mix, Outcome, Regime};

use crate::catalogue::Catalogue;
use crate::number::typeset_unit;

/// Digits of a quantity in a sentence.
pub(crate) const DIGITS: usize = 4;

/// A parameter in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParameterText {
    /// What it is called, for example “mass”.
    pub name: String,
    /// One line that says what it is.
    pub description: String,
    /// Symbol in formulas.
    pub symbol: &'static str,
    /// Unit as it is printed; empty for a pure number.
    pub unit: String,
    /// Which values are allowed.
    pub allowed: String,
}

impl Catalogue {
    /// A parameter in words.
    pub fn parameter(&self, info: &ParameterInfo) -> ParameterText {
        ParameterText {
            name: self.text(&parameter_id(info.name)),
            description: self.text(&format!("{}.description", parameter_id(info.name))),
            symbol: info.symbol,
            unit: typeset_unit(info.unit),
            allowed: self.range(info.range),
        }
    }

    /// Which values a range allows.
    pub fn range(&self, range: Range) -> String {
        self.text(match range {
            Range::Positive => "range-positive",
            Range::NonNegative => "range-non-negative",
            Range::Finite => "range-finite",
            Range::CountFromTwo => "range-count-from-two",
            Range::Fraction => "range-fraction",
        })
    }

    /// Which laws act: “Stokes and Coulomb friction”.
    pub fn mix(&self, mix: Mix) -> String {
        self.text(match (mix.stokes, mix.coulomb, mix.newton) {
            (false, false, false) => "mix-none",
            (true, false, false) => "mix-stokes",
            (false, true, false) => "mix-coulomb",
            (false, false, true) => "mix-newton",
            (true, true, false) => "mix-stokes-coulomb",
            (true, false, true) => "mix-stokes-newton",
            (false, true, true) => "mix-coulomb-newton",
            (true, true, true) => "mix-all",
        })
    }

    /// How strongly Stokes friction damps, in a word.
    pub fn regime(&self, regime: Regime) -> String {
        self.text(match regime {
            Regime::Undamped => "regime-undamped",
            Regime::Underdamped => "regime-underdamped",
            Regime::Critical => "regime-critical",
            Regime::Overdamped => "regime-overdamped",
        })
    }

    /// How a motion is known. Only the first two kinds are called exact; a series is so to rounding.
    pub fn kind(&self, kind: Kind) -> String {
        self.text(match kind {
            Kind::ClosedForm => "kind-closed-form",
            Kind::FirstIntegral => "kind-first-integral",
            Kind::Series => "kind-series",
        })
    }

    /// A motion of this kind beside others; only the first two kinds are called exact.
    pub fn motion(&self, kind: Kind) -> String {
        self.text(match kind {
            Kind::ClosedForm | Kind::FirstIntegral => "motion-exact",
            Kind::Series => "motion-to-rounding",
        })
    }

    /// How a motion ends: “comes to rest after 10 swings, 4.967 s, 1.9 mm from the centre”.
    pub fn outcome(&self, outcome: &Outcome) -> String {
        let length = |x: f64| self.quantity(x.abs(), "m", DIGITS).into();
        let time = |t: f64| self.quantity(t, "s", DIGITS).into();
        match *outcome {
            Outcome::Rests(rest) if rest.time == 0.0 => {
                self.format("outcome-rests-at-once", &[("distance", length(rest.position))])
            }
            Outcome::Rests(rest) => self.format(
                "outcome-rests",
                &[
                    ("swings", rest.swings.into()),
                    ("time", time(rest.time)),
                    ("distance", length(rest.position)),
                ],
            ),
            Outcome::Creeps { limit: 0.0 } => self.text("outcome-creeps-to-centre"),
            Outcome::Creeps { limit } => {
                self.format("outcome-creeps", &[("distance", length(limit))])
            }
            Outcome::Swings => self.text("outcome-swings"),
            Outcome::Decays => self.text("outcome-decays"),
            Outcome::Unknown { after, swings } => {
                self.format("outcome-unknown", &[("time", time(after)), ("swings", swings.into())])
            }
            _ => String::new(),
        }
    }
}

pub(crate) fn parameter_id(name: &str) -> String {
    format!("parameter-{}", name.replace('_', "-"))
}

#[cfg(test)]
mod tests {
    use federpendel::Rest;

    use super::*;
    use crate::language::Language;

    #[test]
    fn outcomes_in_one_sentence() {
        let rest = Rest { time: 4.967294, position: 0.0019, swings: 10, margin: 0.6, tie: false };
        let outcome = Outcome::Rests(rest);
        assert_eq!(
            Catalogue::new(Language::English).outcome(&outcome),
            "comes to rest after 10 swings, 4.967 s, 1.9 mm from the centre"
        );
        assert_eq!(
            Catalogue::new(Language::German).outcome(&outcome),
            "kommt nach 10 Halbschwingungen zur Ruhe, bei 4,967 s, 1,9 mm von der Mitte"
        );
        let once = Outcome::Rests(Rest { swings: 1, ..rest });
        assert!(Catalogue::new(Language::English).outcome(&once).contains("1 swing,"));
        assert!(Catalogue::new(Language::German).outcome(&once).contains("1 Halbschwingung zur"));
    }
}
