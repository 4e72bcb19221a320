//! Pictures of more swings than a screen has columns. Even samples of them alias: in their place stand the extremes of each
//! column, whole loops, and means over a period.

use std::f64::consts::PI;

use federpendel::{Heat, Kind, Ledger, Motion, Outcome, Result, TurningPoint};
use federpendel_text::plot::swings;

use crate::motion::{Solution, ledger_columns, sample_columns, times};

/// Samples that show a swing well enough.
const PER_SWING: f64 = 16.0;

/// Steps of the amplitude that a picture tells apart.
const STEPS: f64 = 128.0;

/// Samples of a whole loop.
const SIDES: usize = 64;

/// Phases over which an energy is averaged: of a cosine and its square more than two are exact.
const PHASES: usize = 8;

/// The last of them, in periods.
const LAST_PHASE: f64 = 1.0 - 1.0 / PHASES as f64;

impl Solution {
    /// Of the oscillator alone, s.
    fn period(&self) -> f64 {
        2.0 * PI / self.motion().oscillator().angular_frequency()
    }

    /// Whether `count` even samples show every swing that a time of this length can hold.
    fn shows(&self, duration: f64, count: usize) -> bool {
        2.0 * duration / self.period() * PER_SWING <= count as f64
    }

    /// The next two turning points after each of these rising times. In closed form the swings before are not walked; a
    /// series is, since each of its swings follows from the last one.
    fn turns_after(&self, starts: &[f64]) -> Result<Vec<Vec<TurningPoint>>> {
        if self.motion().kind() != Kind::ClosedForm {
            return Ok(starts.iter().map(|start| self.next_turns(*start)).collect());
        }
        let mut found = Vec::new();
        for sample in self.motion().samples(starts)? {
            // What is too small for a motion of its own is too small to be seen.
            let onward = Motion::new(*self.motion().oscillator(), sample.state());
            let mut next = Vec::new();
            for point in onward.iter().flat_map(Motion::turning_points).take(2) {
                next.push(TurningPoint { time: sample.time + point.time, ..point });
            }
            found.push(next);
        }
        Ok(found)
    }

