//! Whole records: positions and velocities at many times, swing after swing, several at once.

mod grid;
mod kernel;
pub(crate) mod lanes;
mod times;

use crate::error::Result;
use crate::motion::Motion;

pub(crate) use grid::Grid;
pub(crate) use times::Times;

/// Fills the buffers, which are as long as `times`.
pub(crate) fn fill(
    motion: &Motion,
    times: &Times,
    positions: &mut [f64],
    velocities: &mut [f64],
) -> Result<()> {
    let arch = pulp::Arch::new();
    let mut cursor = motion.cursor(true);
    let mut first = 0;
    while first < positions.len() {
        let time = times.check(first)?;
        cursor.seek(motion.chain(), time)?;
        let end = times.run_end(first, cursor.from(), cursor.until());
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
