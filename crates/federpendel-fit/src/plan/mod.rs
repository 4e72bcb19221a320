//! How to record a free decay so that the laws of friction separate: from how far to release the mass, and how long to
//! record it.
//!
//! A fit cannot be better than Fisher's information in the recording allows (`information`), and the fits here are as
//! good as that. So for each amplitude of release the motion that is expected is computed, with its derivatives, as far
//! as it can be told from rest, and the standard errors of the coefficients follow for a recording of every length.
//!
//! ```
//! use federpendel::{Mix, Oscillator, Stokes};
//! use federpendel_fit::Quantity;
//! use federpendel_fit::plan::{Setup, plan};
//!
//! let setup = Setup {
//!     oscillator: Oscillator::new(0.5, 20.0, Stokes::new(0.02)?)?,
//!     also: Mix::default(),
//!     quantity: Quantity::Position,
//!     noise: 1e-3,
//!     rate: 50.0,
//!     min_amplitude: None,
//!     max_amplitude: 0.1,
//!     longest: Some(20.0),
//! };
//! let plan = plan(&setup)?;
//! let advice = plan.advice().expect("10 cm show it");
//! assert!(advice.amplitude < 0.02 && advice.duration <= 20.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod law;
mod release;
mod setup;
mod steps;

pub use error::PlanError;
pub use law::Law;
pub use setup::Setup;

use federpendel::Mix;

use crate::model::ModelError;
use crate::start;
use release::Release;
use steps::{rounded_up, steps};

/// A law is resolved where its coefficient is at least so many standard errors from zero.
pub const RESOLVED: f64 = 5.0;

/// A law drowns in the noise where its coefficient is less than so many standard errors from zero.
pub const DROWNED: f64 = 2.0;

/// More time pays while it makes the standard error smaller by more than this factor.
pub const PAYS: f64 = 1.05;

/// How far beyond the largest amplitude one is looked for that would resolve a law, as a factor.
const BEYOND: f64 = 100.0;

/// How well a coefficient would be known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    /// Length of the recording, s: any longer one has a standard error at most 5 % smaller.
    pub duration: f64,
    /// Standard error, in the unit of the coefficient.
    pub stderr: f64,
    /// The coefficient over its standard error.
    pub significance: f64,
}

/// What a release from one amplitude tells.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The amplitude, m.
    pub amplitude: f64,
    /// The longest recording that was looked at, s: until a period after the rest, until the amplitude has fallen to the
    /// noise, or the limit; zero if the mass rests within five swings, which no fit can be trusted on.
    pub longest: f64,
    /// How well the coefficients of Stokes, Coulomb and Newton friction are known; none for laws that are not expected,
    /// and where nothing is known.
    pub laws: [Option<Resolution>; 3],
}

/// What it takes to see an expected law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prospect {
    /// The law.
    pub law: Law,
    /// Its coefficient.
    pub coefficient: f64,
    /// The smallest amplitude of the plan from which on every larger one resolves it, and how well it is known there.
    pub smallest: Option<(f64, Resolution)>,
    /// Up to this amplitude it drowns in the noise; none if it does not even at the smallest.
    pub drowned: Option<f64>,
    /// How well it is known at the largest amplitude.
    pub largest: Option<Resolution>,
    /// The first amplitude beyond the largest that would resolve it, where that does not.
    pub beyond: Option<f64>,
}

impl Prospect {
    /// So many times less noise would resolve it at the largest amplitude, or the square of that times the rate: a
    /// number with two digits, not below what it takes; none where nothing is known.
    pub fn noise_factor(&self) -> Option<f64> {
        self.largest.map(|largest| rounded_up(RESOLVED / largest.significance))
    }
}

/// Two expected laws at the largest amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// The laws.
    pub laws: [Law; 2],
    /// Correlation of their coefficients.
    pub correlation: f64,
    /// Whether both are resolved there.
    pub separated: bool,
}

/// How small a coefficient could be and yet be seen, of a law that is not expected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// The law.
    pub law: Law,
    /// Length of the recording, s.
    pub duration: f64,
    /// Standard error of the coefficient beside all expected laws at the largest amplitude.
    pub stderr: f64,
}

impl Limit {
    /// The coefficient that would be resolved.
    pub fn resolved(&self) -> f64 {
        RESOLVED * self.stderr
    }

    /// What it is below with a probability of 95 %, if the fit finds zero: one-sided, since it cannot be negative.
    pub fn upper95(&self) -> f64 {
        1.644854 * self.stderr
    }
}

/// What to do, so that all laws that can be resolved are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advice {
    /// Release from here, m.
    pub amplitude: f64,
    /// Record so long, s.
    pub duration: f64,
    /// The laws that are resolved then.
    pub laws: Mix,
}

