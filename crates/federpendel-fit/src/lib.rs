//! From a recording of a free decay to the friction that acts: which laws, how strongly, how sure.

pub mod adequacy;
mod bootstrap;
mod covariance;
pub mod error;
pub mod extremes;
mod fit;
mod growing;
mod jumps;
mod least_squares;
mod mixes;
pub mod model;
pub mod noise;
pub mod options;
mod problem;
mod profile;
pub mod ranking;
pub mod reach;
pub mod read;
pub mod recording;
pub mod report;
mod start;
mod stop;
pub mod window;

pub use adequacy::{Adequacy, Fault, Finding};
pub use error::FitError;
pub use fit::fit;
pub use least_squares::StopReason;
pub use model::{Course, Jacobian, ModelError, Parameters, Stop};
pub use options::{Bootstrap, Intervals, Loss, Options};
pub use ranking::{Criteria, Standing, Verdict};
pub use reach::Reach;
pub use recording::{Quantity, Recording};
pub use report::{FitReport, Model, Parameter};
pub use stop::Rest;
pub use window::{Edge, Window};
