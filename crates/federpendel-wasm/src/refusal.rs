//! Why something cannot be done, for the field that it stands beside.

use federpendel::Error;
use federpendel_text::Catalogue;
use serde::Serialize;

use crate::asked::Offer;

/// What is refused, and the sentence that says what is allowed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Refusal {
    /// The parameter by its name; empty where no single one is to blame.
    pub field: String,
    /// One sentence in the user's language.
    pub message: String,
    /// What a field of choices can be set to.
    pub offers: Vec<Offer>,
}

impl Refusal {
    /// An error of the core.
    pub fn core(catalogue: &Catalogue, error: &Error) -> Self {
        let field = match *error {
            Error::Parameter { name, .. } | Error::NoNormalForce { name, .. } => name,
            Error::StaticBelowKinetic { .. } => "static",
            Error::Derived { of: [only], .. } => only,
            Error::DragTooStrong { .. } => "drag_coefficient",
            Error::TooManySwings { .. } => "duration",
            Error::Diverged { .. } | Error::TooManySteps { .. } => "dt",
            _ => "",
        };
        Refusal::new(field, catalogue.error(error))
    }

    /// A refusal that says this of `field`.
    pub fn new(field: &str, message: String) -> Self {
        Refusal { field: field.to_owned(), message, offers: Vec::new() }
    }
}
