//! The errors of the core in words.

use federpendel::Error;
use federpendel::error::{LARGEST, SMALLEST};
use federpendel::parameter::PARAMETERS;

use crate::catalogue::Catalogue;
use crate::describe::{DIGITS, parameter_id};

impl Catalogue {
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
            // An input itself, not what follows from several.
            Error::Derived { quantity, value, of: [only] } if *only == quantity => self.format(
                "error-magnitude",
                &[
                    ("name", self.field(quantity).into()),
                    ("value", self.exact_quantity(value, unit(quantity)).into()),
                    ("smallest", self.exact_quantity(SMALLEST, "1").into()),
                    ("largest", self.exact_quantity(LARGEST, "1").into()),
                ],
            ),
            Error::Derived { quantity, value, of } => self.format(
                "error-derived",
                &[
                    ("quantity", self.field(quantity).into()),
                    ("value", self.exact_quantity(value, "1").into()),
                    ("fields", of.join(", ").into()),
                    ("smallest", self.exact_quantity(SMALLEST, "1").into()),
                    ("largest", self.exact_quantity(LARGEST, "1").into()),
                ],
            ),
            Error::DragTooStrong { value, limit } => self.format(
                "error-drag-too-strong",
                &[
                    ("value", self.exact_quantity(value, "1").into()),
                    ("limit", self.exact_quantity(limit, "1").into()),
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
            Error::Order { name, value, before } => self.format(
                "error-order",
                &[
                    ("name", name.into()),
                    ("value", self.exact_quantity(value, "1").into()),
                    ("before", self.exact_quantity(before, "1").into()),
                ],
            ),
            Error::NoSuchSolution { solution, regime } => {
                // The two solutions that the article gives without a number.
                let named = match solution {
                    "overdamped" => self.text("solution-overdamped"),
                    "critical" => self.text("solution-critical"),
                    number => number.to_owned(),
                };
                self.format(
                    "error-no-such-solution",
                    &[("solution", named.into()), ("regime", self.regime(regime).into())],
                )
            }
            Error::NoPhase => self.text("error-no-phase"),
            Error::Diverged { time_step, time } => self.format(
                "error-diverged",
                &[
                    ("name", self.field("dt").into()),
                    ("step", self.exact_quantity(time_step, "s").into()),
                    ("time", self.quantity(time, "s", DIGITS).into()),
                ],
            ),
            Error::StepUnderflow { time, step } => self.format(
                "error-step-underflow",
                &[
                    ("time", self.quantity(time, "s", DIGITS).into()),
                    ("step", self.quantity(step, "s", 2).into()),
                ],
            ),
            Error::StepLimit { time, limit } => self.format(
                "error-step-limit",
                &[
                    ("time", self.quantity(time, "s", DIGITS).into()),
                    ("limit", self.number(limit as f64, DIGITS).into()),
                ],
            ),
            Error::TooManySteps { time, time_step, steps, limit } => self.format(
                "error-too-many-steps",
                &[
                    ("name", self.field("dt").into()),
                    ("step", self.exact_quantity(time_step, "s").into()),
                    ("time", self.quantity(time, "s", DIGITS).into()),
                    ("steps", self.number(steps, DIGITS).into()),
                    ("limit", self.number(limit as f64, DIGITS).into()),
                ],
            ),
            // The core may add errors; until they stand in the catalogue they speak for themselves.
            _ => error.to_string(),
        }
    }

    /// A field by its key and, where that is another word, what it is called: “mass (Masse)”.
    fn field(&self, key: &str) -> String {
        let id = if PARAMETERS.iter().any(|info| info.name == key) {
            parameter_id(key)
        } else {
            format!("derived-{}", key.replace('_', "-"))
        };
        if !self.contains(&id) {
            return key.to_owned();
        }
        let name = self.text(&id);
        if name.replace(' ', "_") == key { key.to_owned() } else { format!("{key} ({name})") }
    }
}

fn unit(name: &str) -> &'static str {
    PARAMETERS.iter().find(|info| info.name == name).map_or("1", |info| info.unit)
}

#[cfg(test)]
mod tests {
    use federpendel::parameter::Range;
    use federpendel::{Mix, Regime};

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
    fn every_error_of_the_core_is_known_here() {
        let core = include_str!("../../federpendel/src/error.rs");
        let body = core.split("pub enum Error {").nth(1).and_then(|rest| rest.split("\n}").next());
        let variants = body.expect("the errors of the core").lines().filter_map(|line| {
            let line = line.strip_prefix("    ")?;
            line.starts_with(char::is_uppercase)
                .then(|| line.trim_end_matches([' ', '{', ',', '(']))
        });
        let variants: Vec<_> = variants.collect();
        assert!(variants.contains(&"Parameter") && variants.contains(&"NoPhase"), "{variants:?}");
        for variant in variants {
            let arm = format!("            Error::{variant}");
            assert!(include_str!("error.rs").contains(&arm), "no sentence for {variant}");
        }
    }

    #[test]
    fn every_error_is_a_sentence_in_both_languages() {
        let errors = [
            Error::NoNormalForce { name: "gravity", value: 0.0 },
            Error::Derived { quantity: "offset", value: f64::INFINITY, of: &["stiffness"] },
            Error::DragTooStrong { value: 1e6, limit: 1e5 },
            Error::TooManySwings { time: 1e9, reached: 123.0, swings: 10_000_000 },
            Error::Order { name: "times", value: 1.0, before: 2.0 },
            Error::NoSuchSolution { solution: "critical", regime: Regime::Overdamped },
            Error::NoPhase,
            Error::Diverged { time_step: 1.0, time: 40.0 },
            Error::TooManySteps { time: 1.0, time_step: 1e-12, steps: 1e12, limit: 1_000_000 },
            Error::StepUnderflow { time: 5.0, step: 1e-17 },
            Error::StepLimit { time: 5.0, limit: 1_000_000 },
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
}
