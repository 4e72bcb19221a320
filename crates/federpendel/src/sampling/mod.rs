//! Whole records: positions and velocities at many times, swing after swing, several at once.

mod carry;
mod grid;
mod kernel;
pub(crate) mod lanes;
mod steps;
mod times;

use crate::error::Result;
use crate::motion::Motion;

pub(crate) use grid::Grid;
pub(crate) use times::Times;

/// Samples the times in order and puts them back where they belong: going to and fro, nearly every time
/// would need its swing anew.
fn fill_unsorted(
    motion: &Motion,
    times: &[f64],
    positions: &mut [f64],
    velocities: &mut [f64],
) -> Result<()> {
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_unstable_by(|&i, &j| times[i].total_cmp(&times[j]));
    let sorted: Vec<f64> = order.iter().map(|&i| times[i]).collect();
    let (mut xs, mut vs) = (vec![0.0; times.len()], vec![0.0; times.len()]);
    fill(motion, &Times::Any(&sorted), &mut xs, &mut vs)?;
    for (&i, (x, v)) in order.iter().zip(xs.into_iter().zip(vs)) {
        (positions[i], velocities[i]) = (x, v);
    }
    Ok(())
}

/// The vector instructions of this machine. In a browser plain numbers: two kinds of code would be too much to send.
pub(crate) fn arch() -> pulp::Arch {
    #[cfg(target_family = "wasm")]
    return pulp::Arch::Scalar;
    #[cfg(not(target_family = "wasm"))]
    pulp::Arch::new()
}

/// Steps back in time after which the times are sorted.
const PATIENCE: usize = 8;

/// Fills the buffers, which are as long as `times`.
pub(crate) fn fill(
    motion: &Motion,
    times: &Times,
    positions: &mut [f64],
    velocities: &mut [f64],
) -> Result<()> {
    let arch = arch();
    let mut cursor = motion.cursor(true);
    let (mut first, mut steps_back) = (0, 0);
    while first < positions.len() {
        let time = times.check(first)?;
        steps_back += usize::from(time < cursor.from());
        if let (Times::Any(times), true) = (times, steps_back > PATIENCE) {
            return fill_unsorted(motion, times, positions, velocities);
        }
        cursor.seek(motion.chain(), time)?;
        // Carried on, the formula of a swing goes beyond its end.
        let until = if times.carried().is_some() { cursor.formula_until() } else { cursor.until() };
        let end = times.run_end(first, cursor.from(), until);
        arch.dispatch(kernel::Run {
            cursor: &cursor,
            reduced: motion.oscillator().reduced(),
            times,
            first,
            positions: &mut positions[first..end],
            velocities: &mut velocities[first..end],
        });
        first = end;
    }
    Ok(())
}
