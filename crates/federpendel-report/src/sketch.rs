//! Drawings as in a textbook, for [`Block::Sketch`](crate::Block::Sketch): SVG elements in the colour of the text
//! around them; what is meant by a colour the style sheet of the page says by classes.

mod body;
mod guide;
mod label;
mod loss;
mod pen;
mod stream;

pub use guide::{Law, Side, guide};
pub use loss::{Given, loss};
pub use stream::stream;
