//! What happens during a recording.

use super::Parameters;

/// The swings of a motion as far as the recording goes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Course {
    /// The turning points after the first time and up to the last, the place of rest being the last of them. A
    /// recording holds one more swing than these, unless the mass rests.
    pub turning_points: Vec<TurningPoint>,
    /// Where the mass rests, if it does before the recording ends.
    pub rest: Option<Rest>,
}

impl Course {
    /// Number of swings in the recording, the last of which may be cut off by its end.
    pub fn swings(&self) -> usize {
        self.turning_points.len() + usize::from(self.rest.is_none())
    }
}

/// Where the mass reverses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningPoint {
    /// Time on the clock of the recording, s.
    pub time: f64,
    /// Position from the middle.
    pub position: f64,
}

/// Where the mass stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// Number of the turning point; 0 for a release that the mass never leaves.
    pub number: u64,
    /// Time on the clock of the recording, s.
    pub time: f64,
    /// Position from the middle.
    pub position: f64,
    /// Derivatives of the position with respect to the parameters.
    pub derivatives: [f64; Parameters::COUNT],
}
