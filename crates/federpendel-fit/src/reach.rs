//! From which amplitude the mass would have to be released for two laws to be told apart.

use federpendel::Mix;

use crate::covariance::covariance;
use crate::least_squares::Minimum;
use crate::mixes::free;
use crate::noise::Excess;
use crate::problem::{Ending, LAWS, OMEGA, Problem, Vector};
use crate::start::{effective_rate, laws, mix};

/// What a recording from another amplitude would tell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// Mixes that these amplitudes cannot tell apart.
    pub mixes: [Mix; 2],
    /// The amplitude of the recording, in its unit of length.
    pub amplitude: f64,
    /// Released from at least here, and recorded with the same sampling and noise down to the
    /// amplitudes of this one, the motion would tell which; none if not even a hundred times the
    /// amplitude did.
    pub from: Option<f64>,
}

/// At this many standard errors a coefficient is seen at the level of the verdict nine times of
/// ten.
const SEEN: f64 = 3.6;

/// Most values of a recording that is only imagined.
const MOST: f64 = 4000.0;

/// How long the amplitude takes from `high` down to `low`, by the averaged laws.
fn decay_time(p: &Vector, high: f64, low: f64) -> f64 {
    const PIECES: i32 = 64;
    let ratio = (high / low).powf(1.0 / f64::from(PIECES));
    let piece = |i: i32| {
        let amplitude = low * ratio.powf(f64::from(i) + 0.5);
        ratio.ln() / effective_rate(p, amplitude)
    };
    (0..PIECES).map(piece).sum()
}

/// The amplitude that tells the mix of `minimum` from `other`: where the coefficients that only the
/// one has would stand out beside those that only the other has. `variance` is that of one value.
pub fn reach(
    problem: &Problem,
    minimum: &Minimum,
    this: Mix,
    other: Mix,
    excess: Excess,
    variance: f64,
) -> Reach {
    let both = mix([0, 1, 2].map(|i| laws(this)[i] || laws(other)[i]));
    let at = &minimum.at;
    let amplitude = at[4].hypot(at[5] / at[OMEGA]);
    let own = LAWS.iter().enumerate().filter(|(l, _)| laws(this)[*l] && !laws(other)[*l]);
    let own: Vec<usize> = own.map(|(_, &i)| i).collect();
    let span = problem.times[problem.len() - 1] - problem.times[0];
    let seen = |factor: f64| {
        let mut scaled: Vector = *at;
        scaled[4] *= factor;
        scaled[5] *= factor;
        // Down to the amplitudes of this recording, and on as long as that.
        let duration = span + decay_time(at, factor * amplitude, amplitude);
        let count = duration / problem.step();
        if !count.is_finite() {
            return false;
        }
        let stride = (count / MOST).ceil().max(1.0);
        let step = stride * problem.step();
        let times: Vec<f64> = (0..(count / stride) as usize).map(|i| i as f64 * step).collect();
        let values = vec![0.0; times.len()];
        let mut probe = Problem::new(times, values, problem.quantity);
        let Some(mut normal) = probe.normal(&scaled, Ending::Natural) else { return false };
        // Only the derivatives count, and the noise; each value stands for `stride` of them.
        normal.cost = variance / stride * probe.len() as f64;
        let there = Minimum { at: scaled, normal, ..*minimum };
        let spread = covariance(&there, &free(both), probe.len(), excess);
        own.iter().any(|&i| scaled[i] > SEEN * spread[(i, i)].sqrt())
    };
    // Upwards by halves, then halving the last gap.
    let factors = std::iter::successors(Some(1.0), |factor| Some(factor * 1.5));
    let found = factors.take_while(|&factor| factor < 100.0).find(|&factor| seen(factor));
    let from = found.map(|mut high: f64| {
        let mut low = (high / 1.5).max(1.0);
        for _ in 0..4 {
            let middle = (low * high).sqrt();
            if seen(middle) { high = middle } else { low = middle }
        }
        high * amplitude
    });
    Reach { mixes: [this, other], amplitude, from }
}
