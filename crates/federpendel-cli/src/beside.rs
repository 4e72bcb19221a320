//! What was measured beside a recording, from the flags of `fit` to numbers.

use federpendel_fit::Given;
use federpendel_text::Catalogue;

use crate::failure::{Failure, note};
use crate::quantity::inputs::{Beside, Inputs, Said};
use crate::words::flag;

/// The inputs of `fit`, called by their flags.
pub(crate) fn inputs(catalogue: &Catalogue) -> Inputs<'_> {
    Inputs { catalogue, called: |_, input| flag(input) }
}

/// The failure of what is refused.
pub(crate) fn refused(said: Said) -> Failure {
    Failure::Input(said.sentence)
}

/// The numbers that are given; what is assumed of them is said.
///
/// # Errors
/// [`Failure::Input`] for the first flag that is refused, and for flags that contradict each other.
pub(crate) fn given(beside: &Beside, catalogue: &Catalogue) -> Result<Given, Failure> {
    let (given, remarks) = inputs(catalogue).given(beside).map_err(refused)?;
    remarks.iter().for_each(|remark| note(&remark.sentence));
    Ok(given)
}
