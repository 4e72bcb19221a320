//! From a recording of a free decay to the friction that acts: which laws, how strongly, how sure.
//!
//! [`fit()`] takes a [`Recording`] from a cold start to a [`FitReport`]:
//!
//! 1. the part that is a free decay (`window`), its turning points (`extremes`), and start values from
//!    the loss of amplitude per swing or from a grid (`start`);
//! 2. bounded least squares (`least_squares`) over a window that grows (`growing`), then for every number of
//!    turning points until rest (`stop`), and between the jumps of an acceleration (`jumps`); every mix of
//!    laws starts from the others (`mixes`);
//! 3. how much residuals that hang together count (`noise`), which laws that leaves (`ranking`), standard errors
//!    and intervals (`covariance`, `profile`, `bootstrap`,
//!    `elsewhere`), whether the oscillator fits at all
//!    (`adequacy`), and from which amplitude a further recording would tell more (`reach`).
//!
//! What a mass or a stiffness makes of it says [`physical()`], and [`damping()`] says it as engineers do.
//! [`plan()`](plan::plan) says before there is a recording what one could tell.
//!
//! ```
//! use federpendel_fit::{Options, Quantity, Recording, fit};
//!
//! // Positions in m every 20 ms: 0.1 m e^(−0.2 t) cos 6t, and some noise.
//! let times: Vec<f64> = (0..500).map(|i| 0.02 * f64::from(i)).collect();
//! let noise = |t: f64| 1e-4 * (1e5 * t * t).sin();
//! let values = times.iter().map(|t| 0.1 * (-0.2 * t).exp() * (6.0 * t).cos() + noise(*t)).collect();
//! let recording = Recording { times, values, quantity: Quantity::Position, unit: "m".to_owned() };
//!
//! let report = fit(&recording, &Options::default())?;
//! let best = report.best().expect("the verdict's mix is among the models");
//! assert_eq!(best.mix.to_string(), "stokes");
//! let rate = best.parameter("damping_rate").expect("Stokes friction has one");
//! assert!(rate.value.is_some_and(|value| (value - 0.2).abs() < 1e-3));
//! assert!(report.adequacy.adequate);
//! # Ok::<(), federpendel_fit::FitError>(())
//! ```

pub mod adequacy;
mod beginning;
mod bootstrap;
mod check;
pub mod clipping;
mod condense;
mod covariance;
pub mod damping;
mod described;
mod elsewhere;
pub mod error;
pub mod extremes;
mod fit;
mod growing;
mod held;
pub mod information;
mod jumps;
mod least_squares;
mod mixes;
pub mod model;
pub mod noise;
pub mod options;
mod patterns;
pub mod physical;
pub mod plan;
mod problem;
mod profile;
mod propagation;
pub mod ranking;
pub mod reach;
pub mod read;
pub mod recording;
pub mod report;
mod robust;
mod shares;
mod start;
mod stop;
mod stopped;
mod swings;
mod tails;
pub mod unit;
pub mod window;

pub use adequacy::{Adequacy, Fault, Finding};
pub use clipping::Clipping;
pub use damping::{Damping, damping};
pub use error::FitError;
pub use fit::fit;
pub use information::Information;
pub use least_squares::StopReason;
pub use model::{Course, Jacobian, ModelError, Parameters, Stop};
pub use options::{Bootstrap, Intervals, Laws, Loss, Options};
pub use physical::{Agreement, Given, Normal, Physical, physical};
pub use propagation::{Estimate, Measured};
pub use ranking::{Criteria, Standing, Verdict};
pub use reach::Reach;
pub use recording::{Quantity, Recording};
pub use report::{FitReport, Model, Parameter};
pub use stop::{Early, Rest};
pub use swings::Swing;
pub use window::{Edge, Window};