/// A plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What it is for.
    pub setup: Setup,
    /// What each amplitude tells, the smallest first.
    pub rows: Vec<Row>,
    /// The laws that are expected.
    pub prospects: Vec<Prospect>,
    /// Pairs of them.
    pub pairs: Vec<Pair>,
    /// The laws that are not expected.
    pub limits: Vec<Limit>,
}

/// The plan for an experiment.
///
/// # Errors
/// [`PlanError`] if something is out of range, if nothing would be seen, or if the motion cannot be computed.
pub fn plan(setup: &Setup) -> Result<Plan, PlanError> {
    setup.check()?;
    let (expected, fitted) = (setup.expected(), setup.fitted());
    let amplitudes = steps(setup.smallest(), setup.max_amplitude);
    let rows = amplitudes.into_iter().map(|amplitude| row(setup, amplitude));
    let rows = rows.collect::<Result<Vec<_>, _>>()?;
    let largest = Release::new(setup, setup.max_amplitude)?;
    let acting = || Law::ALL.into_iter().filter(|law| law.is_in(expected));
    let prospects: Vec<_> = acting().map(|law| prospect(setup, &rows, law)).collect();
    let resolved = |law: Law| prospects.iter().any(|one| one.law == law && one.smallest.is_some());
    let mut pairs = Vec::new();
    for (i, one) in acting().enumerate() {
        for other in acting().skip(i + 1) {
            let laws = [one, other];
            let Some(correlation) = largest.correlation(laws, fitted) else { continue };
            pairs.push(Pair { laws, correlation, separated: laws.into_iter().all(resolved) });
        }
    }
    let absent = Law::ALL.into_iter().filter(|law| !law.is_in(expected));
    let limit = |law| {
        let Resolution { duration, stderr, .. } = largest.resolution(law, 0.0, fitted)?;
        Some(Limit { law, duration, stderr })
    };
    let limits = absent.filter_map(limit).collect();
    Ok(Plan { setup: *setup, rows, prospects, pairs, limits })
}

/// What a release from this amplitude tells.
fn row(setup: &Setup, amplitude: f64) -> Result<Row, ModelError> {
    let release = Release::new(setup, amplitude)?;
    let laws = Law::ALL.map(|law| {
        let coefficient = law.coefficient(&setup.oscillator);
        let expected = law.is_in(setup.expected());
        expected.then(|| release.resolution(law, coefficient, setup.fitted())).flatten()
    });
    Ok(Row { amplitude, longest: release.longest(), laws })
}

fn significance(row: &Row, law: Law) -> f64 {
    row.laws[law as usize].map_or(0.0, |resolution| resolution.significance)
}

fn prospect(setup: &Setup, rows: &[Row], law: Law) -> Prospect {
    // Where the number of swings until rest changes, more amplitude may tell less: what counts is that all from here on
    // are good.
    let good = rows.iter().rev().take_while(|row| significance(row, law) >= RESOLVED);
    let smallest = good.last().and_then(|row| Some((row.amplitude, row.laws[law as usize]?)));
    let bad = rows.iter().take_while(|row| significance(row, law) < DROWNED);
    let largest = rows.last().and_then(|row| row.laws[law as usize]);
    let beyond = || {
        let mut amplitudes =
            steps(setup.max_amplitude, BEYOND * setup.max_amplitude).into_iter().skip(1);
        amplitudes.find(|&amplitude| {
            row(setup, amplitude).is_ok_and(|row| significance(&row, law) >= RESOLVED)
        })
    };
    Prospect {
        law,
        coefficient: law.coefficient(&setup.oscillator),
        smallest,
        drowned: bad.last().map(|row| row.amplitude),
        largest,
        beyond: if smallest.is_none() { beyond() } else { None },
    }
}

impl Plan {
    /// What to do; none if no law is expected, or none can be resolved.
    pub fn advice(&self) -> Option<Advice> {
        let seen = self.prospects.iter().filter_map(|one| Some((one.law, one.smallest?.0)));
        let seen: Vec<(Law, f64)> = seen.collect();
        let amplitude = seen.iter().map(|(_, amplitude)| *amplitude).reduce(f64::max)?;
        let row = self.rows.iter().find(|row| row.amplitude == amplitude)?;
        let durations = seen.iter().filter_map(|(law, _)| row.laws[*law as usize]);
        let duration = durations.map(|resolution| resolution.duration).reduce(f64::max)?;
        let laws = start::mix(Law::ALL.map(|law| seen.iter().any(|(other, _)| *other == law)));
        Some(Advice { amplitude, duration, laws })
    }
}
