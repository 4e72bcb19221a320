//! `differential-equations`: Dormand–Prince 5(4) and 8(5,3) with dense output at given times.

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};

use super::{ATOL, RTOL, Record, STEPS, record};
use crate::experiment::Experiment;

struct Equation<A>(A);

impl<A: Fn(f64, f64) -> f64> ODE<f64, [f64; 2]> for Equation<A> {
    fn diff(&self, _time: f64, state: &[f64; 2], rate: &mut [f64; 2]) {
        *rate = [state[1], (self.0)(state[0], state[1])];
    }
}

macro_rules! method {
    ($name:ident) => {
        pub fn $name(experiment: &Experiment, times: &[f64], keep: bool) -> Result<Record, String> {
            let equation = Equation(experiment.acceleration());
            let duration = times[times.len() - 1];
            IVP::ode(&equation, 0.0, duration, [experiment.position, 0.0])
                .t_eval(times)
                .method(ExplicitRungeKutta::$name().rtol(RTOL).atol(ATOL).max_steps(STEPS))
                .solve()
                .map(|solution| record(solution.y.iter(), keep, |state| state[0]))
                .map_err(|error| format!("{error:?}"))
        }
    };
}

method!(dopri5);
method!(dop853);
