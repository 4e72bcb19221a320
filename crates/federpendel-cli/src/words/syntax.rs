//! Sentences about files that are not TOML.

use federpendel_text::Catalogue;

use crate::experiment::Syntax;

/// What is wrong with a file that is not TOML, and how it is written rightly.
pub(super) fn not_toml(catalogue: &Catalogue, problem: &Syntax) -> String {
    let id = match problem {
        Syntax::Unquoted { key, value } => {
            let variables = [("key", key.as_str().into()), ("value", value.as_str().into())];
            return catalogue.format("toml-unquoted", &variables);
        }
        Syntax::Twice { key } => {
            return catalogue.format("toml-twice", &[("key", key.as_str().into())]);
        }
        Syntax::Other(problem) => {
            return catalogue.format("toml-other", &[("problem", problem.as_str().into())]);
        }
        Syntax::UnquotedText => "toml-unquoted-text",
        Syntax::BadText => "toml-bad-text",
        Syntax::UnclosedSection => "toml-unclosed-section",
        Syntax::UnclosedTable => "toml-unclosed-table",
        Syntax::UnclosedList => "toml-unclosed-list",
        Syntax::NoEquals => "toml-no-equals",
        Syntax::NoValue => "toml-no-value",
        Syntax::BadKey => "toml-bad-key",
        Syntax::Comma => "toml-comma",
        Syntax::BadNumber => "toml-bad-number",
        Syntax::Trailing => "toml-trailing",
        Syntax::TooDeep => "toml-too-deep",
    };
    catalogue.text(id)
}
