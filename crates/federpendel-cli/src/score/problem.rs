//! The problems of `reference/`, kept in the program.

use federpendel::{
    Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, Result, State, Stokes,
};
use serde::{Deserialize, Deserializer};

/// The files as they are; only `score` reads them, and only then.
const FILES: [&str; 8] = [
    include_str!("../../../../reference/undamped.json"),
    include_str!("../../../../reference/stokes.json"),
    include_str!("../../../../reference/coulomb.json"),
    include_str!("../../../../reference/newton.json"),
    include_str!("../../../../reference/stokes-coulomb.json"),
    include_str!("../../../../reference/stokes-newton.json"),
    include_str!("../../../../reference/coulomb-newton.json"),
    include_str!("../../../../reference/stokes-coulomb-newton.json"),
];

#[derive(Deserialize)]
struct Collection<'a> {
    mix: &'a str,
    #[serde(borrow)]
    problems: Vec<Problem<'a>>,
}

/// A problem with its stored answers.
#[derive(Debug, Deserialize)]
pub(crate) struct Problem<'a> {
    /// Which laws act, as its file is called.
    #[serde(skip)]
    pub mix: &'a str,
    /// Its name, unique in all files.
    pub name: &'a str,
    /// What it is there to try.
    pub corner: &'a str,
    /// What it is, in the English of its file.
    pub description: &'a str,
    oscillator: Given,
    release: Release,
    /// Its stored answers.
    #[serde(borrow)]
    pub samples: Vec<Stored<'a>>,
}

#[derive(Debug, Deserialize)]
struct Given {
    #[serde(deserialize_with = "number")]
    mass: f64,
    #[serde(deserialize_with = "number")]
    stiffness: f64,
    #[serde(default, deserialize_with = "given")]
    gravity: Option<f64>,
    #[serde(default, deserialize_with = "given")]
    normal_force: Option<f64>,
    #[serde(default, deserialize_with = "given")]
    damping: Option<f64>,
    #[serde(default, deserialize_with = "given")]
    kinetic: Option<f64>,
    #[serde(default, rename = "static", deserialize_with = "given")]
    static_: Option<f64>,
    #[serde(default, deserialize_with = "given")]
    newton_coefficient: Option<f64>,
}

#[derive(Debug, Deserialize)]
struct Release {
    #[serde(deserialize_with = "number")]
    position: f64,
    #[serde(deserialize_with = "number")]
    velocity: f64,
}

/// The state at one time, 36 digits rounded to the nearest doubles.
#[derive(Debug, Deserialize)]
pub(crate) struct Stored<'a> {
    /// The time as it is written, the shortest text that reads back as the same double.
    #[serde(rename = "time")]
    pub written: &'a str,
    /// Position, m.
    #[serde(deserialize_with = "number")]
    pub position: f64,
    /// Velocity, m/s.
    #[serde(deserialize_with = "number")]
    pub velocity: f64,
}

/// A number in a text, whose decimal digits read back as the double that is meant.
fn number<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<f64, D::Error> {
    <&str>::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
}

fn given<'de, D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Option<f64>, D::Error> {
    number(deserializer).map(Some)
}

impl Problem<'static> {
    /// All of them, mix by mix. What the files hold a test has read.
    pub(crate) fn all() -> Vec<Self> {
        let collections =
            FILES.iter().filter_map(|file| serde_json::from_str::<Collection>(file).ok());
        collections
            .flat_map(|Collection { mix, problems }| {
                problems.into_iter().map(move |problem| Problem { mix, ..problem })
            })
            .collect()
    }
}

impl Problem<'_> {
    /// Whether `part` stands in its name, mix, corner or description.
    pub(crate) fn holds(&self, part: &str) -> bool {
        let part = part.to_lowercase();
        [self.name, self.mix, self.corner, self.description]
            .iter()
            .any(|text| text.to_lowercase().contains(&part))
    }

    /// Its exact motion.
    ///
    /// # Errors
    /// None for the files as they are.
    pub(crate) fn motion(&self) -> Result<Motion> {
        let given = &self.oscillator;
        let normal_force = match given.gravity {
            Some(gravity) => NormalForce::Weight(gravity),
            None => NormalForce::Given(given.normal_force.unwrap_or(0.0)),
        };
        let kinetic = given.kinetic.unwrap_or(0.0);
        let static_ = given.static_.unwrap_or(kinetic);
        let friction = Friction {
            stokes: given.damping.map(Stokes::new).transpose()?,
            coulomb: (static_ > 0.0)
                .then(|| Coulomb::new(kinetic, static_, normal_force))
                .transpose()?,
            newton: given.newton_coefficient.map(Newton::new).transpose()?,
        };
        let oscillator = Oscillator::new(given.mass, given.stiffness, friction)?;
        Motion::new(oscillator, State::new(self.release.position, self.release.velocity)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_problem_is_read_with_its_mix_and_makes_a_motion() {
        let problems = Problem::all();
        assert_eq!(problems.len(), 356);
        for problem in &problems {
            let mix = problem.motion().unwrap_or_else(|error| panic!("{}: {error}", problem.name));
            let named = match mix.oscillator().friction().mix().to_string().as_str() {
                "none" => "undamped".to_owned(),
                laws => laws.replace('+', "-"),
            };
            assert_eq!(named, problem.mix, "{}", problem.name);
            for stored in &problem.samples {
                let time: f64 = stored.written.parse().expect("a time");
                assert!(time >= 0.0, "{}", problem.name);
            }
        }
    }
}
