//! A motion and what the page draws of it.

use std::cell::OnceCell;

use federpendel::scheme::Setting;
use federpendel::{
    Ledger, Motion, Oscillator, Outcome, Regime, Result, Sample, State, TurningPoint, motion,
};
use federpendel_text::Catalogue;
use federpendel_text::plot::{AveragedLaw, DecrementData, Plot, swings};
use serde::Serialize;

use crate::decrement::Decrement;
use crate::experiment::Experiment;

/// An experiment and its motion.
#[derive(Debug)]
pub struct Solution {
    motion: Motion,
    duration: f64,
    weight: f64,
    /// All turning points of the record, once they have been asked for.
    walked: OnceCell<Vec<TurningPoint>>,
}

/// How the motion is known, how it ends, and the numbers that follow from the experiment, SI.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Summary {
    /// How it is known, in words.
    pub kind: String,
    /// Where and when the mass comes to rest, if it does.
    pub rests: Option<Rests>,
    /// ω0, 1/s.
    pub angular_frequency: f64,
    /// Name, symbol and value of what follows from mass, spring and friction, as `simulate --details` has it.
    pub derived: Vec<(String, &'static str, String)>,
    /// The offset of dry friction f, m.
    pub offset: f64,
    /// Half the width of the sticking band, m.
    pub sticking_offset: f64,
    /// The larger of |x0| and |v0|/ω0, m.
    pub amplitude: f64,
    /// The energy of the release, J.
    pub energy: f64,
    /// A length of record that shows the motion, s.
    pub suggested_duration: f64,
    /// The step of numeric methods when none is given, s.
    pub time_step: f64,
    /// How it ends, in a sentence or two.
    pub sentence: String,
}

/// A rest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Rests {
    /// When, s.
    pub time: f64,
    /// Where, m.
    pub position: f64,
    /// After how many swings.
    pub swings: u64,
}

/// Which of the three cases of the textbooks it is, where Stokes friction acts alone.
fn regime(oscillator: &Oscillator, catalogue: &Catalogue) -> Option<String> {
    let mix = oscillator.friction().mix();
    let id = match oscillator.regime() {
        _ if mix.coulomb || mix.newton => return None,
        Regime::Undamped => return None,
        Regime::Underdamped => "regime-sentence-underdamped",
        Regime::Critical => "regime-sentence-critical",
        Regime::Overdamped => "regime-sentence-overdamped",
    };
    let ratio = catalogue.number(oscillator.damping_ratio(), 3);
    Some(catalogue.format(id, &[("ratio", ratio.into())]))
}

/// So many swings are followed where each is computed: a fraction of a second in a browser, and more than a plot shows.
const MOST_SWINGS: u64 = 25_000;

/// Digits of what is derived.
const DIGITS: usize = 9;

/// Most turning points that are looked at for the decrement.
const MOST_TURNS: usize = 2000;

impl Solution {
    /// Solves an experiment.
    ///
    /// # Errors
    /// The first value that the core refuses, or a record of more swings than a page can follow.
    pub fn new(experiment: &Experiment) -> Result<Self> {
        let motion = experiment.motion()?.with_most_swings(MOST_SWINGS);
        // What cannot be followed to the end of the record is refused here, and nowhere later.
        motion.at(experiment.duration)?;
        let (duration, weight) = (experiment.duration, experiment.weight()?);
        Ok(Self { motion, duration, weight, walked: OnceCell::new() })
    }

    /// The motion.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Length of the record, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// How the motion is known and how it ends.
    pub fn summary(&self, catalogue: &Catalogue) -> Summary {
        let oscillator = self.motion.oscillator();
        let outcome = self.motion.outcome();
        let rests = match outcome {
            Outcome::Rests(rest) => {
                Some(Rests { time: rest.time, position: rest.position, swings: rest.swings })
            }
            _ => None,
        };
        Summary {
            kind: catalogue.kind(self.motion.kind()),
            rests,
            angular_frequency: oscillator.angular_frequency(),
            derived: catalogue.derived(oscillator, DIGITS),
            offset: oscillator.offset(),
            sticking_offset: oscillator.sticking_offset(),
            amplitude: self.motion.amplitude(),
            energy: self.motion.initial_energy(),
            suggested_duration: self.motion.default_duration(),
            time_step: Setting::of(&self.motion).time_step(),
            sentence: self.sentence(&outcome, catalogue),
        }
    }

    /// How it ends, and what the reader should know of that.
    fn sentence(&self, outcome: &Outcome, catalogue: &Catalogue) -> String {
        let ends = [("outcome", catalogue.outcome(outcome).into())];
        let mut sentences = vec![catalogue.format("summary-sentence", &ends)];
        sentences.extend(regime(self.motion.oscillator(), catalogue));
        if let Outcome::Rests(rest) = outcome
            && rest.tie
        {
            let id = if rest.time == 0.0 { "summary-tie-at-release" } else { "summary-tie" };
            sentences.push(catalogue.text(id));
        }
        sentences.join(" ")
    }

