//! From a recording of a free decay to the friction that acts: which laws, how strongly, how sure.

pub mod model;
pub mod read;
pub mod recording;

pub use model::{Parameters, Stop};
pub use recording::{Quantity, Recording};
