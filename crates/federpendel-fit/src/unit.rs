//! Units of what a fit finds, from the unit of what was recorded.

use crate::Quantity;
use crate::report::FitReport;

impl FitReport {
    /// The unit of lengths that belongs to what was recorded: `m` for a velocity in m/s, `V·s` for one in
    /// volts, `1` where the recording has no unit.
    pub fn length_unit(&self) -> String {
        let suffix = match self.quantity {
            Quantity::Position => "",
            Quantity::Velocity => "/s",
            Quantity::Acceleration => "/s^2",
        };
        match (self.unit.strip_suffix(suffix), self.unit.is_empty()) {
            (_, true) => "1".to_owned(),
            (Some(length), _) => length.to_owned(),
            // A unit of the recording's own, as volts of a sensor of velocity.
            (None, _) => format!("{}·{}", self.unit, suffix.trim_start_matches('/')),
        }
    }

    /// The unit of a parameter, by its name.
    pub fn unit_of(&self, parameter: &str) -> String {
        let length = self.length_unit();
        let per = |divisor: &str| format!("{length}/{divisor}");
        match parameter {
            "coulomb_acceleration" | "static_acceleration" => per("s^2"),
            // A pure number stays one.
            "newton_rate" if length == "1" => length,
            "newton_rate" => format!("1/{length}"),
            "position0" => length,
            "velocity0" => per("s"),
            "equilibrium" => self.unit.clone(),
            _ => "1/s".to_owned(),
        }
    }
}