    /// Samples for the curve x(t) between two times: `count` even ones where they show every swing, or else in each
    /// column the turning points that come next. Times, positions, velocities, accelerations, one behind the other.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn course(&self, from: f64, to: f64, count: usize) -> Result<Vec<f64>> {
        if self.shows(to - from, count) {
            return self.samples(from, to, count);
        }
        let columns = times(from, to, count / 8);
        let mut shown = vec![from];
        for (column, turns) in columns.iter().zip(self.turns_after(&columns)?) {
            // Where columns are narrow the next turning points are also those of the next column.
            for time in [*column].into_iter().chain(turns.iter().map(|point| point.time)) {
                if time > shown[shown.len() - 1] && time <= to {
                    shown.push(time);
                }
            }
        }
        Ok(sample_columns(&self.motion().samples(&shown)?))
    }

    /// Samples for the phase portrait of the record, as [`Solution::course`] has them: where there are too many loops,
    /// some, each of them whole.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn orbit(&self, count: usize) -> Result<Vec<f64>> {
        let end = self.end();
        if self.shows(end, count / 4) || self.motion().oscillator().period().is_none() {
            return self.samples(0.0, end, count);
        }
        let starts = self.starts()?;
        let turns = self.turns_after(&starts)?;
        let mut shown = Vec::new();
        for (start, turns) in starts.iter().zip(turns) {
            // From one side to the same, so that the way to the next loop is short; the first begins with the release.
            let side = turns.iter().find(|point| point.position > 0.0).map(|point| point.time);
            let Some(begin) = (if *start == 0.0 { Some(0.0) } else { side }) else { continue };
            shown.extend(times(begin, begin + self.period(), SIDES + 1));
        }
        shown.retain(|time| *time <= end);
        Ok(sample_columns(&self.motion().samples(&shown)?))
    }

    /// The ledger of the record, at `count` even times where they show every swing, or else averaged over a period at
    /// each time.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn energies(&self, count: usize) -> Result<Vec<f64>> {
        let (duration, period) = (self.duration(), self.period());
        if self.shows(duration, count) {
            return self.ledger(duration, count);
        }
        let columns = (count / PHASES).min((duration / period) as usize);
        let begins = times(0.0, duration - period, columns);
        let mut all = Vec::new();
        for begin in begins {
            all.extend(times(begin, begin + period * LAST_PHASE, PHASES));
        }
        let rows = self.motion().ledger(&all)?;
        let mut means = Vec::new();
        for (rows, time) in rows.chunks(PHASES).zip(times(0.0, duration, columns)) {
            means.push(mean(rows, time));
        }
        Ok(ledger_columns(&means))
    }

    /// Times and heights of the envelope: with Stokes friction alone the exponential through all turning points, or else
    /// these points, `count` of them if there are more.
    ///
    /// # Errors
    /// A time that the motion cannot be followed to.
    pub fn envelope(&self, count: usize) -> Result<Vec<f64>> {
        let mut points: Vec<_> = self.turns().take(count).collect();
        let mix = self.motion().oscillator().friction().mix();
        let even = times(0.0, self.duration(), count);
        if let (Some(first), true) =
            (points.first().copied(), mix.stokes && !mix.coulomb && !mix.newton)
        {
            let rate = self.motion().oscillator().damping_rate();
            let height = |time: &f64| first.position.abs() * (rate * (first.time - time)).exp();
            return Ok(even.iter().copied().chain(even.iter().map(height)).collect());
        }
        if points.len() == count {
            points = self
                .turns_after(&even)?
                .into_iter()
                .filter_map(|next| next.first().copied())
                .collect();
            points.retain(|point| point.time <= self.duration());
        }
        let heights = points.iter().map(|point| point.position.abs());
        Ok(points.iter().map(|point| point.time).chain(heights).collect())
    }

    /// Mean amplitude and loss of some of the swings of the record, which together show all.
    pub(crate) fn some_swings(&self) -> Result<Vec<(f64, f64)>> {
        let mut found = Vec::new();
        for next in self.turns_after(&self.starts()?)? {
            let places: Vec<_> = next.iter().map(|point| point.position).collect();
            found.extend(swings(&places));
        }
        Ok(found)
    }

    /// When nothing more is to be seen: the end of the record, or the rest.
    fn end(&self) -> f64 {
        match self.motion().outcome() {
            Outcome::Rests(rest) => rest.time.min(self.duration()),
            _ => self.duration(),
        }
    }

    /// Rising times between which the amplitude loses a step or a period passes, whichever is later.
    fn starts(&self) -> Result<Vec<f64>> {
        let mut found = Vec::new();
        // What is still to be cut, the first on top.
        let (mut begin, mut open) = (0.0, vec![self.end()]);
        let mut size = self.size(begin)?;
        while let Some(&end) = open.last() {
            let lost = (size - self.size(end)?).abs() * STEPS > self.motion().amplitude();
            if lost && end - begin > self.period() {
                open.push(0.5 * (begin + end));
                continue;
            }
            found.push(begin);
            begin = end;
            size = self.size(end)?;
            open.pop();
        }
        Ok(found)
    }

    /// The amplitude at a time.
    fn size(&self, time: f64) -> Result<f64> {
        let next = self.turns_after(&[time])?;
        Ok(next[0].first().map_or(0.0, |point| point.position.abs()))
    }
}

fn mean(rows: &[Ledger], time: f64) -> Ledger {
    let share = 1.0 / rows.len() as f64;
    let mut mean = Ledger { time, kinetic: 0.0, potential: 0.0, heat: Heat::default() };
    for Ledger { kinetic, potential, heat, .. } in rows {
        mean.kinetic += share * kinetic;
        mean.potential += share * potential;
        mean.heat.stokes += share * heat.stokes;
        mean.heat.coulomb += share * heat.coulomb;
        mean.heat.newton += share * heat.newton;
    }
    mean
}