    /// Times, positions, velocities and accelerations at `count` even times, one behind the other.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn samples(&self, from: f64, to: f64, count: usize) -> Result<Vec<f64>> {
        Ok(sample_columns(&self.motion.samples(&times(from, to, count))?))
    }

    /// x, v, a, the forces of spring, weight, Stokes, Coulomb and Newton friction along the motion, their sum, and 1 if the
    /// mass rests.
    ///
    /// Where the mass hangs, x counts from where it hangs at rest: there the spring is m g/C longer than relaxed and carries
    /// the weight, so at x it pulls with −C x − m g.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn at(&self, time: f64) -> Result<Vec<f64>> {
        let sample = self.motion.at(time)?;
        let forces = self.motion.forces(&sample);
        let sticking = f64::from(u8::from(sample.mode == motion::Mode::Stuck));
        let (x, a) = (sample.position, sample.acceleration);
        let v = if self.stands(time, a, sample.velocity) { 0.0 } else { sample.velocity };
        let sum = forces.sum();
        Ok(vec![
            x,
            v,
            a,
            forces.spring - self.weight,
            self.weight,
            forces.stokes,
            forces.coulomb,
            forces.newton,
            sum,
            sticking,
        ])
    }

    /// Whether a velocity is zero as far as the time can say: a turning point is seldom at a time that an `f64` holds, and
    /// beside it the velocity is what is gained since, or is left until then.
    fn stands(&self, time: f64, acceleration: f64, velocity: f64) -> bool {
        velocity.abs() <= 4.0 * f64::EPSILON * (time * acceleration).abs()
    }

    /// Times and places of the turning points of the record, one behind the other; at most `most` of them. The release is
    /// one too where the mass is at rest then.
    pub fn turning_points(&self, most: usize) -> Vec<f64> {
        let points: Vec<_> = self.turns().take(most).collect();
        let places = points.iter().map(|point| point.position);
        points.iter().map(|point| point.time).chain(places).collect()
    }

    /// Times, kinetic and potential energy, and the heat of Stokes, Coulomb and Newton friction until then, at `count`
    /// even times from the release to `to`, one behind the other.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn ledger(&self, to: f64, count: usize) -> Result<Vec<f64>> {
        Ok(ledger_columns(&self.motion.ledger(&times(0.0, to, count))?))
    }

    /// The turning points of the record; the release is one too where the mass is at rest then.
    pub(crate) fn turns(&self) -> impl Iterator<Item = TurningPoint> {
        let State { position, velocity } = self.motion.release();
        let release = (velocity == 0.0).then_some(TurningPoint { time: 0.0, position });
        let all = release.into_iter().chain(self.motion.turning_points());
        all.take_while(|point| point.time <= self.duration)
    }

    /// The next two of them after a time. The first time asked, all swings are walked.
    pub(crate) fn next_turns(&self, time: f64) -> Vec<TurningPoint> {
        let all = self.walked.get_or_init(|| self.turns().collect());
        let next = all.partition_point(|point| point.time <= time);
        all[next..].iter().take(2).copied().collect()
    }

    /// What each swing of the record costs.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn decrement(&self, catalogue: &Catalogue) -> Result<Decrement> {
        let positions: Vec<_> = self.turns().take(MOST_TURNS).map(|point| point.position).collect();
        let mut swings = swings(&positions);
        if positions.len() == MOST_TURNS {
            swings = self.some_swings()?;
        }
        let law = AveragedLaw::of(self.motion.oscillator());
        let data = DecrementData { law, swings: &swings, mean_of: 1, length: "m" };
        Ok(Decrement::of(&Plot::decrement(catalogue, &data), &swings))
    }
}

/// `count` even times from `from` to `to`, both included.
pub(crate) fn times(from: f64, to: f64, count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    let time = |i| if i as f64 == last { to } else { from + (to - from) * (i as f64 / last) };
    (0..count).map(time).collect()
}

/// Times, positions, velocities and accelerations, one behind the other.
pub(crate) fn sample_columns(samples: &[Sample]) -> Vec<f64> {
    let column = |value: fn(&Sample) -> f64| samples.iter().map(value);
    column(|sample| sample.time)
        .chain(column(|sample| sample.position))
        .chain(column(|sample| sample.velocity))
        .chain(column(|sample| sample.acceleration))
        .collect()
}

/// Times, kinetic and potential energies, and the heats of the three laws, one behind the other.
pub(crate) fn ledger_columns(rows: &[Ledger]) -> Vec<f64> {
    let column = |value: fn(&Ledger) -> f64| rows.iter().map(value);
    column(|row| row.time)
        .chain(column(|row| row.kinetic))
        .chain(column(|row| row.potential))
        .chain(column(|row| row.heat.stokes))
        .chain(column(|row| row.heat.coulomb))
        .chain(column(|row| row.heat.newton))
        .collect()
}
