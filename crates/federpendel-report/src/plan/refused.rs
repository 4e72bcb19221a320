//! Why there is no plan.

use federpendel_fit::ModelError;
use federpendel_fit::plan::PlanError;
use federpendel_text::Catalogue;

/// Digits of a quantity; those that were given have all of theirs.
const DIGITS: usize = 3;

/// The sentence that refuses a plan.
pub fn plan_error(catalogue: &Catalogue, error: &PlanError) -> String {
    let given = |value: f64, unit| catalogue.exact_quantity(value, unit).into();
    let found = |value: f64, unit| catalogue.quantity(value, unit, DIGITS).into();
    match *error {
        PlanError::NotPositive { name, value } => {
            let name = format!("--{}", name.replace('_', "-"));
            let allowed = catalogue.text("range-positive");
            let variables =
                [("name", name.into()), ("value", given(value, "1")), ("allowed", allowed.into())];
            catalogue.format("fit-refused-option", &variables)
        }
        PlanError::NoSwings { ratio } => {
            catalogue.format("plan-no-swings", &[("ratio", found(ratio, "1"))])
        }
        PlanError::RateTooLow { rate, least } => {
            let variables = [("rate", given(rate, "Hz")), ("least", found(least, "Hz"))];
            catalogue.format("plan-rate-too-low", &variables)
        }
        PlanError::TooShort { duration, least } => {
            let variables = [("duration", given(duration, "s")), ("least", found(least, "s"))];
            catalogue.format("plan-duration-too-short", &variables)
        }
        PlanError::Sticks { amplitude, held } => {
            let variables = [("amplitude", given(amplitude, "m")), ("held", found(held, "m"))];
            catalogue.format("plan-sticks", &variables)
        }
        PlanError::Reversed { from, to } => {
            let variables = [("from", given(from, "m")), ("to", given(to, "m"))];
            catalogue.format("plan-reversed", &variables)
        }
        PlanError::Drowned { noise, amplitude } => {
            let variables = [("noise", found(noise, "m")), ("amplitude", given(amplitude, "m"))];
            catalogue.format("plan-drowned", &variables)
        }
        PlanError::Model(ModelError::TooLong { reached, .. }) => {
            catalogue.format("plan-too-long", &[("reached", found(reached, "s"))])
        }
        PlanError::Model(_) => catalogue.text("plan-not-computed"),
    }
}
