//! The energy ledger: where the energy of the release is, and what each law turned into heat.

use crate::error::Result;
use crate::motion::Motion;

/// Heat made by each law since the release, J. Each from its own work integral.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Heat {
    /// ∫ D v² dt.
    pub stokes: f64,
    /// ∫ μ F_N |v| dt.
    pub coulomb: f64,
    /// ∫ ½ρc_wA |v|³ dt.
    pub newton: f64,
}

impl Heat {
    /// Heat of all laws together, J.
    pub fn total(&self) -> f64 {
        self.stokes + self.coulomb + self.newton
    }
}

/// Where the energy is at one time, J.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ledger {
    /// Time, s.
    pub time: f64,
    /// Kinetic energy ½mv².
    pub kinetic: f64,
    /// Potential energy ½Cx².
    pub potential: f64,
    /// Heat of each law.
    pub heat: Heat,
}

impl Motion {
    /// Energy of the release, J.
    pub fn initial_energy(&self) -> f64 {
        self.oscillator().energy(self.release())
    }

    /// The ledger at each of `times` (s), which must not fall.
    ///
    /// # Errors
    /// As [`Motion::at`].
    pub fn ledger(&self, _times: &[f64]) -> Result<Vec<Ledger>> {
        todo!()
    }
}
