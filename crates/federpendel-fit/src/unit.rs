//! Units of what a fit finds, from the unit of what was recorded.

use crate::report::FitReport;
use crate::{Quantity, Recording};

/// What a unit of length is called where the recording names none.
pub const NAMELESS: &str = "u";

/// What a unit of length is divided by to be one of this quantity.
fn suffix(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Position => "",
        Quantity::Velocity => "/s",
        Quantity::Acceleration => "/s^2",
    }
}

/// The unit of the values of a recording.
pub fn unit_of_values(recording: &Recording) -> String {
    match recording.unit.as_str() {
        "" => format!("{NAMELESS}{}", suffix(recording.quantity)),
        unit => unit.to_owned(),
    }
}

impl FitReport {
    /// The unit of lengths that belongs to what was recorded: `m` for a velocity in m/s, `V·s` for one in
    /// volts, [`NAMELESS`] where the recording names none.
    pub fn length_unit(&self) -> String {
        let suffix = suffix(self.quantity);
        match self.unit.strip_suffix(suffix) {
            Some(length) => length.to_owned(),
            // A unit of the recording's own, as volts of a sensor of velocity.
            None => format!("{}·{}", self.unit, suffix.trim_start_matches('/')),
        }
    }

    /// The unit of a parameter, by its name.
    pub fn unit_of(&self, parameter: &str) -> String {
        let length = self.length_unit();
        match parameter {
            "coulomb_acceleration" | "static_acceleration" => format!("{length}/s^2"),
            "newton_rate" => format!("1/{length}"),
            "position0" => length,
            "velocity0" => format!("{length}/s"),
            "equilibrium" => self.unit.clone(),
            _ => "1/s".to_owned(),
        }
    }
}
