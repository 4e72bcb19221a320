//! What is wrong, in the user's language: field, value, what is allowed.

mod experiment;
mod quantity;

pub use experiment::experiment_error;
pub use quantity::{allowed, quantity_problem, time_step_value};
