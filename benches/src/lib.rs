//! What is measured: the exact motion from parameters to filled buffers, the plain loops and the
//! public integrators beside it, and a clock that times them in turn.

pub mod clock;
pub mod experiment;
pub mod peers;
pub mod plain;
