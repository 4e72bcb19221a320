//! Names that files of every form use.

use federpendel::Mix;
use federpendel_fit::{Quantity, StopReason};

/// The laws of a mix.
pub(in crate::output) fn law_names(mix: Mix) -> Vec<&'static str> {
    let named = [(mix.stokes, "stokes"), (mix.coulomb, "coulomb"), (mix.newton, "newton")];
    named.into_iter().filter(|(acts, _)| *acts).map(|(_, name)| name).collect()
}

/// What was recorded.
pub(in crate::output) fn quantity_name(quantity: Quantity) -> &'static str {
    let named = crate::args::QUANTITIES.iter().find(|(_, known)| *known == quantity);
    named.map_or("position", |(name, _)| name)
}

/// Why a search ended.
pub(in crate::output) fn stop_name(reason: StopReason) -> &'static str {
    match reason {
        StopReason::Converged => "converged",
        StopReason::NoProgress => "no-progress",
        StopReason::StepLimit => "step-limit",
    }
}
