//! What was measured beside a recording, as written.

use clap::ArgMatches;

use super::text;
use crate::quantity::inputs::Beside;

/// The flags of `fit` that physical numbers are made from.
pub(super) fn beside(matches: &ArgMatches) -> Beside {
    Beside {
        mass: text(matches, "mass"),
        stiffness: text(matches, "stiffness"),
        spring_mass: text(matches, "spring-mass"),
        normal_force: text(matches, "normal-force"),
        horizontal: matches.get_flag("horizontal"),
        gravity: text(matches, "gravity"),
    }
}
