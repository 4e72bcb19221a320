//! How much of the lost energy each law took: which one dominates.

use crate::Parameters;

/// The shares of Stokes, Coulomb and Newton friction in the energy that the motion loses within `duration`
/// (s) of its beginning, from the work of each law along it; they add up to one. None if nothing is lost.
pub fn shares(parameters: &Parameters, duration: f64) -> Option<[f64; 3]> {
    let motion = parameters.motion(parameters.coulomb_acceleration).ok()?;
    let heat = motion.ledger(&[duration]).ok()?.first()?.heat;
    let total = heat.total();
    (total > 0.0).then(|| [heat.stokes, heat.coulomb, heat.newton].map(|one| one / total))
}
