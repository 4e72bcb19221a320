//! The sections of the report, one file each.

pub mod coulomb;
pub mod experiment;
pub mod newton;
pub mod scheme;
pub mod stokes;
pub mod undamped;
pub mod which;

use crate::article::Case;
use crate::article::writer::Writer;
use crate::document::Block;
use crate::sketch::{self, Law, Side};

/// The mass with its forces, on the side of its release.
fn forces(writer: &Writer<'_>, case: &Case, law: Law, id: &str) -> Block {
    let side = if case.release().position < 0.0 { Side::Left } else { Side::Right };
    let caption = match law {
        Law::None => "article-sketch-none",
        Law::Stokes => "article-sketch-stokes",
        Law::Coulomb => "article-sketch-coulomb",
        Law::Newton => "article-sketch-newton",
    };
    Block::Sketch {
        id: id.to_owned(),
        svg: sketch::guide(id, law, side, writer.catalogue),
        caption: writer.catalogue.text(caption),
    }
}

/// A formula with its number in the article.
fn numbered(number: &str, tex: &str) -> Block {
    Block::Formula { number: Some(format!("({number})")), tex: tex.to_owned() }
}

/// A formula that the article does not have.
fn unnumbered(tex: &str) -> Block {
    Block::Formula { number: None, tex: tex.to_owned() }
}
