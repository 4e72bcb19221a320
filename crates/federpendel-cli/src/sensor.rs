//! A sensor with noise, so that a simulated motion can stand for a recording.

use federpendel::Sample;
use federpendel::parameter::{ParameterInfo, Range};
use federpendel_fit::Quantity;
use federpendel_text::Catalogue;
use rand_distr::{Distribution, Normal};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;

use crate::failure::Failure;
use crate::quantity::Dimension;
use crate::words::flag_value_of;

/// Standard deviation of the noise; its unit is that of what is recorded.
pub(crate) const NOISE: ParameterInfo = ParameterInfo {
    name: "noise",
    symbol: "σ",
    unit: "m",
    range: Range::NonNegative,
    default: None,
};

/// What can be recorded, and what it is measured in.
const KINDS: [(Quantity, Dimension); 3] = [
    (Quantity::Position, Dimension::Length),
    (Quantity::Velocity, Dimension::Velocity),
    (Quantity::Acceleration, Dimension::Acceleration),
];

/// What is recorded, and the standard deviation of its noise as `written` (SI); the unit says what, unless that is given
/// already.
///
/// # Errors
/// What is wrong with it; allowed are the units of all that can be recorded, or of what is given.
pub(crate) fn noise(
    written: &str,
    given: Option<Quantity>,
    info: &ParameterInfo,
    catalogue: &Catalogue,
) -> Result<(Quantity, f64), Failure> {
    let known =
        KINDS.into_iter().filter(|(quantity, _)| given.is_none_or(|given| given == *quantity));
    let (quantities, dimensions): (Vec<_>, Vec<_>) = known.unzip();
    let (dimension, deviation) =
        flag_value_of(catalogue, info, &dimensions, written).map_err(Failure::Input)?;
    let fits = |(_, one): &(&Quantity, &Dimension)| **one == dimension;
    let found = quantities.iter().zip(&dimensions).find(fits);
    let quantity = found.map_or(Quantity::Position, |(quantity, _)| *quantity);
    Ok((quantity, deviation))
}

/// A sensor: what it records, and how noisily.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sensor {
    recorded: Quantity,
    /// Standard deviation of its noise, in the SI unit of what it records.
    deviation: f64,
    seed: u64,
}

impl Sensor {
    /// The sensor with noise as `written`, whose unit says what it records: “1 mm” positions, “1 mm/s” velocities. A bare
    /// number is metres.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(crate) fn named(written: &str, seed: u64, catalogue: &Catalogue) -> Result<Self, Failure> {
        let (recorded, deviation) = noise(written, None, &NOISE, catalogue)?;
        Ok(Sensor { recorded, deviation, seed })
    }

    /// The header of its column.
    pub(crate) fn column(&self) -> &'static str {
        match self.recorded {
            Quantity::Position => "Position (m)",
            Quantity::Velocity => "Velocity (m/s)",
            Quantity::Acceleration => "Acceleration (m/s^2)",
        }
    }

    /// What it records of these samples: times (s) and values with independent normal noise. The same seed gives the
    /// same noise on every machine.
    pub(crate) fn record(&self, samples: &[Sample]) -> impl Iterator<Item = [f64; 2]> {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(self.seed);
        let (recorded, deviation) = (self.recorded, self.deviation);
        // The standard deviation is finite and not negative, so it is one.
        let normal = Normal::new(0.0, deviation).ok();
        samples.iter().map(move |sample| {
            let value = match recorded {
                Quantity::Position => sample.position,
                Quantity::Velocity => sample.velocity,
                Quantity::Acceleration => sample.acceleration,
            };
            let noise = normal.map_or(0.0, |normal| normal.sample(&mut random));
            [sample.time, value + noise]
        })
    }
}
