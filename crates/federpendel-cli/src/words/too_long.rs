//! Sentences about steps that are too long.

use federpendel_text::Catalogue;

use crate::record::TooLong;

/// Digits of a time step.
const DIGITS: usize = 3;

/// Which step is too long, and which would be safe.
pub(crate) fn too_long_step(catalogue: &Catalogue, problem: TooLong) -> String {
    let time = |time: f64| catalogue.quantity(time, "s", DIGITS).into();
    match problem {
        TooLong::Unstable { time_step, longest, proposed } => catalogue.format(
            "step-unstable",
            &[("step", time(time_step)), ("longest", time(longest)), ("proposed", time(proposed))],
        ),
        TooLong::Coarse { time_step, proposed } => catalogue
            .format("step-coarse", &[("step", time(time_step)), ("proposed", time(proposed))]),
    }
}
