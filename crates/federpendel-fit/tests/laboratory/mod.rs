//! The laboratory in which the recordings of `examples/recordings` are made: motions of known oscillators, as
//! sensors would have recorded them, in the dialects of the programs that record.

#![allow(dead_code)] // Each test needs some of it.

mod experiment;
mod file;

pub use experiment::{EXPERIMENTS, Experiment};
pub use file::files;
