//! Public integrators, each as its documentation shows it: relative tolerance 1e-9, absolute
//! 1e-12, states at the times of a record from its dense output. Its own containers stay as it
//! returns them; nothing is copied.

mod differential;
mod diffsol;
mod ode_solvers;

use crate::experiment::Experiment;

pub use self::diffsol::stiff_state;
pub use self::ode_solvers::state as dop853_state;

/// Relative tolerance.
pub const RTOL: f64 = 1e-9;
/// Absolute tolerance, m and m/s.
pub const ATOL: f64 = 1e-12;
/// Most steps, as `ode_solvers` has it by default.
pub const STEPS: usize = 100_000;

/// What an integrator found.
#[derive(Debug, Clone, Default)]
pub struct Record {
    /// Number of states returned.
    pub states: usize,
    /// Positions, if they were asked for.
    pub positions: Vec<f64>,
}

/// An integrator.
pub struct Peer {
    /// Crate and method.
    pub name: &'static str,
    run: fn(&Experiment, &[f64], bool) -> Result<Record, String>,
}

impl Peer {
    /// Integrates `experiment` and returns its states at `times`, which rise evenly from zero.
    /// Positions are copied out of the peer's own container only if `keep`.
    ///
    /// # Errors
    /// What the peer says.
    pub fn run(
        &self,
        experiment: &Experiment,
        times: &[f64],
        keep: bool,
    ) -> Result<Record, String> {
        (self.run)(experiment, times, keep)
    }
}

/// All of them.
pub const ALL: [Peer; 7] = [
    Peer { name: "ode_solvers Dopri5", run: ode_solvers::dopri5 },
    Peer { name: "ode_solvers Dop853", run: ode_solvers::dop853 },
    Peer { name: "ode_solvers Dop853, tolerance 1e-13", run: ode_solvers::dop853_tight },
    Peer { name: "differential-equations dopri5", run: differential::dopri5 },
    Peer { name: "differential-equations dop853", run: differential::dop853 },
    Peer { name: "diffsol tsit45", run: diffsol::tsit45 },
    Peer { name: "diffsol bdf", run: diffsol::bdf },
];

/// `states` and, if wanted, the positions among them.
fn record<'a, S: 'a>(
    states: impl ExactSizeIterator<Item = &'a S>,
    keep: bool,
    position: impl Fn(&S) -> f64,
) -> Record {
    let count = states.len();
    let positions = if keep { states.map(position).collect() } else { Vec::new() };
    Record { states: count, positions }
}
