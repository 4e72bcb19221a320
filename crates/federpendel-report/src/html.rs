//! A [`Document`] as one HTML page that needs nothing else: no script, no font, no other file.

mod drawing;
mod math;
mod view;
mod words;

use federpendel_text::Catalogue;
use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, UndefinedBehavior};

use crate::Document;
use view::View;

/// A page that could not be written.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// A formula that is no TeX, or uses what MathML cannot say.
    #[error("the formula “{tex}” cannot be set: {reason}")]
    Formula {
        /// The formula.
        tex: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A text in which a formula begins and does not end.
    #[error("a dollar sign without its partner in “{0}”")]
    Dollar(String),
    /// A mistake in the template of the page.
    #[error("the template of the page: {0:#}")]
    Template(#[from] minijinja::Error),
}

/// `document` as an HTML page in the language of `catalogue`.
///
/// # Errors
/// [`PageError`] if a formula cannot be set.
pub fn page(document: &Document, catalogue: &Catalogue) -> Result<String, PageError> {
    let view = View::of(document, catalogue)?;
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    // Lines that hold nothing but a tag leave no line in the page.
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    Ok(environment.render_str(include_str!("../templates/page.html"), Serde(view))?)
}
