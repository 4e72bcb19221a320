//! `diffsol` on nalgebra: Tsitouras 5(4), and backward differentiation for stiff experiments.

use diffsol::{
    DiffsolError, NalgebraContext, NalgebraLU, NalgebraMat, NalgebraVec, OdeBuilder, OdeEquations,
    OdeEquationsImplicit, OdeSolverMethod, OdeSolverProblem, Vector,
};

use super::{ATOL, RTOL, Record, STEPS, record};
use crate::experiment::Experiment;

type Matrix = NalgebraMat<f64>;

/// The experiment with the derivative of its friction, which implicit methods need.
fn problem(
    experiment: &Experiment,
) -> Result<
    OdeSolverProblem<
        impl OdeEquationsImplicit<M = Matrix, V = NalgebraVec<f64>, C = NalgebraContext, T = f64>,
    >,
    DiffsolError,
> {
    let acceleration = experiment.acceleration();
    let [spring, stokes, _, newton] = experiment.coefficients();
    let release = experiment.position;
    OdeBuilder::<Matrix>::new()
        .rtol(RTOL)
        .atol([ATOL, ATOL])
        .rhs_implicit(
            move |state, _p, _t, rate| {
                rate[0] = state[1];
                rate[1] = acceleration(state[0], state[1]);
            },
            move |state, _p, _t, change, rate| {
                rate[0] = change[1];
                let slope = stokes + 2.0 * newton * state[1].abs();
                rate[1] = -spring * change[0] - slope * change[1];
            },
        )
        .init(
            move |_p, _t, state| {
                state[0] = release;
                state[1] = 0.0;
            },
            2,
        )
        .build()
}

/// Steps and reads the dense output. `solve_dense` does the same but knows no largest number of
/// steps, and an explicit method would step for ever where dry friction stops the mass.
fn solve<'a, E>(
    mut solver: impl OdeSolverMethod<'a, E>,
    times: &[f64],
    keep: bool,
) -> Result<Record, String>
where
    E: OdeEquations<M = Matrix, V = NalgebraVec<f64>, C = NalgebraContext, T = f64> + 'a,
{
    let mut state = NalgebraVec::zeros(2, NalgebraContext::default());
    let mut states = Vec::with_capacity(times.len());
    solver.set_stop_time(times[times.len() - 1]).map_err(text)?;
    let mut steps = 0;
    for &time in times {
        while solver.state().t < time {
            solver.step().map_err(text)?;
            steps += 1;
            if steps > STEPS {
                let reached = solver.state().t;
                return Err(format!(
                    "more than {STEPS} steps at t = {reached} s (limit of the bench)"
                ));
            }
        }
        solver.interpolate_inplace(time, &mut state).map_err(text)?;
        states.push([state[0], state[1]]);
    }
    Ok(record(states.iter(), keep, |state| state[0]))
}

fn text(error: DiffsolError) -> String {
    error.to_string()
}

pub fn tsit45(experiment: &Experiment, times: &[f64], keep: bool) -> Result<Record, String> {
    let problem = problem(experiment).map_err(text)?;
    solve(problem.tsit45().map_err(text)?, times, keep)
}

pub fn bdf(experiment: &Experiment, times: &[f64], keep: bool) -> Result<Record, String> {
    let problem = problem(experiment).map_err(text)?;
    solve(problem.bdf::<NalgebraLU<f64>>().map_err(text)?, times, keep)
}

/// Position at `time` alone by backward differentiation.
///
/// # Errors
/// What the integrator says.
pub fn stiff_state(experiment: &Experiment, time: f64) -> Result<f64, String> {
    bdf(experiment, &[time], true).map(|record| record.positions[0])
}
