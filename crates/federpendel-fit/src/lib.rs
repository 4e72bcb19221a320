//! From a recording of a free decay to the friction that acts: which laws, how strongly, how sure.

pub mod model;
pub mod recording;

pub use model::{Course, Jacobian, ModelError, Parameters, Stop};
pub use recording::{Quantity, Recording};
