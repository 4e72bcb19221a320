//! What a user may choose about a fit.

use federpendel::Mix;

pub use crate::bootstrap::Bootstrap;
pub use crate::problem::Loss;

/// How the 95 % intervals of the verdict's mix are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Intervals {
    /// From the standard errors.
    Covariance,
    /// From the profile of the sum of squares: they need not be symmetric.
    #[default]
    Profile,
    /// From refits to residuals drawn anew.
    Bootstrap(Bootstrap),
}

/// The laws that a fit may find.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Laws {
    /// Those that the recording shows, of these; every part of them is fitted.
    Among(Mix),
    /// All of these, whether the recording shows them or not; the parts of them are fitted beside.
    Exactly(Mix),
}

impl Laws {
    /// All that may act.
    pub fn mix(self) -> Mix {
        let (Laws::Among(mix) | Laws::Exactly(mix)) = self;
        mix
    }
}

/// Choices for [`crate::fit()`].
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The laws.
    pub laws: Laws,
    /// Time at which the free decay begins, s; found if not given.
    pub from: Option<f64>,
    /// Time at which it ends, s; found if not given.
    pub to: Option<f64>,
    /// Standard deviation of a value, if known: χ² is measured in it. Uncertainties come from the
    /// residuals.
    pub sigma: Option<f64>,
    /// How residuals count.
    pub loss: Loss,
    /// How intervals are found.
    pub intervals: Intervals,
    /// Whether they are found so for every mix; else the mixes beside the verdict's have those from
    /// their standard errors.
    pub every_mix: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            laws: Laws::Among(Mix { stokes: true, coulomb: true, newton: true }),
            from: None,
            to: None,
            sigma: None,
            loss: Loss::Squares,
            intervals: Intervals::Profile,
            every_mix: false,
        }
    }
}
