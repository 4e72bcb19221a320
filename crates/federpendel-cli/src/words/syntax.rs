//! Sentences about files that are not TOML.

use federpendel_text::{Catalogue, excerpt};

use crate::experiment::Syntax;

/// What is wrong with a file that is not TOML, and how it is written rightly: the user's own line
/// where `example` has it, another one else.
pub(super) fn not_toml(catalogue: &Catalogue, problem: &Syntax, example: Option<&str>) -> String {
    let (id, other) = match problem {
        Syntax::Unquoted { key, value } => {
            let variables = [("key", excerpt(key).into()), ("value", excerpt(value).into())];
            return catalogue.format("toml-unquoted", &variables);
        }
        Syntax::Twice { key } => {
            return catalogue.format("toml-twice", &[("key", excerpt(key).into())]);
        }
        Syntax::Other(problem) => {
            return catalogue.format("toml-other", &[("problem", excerpt(problem).into())]);
        }
        Syntax::UnclosedList => return catalogue.text("toml-unclosed-list"),
        Syntax::Trailing => return catalogue.text("toml-trailing"),
        Syntax::TooDeep => return catalogue.text("toml-too-deep"),
        Syntax::Typographic => ("toml-typographic", "mass = \"300 g\""),
        Syntax::UnquotedText => ("toml-unquoted-text", "mass = \"300 g\""),
        Syntax::BadText => ("toml-bad-text", "mass = \"300 g\""),
        Syntax::UnclosedSection => ("toml-unclosed-section", "[oscillator]"),
        Syntax::UnclosedTable => ("toml-unclosed-table", "stokes = { damping = 0.2 }"),
        Syntax::NoEquals => ("toml-no-equals", "mass = 0.5"),
        Syntax::NoValue => ("toml-no-value", "mass = 0.5"),
        Syntax::BadKey => ("toml-bad-key", "mass = 0.5"),
        Syntax::Comma => ("toml-comma", "{ kinetic = 0.02, static = 0.03 }"),
        Syntax::BadNumber => ("toml-bad-number", "mass = \"0,5 kg\""),
    };
    // A line of the user's may hold tabs.
    catalogue.format(id, &[("example", excerpt(example.unwrap_or(other)).into())])
}
