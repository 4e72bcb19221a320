//! The core's values in words: parameters, errors, mixes, kinds, how a motion ends.

use federpendel::parameter::{PARAMETERS, ParameterInfo, Range};
use federpendel::{Error, Kind, Mix, Outcome, Regime};

use crate::catalogue::Catalogue;
use crate::number::typeset_unit;

/// Digits of a quantity in a sentence.
const DIGITS: usize = 4;

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
        })
    }

    /// An error of the core: one sentence that names the field, its value and what is allowed.
    pub fn error(&self, error: &Error) -> String {
        match *error {
            Error::Parameter { name, value, range } => self.format(
                "error-parameter",
                &[
                    ("name", self.field(name).into()),
                    ("value", self.exact_quantity(value, unit(name)).into()),
                    ("allowed", self.range(range).into()),
                ],
            ),
            Error::StaticBelowKinetic { static_, kinetic } => self.format(
                "error-static-below-kinetic",
                &[
                    ("name", self.field("static").into()),
                    ("static", self.exact_quantity(static_, "1").into()),
                    ("kinetic", self.exact_quantity(kinetic, "1").into()),
                ],
            ),
            Error::NoNormalForce { name, value } => self.format(
                "error-no-normal-force",
                &[
                    ("name", self.field(name).into()),
                    ("value", self.exact_quantity(value, unit(name)).into()),
                ],
            ),
            Error::Derived { quantity, value } => self.format(
                // An ordinary number that is refused lies beyond what can be computed.
                if value.is_normal() { "error-derived-too-large" } else { "error-derived" },
                &[
                    ("quantity", self.field(quantity).into()),
                    ("value", self.exact_quantity(value, "1").into()),
                ],
            ),
            Error::TooManySwings { time, reached, swings } => self.format(
                "error-too-many-swings",
                &[
                    ("name", self.field("time").into()),
                    ("time", self.exact_quantity(time, "s").into()),
                    ("reached", self.quantity(reached, "s", DIGITS).into()),
                    ("swings", swings.into()),
                ],
            ),
            Error::Length { name, found, expected } => self.format(
                "error-length",
                &[("name", name.into()), ("found", found.into()), ("expected", expected.into())],
            ),
            Error::NotInArticle { mix } => {
                self.format("error-not-in-article", &[("mix", self.mix(mix).into())])
            }
            // The core may add errors; until they stand in the catalogue they speak for themselves.
            _ => error.to_string(),
        }
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
            Outcome::Unknown { after, swings } => {
                self.format("outcome-unknown", &[("time", time(after)), ("swings", swings.into())])
            }
            _ => String::new(),
        }
    }

    /// A field by its key and, where that is another word, what it is called: “mass (Masse)”.
    fn field(&self, key: &str) -> String {
        let id = if PARAMETERS.iter().any(|info| info.name == key) {
            parameter_id(key)
        } else {
            // The core may add an explanation in brackets to the name.
            let name = key.split(" (").next().unwrap_or(key);
            format!("derived-{}", name.replace(['_', ' '], "-"))
        };
        if !self.contains(&id) {
            return key.to_owned();
        }
        let name = self.text(&id);
        if key.contains(' ') {
            name
        } else if name.replace(' ', "_") == key {
            key.to_owned()
        } else {
            format!("{key} ({name})")
        }
    }
}

fn parameter_id(name: &str) -> String {
    format!("parameter-{}", name.replace('_', "-"))
}

fn unit(name: &str) -> &'static str {
    PARAMETERS.iter().find(|info| info.name == name).map_or("1", |info| info.unit)
}

#[cfg(test)]
mod tests {
    use federpendel::Rest;

    use super::*;
    use crate::language::Language;

    #[test]
    fn errors_name_field_value_and_what_is_allowed() {
        let english = Catalogue::new(Language::English);
        let german = Catalogue::new(Language::German);
        let error = Error::Parameter { name: "mass", value: -0.5, range: Range::Positive };
        assert_eq!(
            english.error(&error),
            "mass is -0.5 kg; allowed is a finite number greater than 0"
        );
        assert_eq!(
            german.error(&error),
            "mass (Masse) ist -0,5 kg; erlaubt ist eine endliche Zahl größer als 0"
        );
        let error = Error::StaticBelowKinetic { static_: 0.1, kinetic: 0.25 };
        assert_eq!(
            german.error(&error),
            "static (Haftreibungszahl) ist 0,1; erlaubt ist mindestens die Gleitreibungszahl \
             (kinetic), 0,25"
        );
    }

    #[test]
    fn every_error_is_a_sentence_in_both_languages() {
        let errors = [
            Error::NoNormalForce { name: "gravity", value: 0.0 },
            Error::Derived { quantity: "angular_frequency", value: f64::INFINITY },
            Error::Derived { quantity: "drag strength (newton_rate times amplitude)", value: 1e6 },
            Error::TooManySwings { time: 1e9, reached: 123.0, swings: 10_000_000 },
            Error::Length { name: "velocities", found: 3, expected: 4 },
            Error::NotInArticle { mix: Mix { stokes: true, coulomb: true, newton: true } },
        ];
        for error in &errors {
            let english = Catalogue::new(Language::English).error(error);
            let german = Catalogue::new(Language::German).error(error);
            assert_ne!(english, german);
            assert!(!german.contains("{$") && !english.contains("{$"), "{german} {english}");
        }
    }

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
