//! What was recorded, ready to be fitted.

/// What a recording holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Position.
    Position,
    /// Velocity.
    Velocity,
    /// Acceleration.
    Acceleration,
}

/// A recording: one quantity at rising times.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Times, s, rising strictly; they need not be even.
    pub times: Vec<f64>,
    /// The value at each time, finite; in SI where the unit is known, else in units of the
    /// recording.
    pub values: Vec<f64>,
    /// What the values are.
    pub quantity: Quantity,
    /// Unit of the values: an SI unit if it is understood, else what the file says; empty if it
    /// says nothing.
    pub unit: String,
}
