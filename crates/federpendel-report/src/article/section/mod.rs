//! The sections of the report, one file each.

pub mod coulomb;
pub mod experiment;
pub mod newton;
pub mod scheme;
pub mod stokes;
pub mod undamped;
pub mod which;

use crate::document::Block;

/// A formula with its number in the article.
fn numbered(number: &str, tex: &str) -> Block {
    Block::Formula { number: Some(number.to_owned()), tex: tex.to_owned() }
}

/// A formula that the article does not have.
fn unnumbered(tex: &str) -> Block {
    Block::Formula { number: None, tex: tex.to_owned() }
}
