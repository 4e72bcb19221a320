//! `ode_solvers`: Dormand–Prince 5(4) and 8(5,3) of Hairer and Wanner.

use ode_solvers::{Dop853, Dopri5, System, Vector2};

use super::{ATOL, RTOL, Record, record};
use crate::experiment::Experiment;

struct Equation<A>(A);

impl<A: Fn(f64, f64) -> f64> System<f64, Vector2<f64>> for Equation<A> {
    fn system(&self, _time: f64, state: &Vector2<f64>, rate: &mut Vector2<f64>) {
        *rate = Vector2::new(state.y, (self.0)(state.x, state.y));
    }
}

/// Duration and step of an even grid.
fn grid(times: &[f64]) -> (f64, f64) {
    let duration = times[times.len() - 1];
    (duration, duration / (times.len() - 1) as f64)
}

pub fn dopri5(experiment: &Experiment, times: &[f64], keep: bool) -> Result<Record, String> {
    let (duration, step) = grid(times);
    let release = Vector2::new(experiment.position, 0.0);
    let equation = Equation(experiment.acceleration());
    let mut solver = Dopri5::new(equation, 0.0, duration, step, release, RTOL, ATOL);
    solver.integrate().map_err(|error| error.to_string())?;
    Ok(record(solver.y_out().iter(), keep, |state| state.x))
}

pub fn dop853(experiment: &Experiment, times: &[f64], keep: bool) -> Result<Record, String> {
    eighth_order(experiment, times, keep, RTOL, ATOL)
}

/// With the smallest tolerance that makes sense in `f64`.
pub fn dop853_tight(experiment: &Experiment, times: &[f64], keep: bool) -> Result<Record, String> {
    eighth_order(experiment, times, keep, 1e-13, 1e-16)
}

fn eighth_order(
    experiment: &Experiment,
    times: &[f64],
    keep: bool,
    rtol: f64,
    atol: f64,
) -> Result<Record, String> {
    let (duration, step) = grid(times);
    let release = Vector2::new(experiment.position, 0.0);
    let equation = Equation(experiment.acceleration());
    let mut solver = Dop853::new(equation, 0.0, duration, step, release, rtol, atol);
    solver.integrate().map_err(|error| error.to_string())?;
    Ok(record(solver.y_out().iter(), keep, |state| state.x))
}

/// Position at `time` alone, with as many steps as it takes. Its dense output cannot be asked for the
/// last state only: it then extrapolates from the first step.
///
/// # Errors
/// What the integrator says.
pub fn state(experiment: &Experiment, time: f64) -> Result<f64, String> {
    let release = Vector2::new(experiment.position, 0.0);
    let equation = Equation(experiment.acceleration());
    let mut solver = Dop853::from_param(
        equation,
        0.0,
        time,
        time,
        release,
        RTOL,
        ATOL,
        0.9,
        0.0,
        0.333,
        6.0,
        time,
        0.0,
        u32::MAX,
        u32::MAX,
        ode_solvers::OutputType::Sparse,
    );
    solver.integrate().map_err(|error| error.to_string())?;
    solver.y_out().last().map(|state| state.x).ok_or_else(|| "no output".to_owned())
}
