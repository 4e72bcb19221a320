//! What is said of a plan: why there is none, what to do, what that shows.

mod advice;
mod law;
mod picture;
mod refused;

pub use advice::sentences;
pub use law::{as_given, coefficient, name, quantity, role};
pub use picture::plot;
pub use refused::plan_error;
