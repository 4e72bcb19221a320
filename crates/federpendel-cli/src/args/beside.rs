//! What was measured beside a recording, as written.

use clap::ArgMatches;

use super::text;

/// The flags of `fit` that physical numbers are made from.
#[derive(Debug)]
pub struct Beside {
    /// Mass of the body.
    pub mass: Option<String>,
    /// Stiffness of the spring.
    pub stiffness: Option<String>,
    /// Mass of the spring.
    pub spring_mass: Option<String>,
    /// Normal force.
    pub normal_force: Option<String>,
    /// Whether the weight of the body is the normal force.
    pub horizontal: bool,
    /// Gravity.
    pub gravity: Option<String>,
}

impl Beside {
    pub(super) fn new(matches: &ArgMatches) -> Self {
        Beside {
            mass: text(matches, "mass"),
            stiffness: text(matches, "stiffness"),
            spring_mass: text(matches, "spring-mass"),
            normal_force: text(matches, "normal-force"),
            horizontal: matches.get_flag("horizontal"),
            gravity: text(matches, "gravity"),
        }
    }
}
