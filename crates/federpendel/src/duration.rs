//! How long a record is when the user does not say.

use std::f64::consts::PI;

use crate::motion::Motion;
use crate::oscillator::Oscillator;
use crate::outcome::Outcome;

/// Periods shown of a motion that does not come to rest.
const PERIODS: f64 = 12.0;

/// A rest after more periods than this is not waited for.
const PATIENCE: f64 = 200.0;

/// Time constants after which what creeps has come within 0.1 % of its limit.
const TIME_CONSTANTS: f64 = 10.0;

/// A period this much longer than the undamped one tells of creeping rather than swinging.
const STRETCHED: f64 = 20.0;

impl Motion {
    /// A length of record that shows the motion, s: shortly after rest, on a round number; 12 periods (and a
    /// rounding more, so that the turning point at their end belongs to them) if it never rests, or only after
    /// 200; ten time constants where Stokes friction leaves no period.
    ///
    /// ```
    /// # use federpendel::{Coulomb, Motion, NormalForce, Oscillator, State};
    /// let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81))?;
    /// let motion = Motion::new(Oscillator::new(0.5, 20.0, dry)?, State::new(0.1, 0.0)?)?;
    /// assert_eq!(motion.default_duration(), 5.5); // it rests after 4.967 s
    /// # Ok::<(), federpendel::Error>(())
    /// ```
    pub fn default_duration(&self) -> f64 {
        let oscillator = self.oscillator();
        let undamped = 2.0 * PI / oscillator.angular_frequency();
        let period = oscillator.period().filter(|period| *period <= STRETCHED * undamped);
        let longest = PATIENCE * period.unwrap_or(undamped);
        match self.outcome() {
            Outcome::Rests(rest) if rest.time == 0.0 => undamped,
            Outcome::Rests(rest) if rest.time <= longest => round_up(1.02 * rest.time),
            _ => period.map_or_else(
                || TIME_CONSTANTS * time_constant(oscillator),
                |t| PERIODS * t * (1.0 + 8.0 * f64::EPSILON),
            ),
        }
    }
}

/// The time in which the slowest part of the motion falls by a factor e, s.
fn time_constant(oscillator: &Oscillator) -> f64 {
    let zeta = oscillator.damping_ratio();
    let excess = (zeta - 1.0).max(0.0) * (zeta + 1.0);
    (zeta + excess.sqrt()) / oscillator.angular_frequency()
}

/// The next multiple of 1, 2 or 5 times a power of ten, in steps of at most a tenth of `time`.
fn round_up(time: f64) -> f64 {
    let exponent = (time / 10.0).log10().floor() as i32;
    let finest: f64 = format!("1e{exponent}").parse().unwrap_or(f64::MIN_POSITIVE);
    let step = [5.0, 2.0, 1.0]
        .into_iter()
        .map(|leading| leading * finest)
        .find(|step| *step <= time / 10.0)
        .unwrap_or(finest);
    // Through decimal text, so that 0.3 is 0.3 and not three times 0.1.
    let steps = (time / step).ceil();
    let leading = (step / finest).round();
    format!("{}e{exponent}", steps * leading).parse().unwrap_or(time)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::{Coulomb, Friction, NormalForce, Stokes};
    use crate::oscillator::State;

    fn duration(friction: impl Into<Friction>, x0: f64) -> f64 {
        let oscillator = Oscillator::new(0.5, 20.0, friction).unwrap();
        let motion = Motion::new(oscillator, State::new(x0, 0.0).unwrap()).unwrap();
        motion.default_duration()
    }

    fn coulomb(kinetic: f64) -> Coulomb {
        Coulomb::new(kinetic, kinetic, NormalForce::Weight(9.81)).unwrap()
    }

    #[test]
    fn rest_is_shown_and_round() {
        assert_eq!(duration(coulomb(0.02), 0.1), 5.5);
        assert_eq!(duration(coulomb(0.002), 0.1), 55.0);
    }

    #[test]
    fn twelve_periods_where_nothing_rests_soon() {
        let period = 2.0 * PI / 40f64.sqrt();
        assert!((duration(Friction::NONE, 0.1) / period - 12.0).abs() < 3e-14);
        assert!((duration(coulomb(2e-5), 0.1) / period - 12.0).abs() < 3e-14);
        assert_eq!(duration(coulomb(0.02), 0.0), period);
    }

    #[test]
    fn what_creeps_is_shown_until_it_has_nearly_arrived() {
        for damping in [6.33, 40.0, 4000.0] {
            let oscillator = Oscillator::new(0.5, 20.0, Stokes::new(damping).unwrap()).unwrap();
            let motion = Motion::new(oscillator, State::new(0.1, 0.0).unwrap()).unwrap();
            let end = motion.at(motion.default_duration()).unwrap();
            assert!(end.position.abs() < 1e-3 * 0.1, "{damping}: {}", end.position);
        }
    }
}
