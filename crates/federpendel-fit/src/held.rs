//! A mass that is held, or lies still, before it moves. It is told from the values alone: the half period that a first look
//! at a recording finds is far off where the mass is held for long and comes to rest after few swings.

use crate::extremes::{bounds, fast_noise, without_outliers};

/// A held mass stays within this share of the range of all values: a hand may tremble so much,
const BAND: f64 = 0.04;
/// and so many standard deviations of noise, which two values in a row exceed by chance in no recording.
const NOISY: f64 = 5.0;
/// A motion has turned back if it does so by this share of the range, as all but the smallest swings do.
const BACK: f64 = 0.2;
/// It was held if it stayed longer than this share of the time that it then takes to turn back: a free motion that begins
/// right at a turn stays for 0.37 of it where noise is 2 % of the amplitude, and for 0.5 where it is 10 %.
const LONG: f64 = 0.6;
/// Where it does not turn back, that would have taken so many times as long as the way from the band to half the range: of a
/// half period a cosine needs 0.37 for that way, and 1.15 until it has come back by 0.2.
const ONE_WAY: f64 = 3.0;
/// A held mass does not swing: its values spread by no more than this share of the range, or twice the noise. Those of a
/// decay do, unless something 50 times as large follows.
const CALM: f64 = 0.015;

/// How a recording begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plateau {
    /// The index of the first value beyond it.
    pub end: usize,
    /// Its level.
    pub level: f64,
}

/// The values at the beginning that are much like each other, if others follow.
pub fn plateau(values: &[f64]) -> Option<Plateau> {
    let values = without_outliers(values);
    let (low, high) = bounds(&values);
    plateau_in(&values, high - low, fast_noise(&values))
}

/// The same of values without outliers, of which the range and the noise are known.
fn plateau_in(values: &[f64], range: f64, noise: f64) -> Option<Plateau> {
    let band = BAND * range + NOISY * noise;
    let mut sum = 0.0;
    for (end, pair) in values.windows(2).enumerate() {
        let level = if end == 0 { pair[0] } else { sum / end as f64 };
        let beyond = |value: f64| (value - level).abs() > band;
        if end > 0 && beyond(pair[0]) && beyond(pair[1]) {
            return Some(Plateau { end, level });
        }
        sum += pair[0];
    }
    None
}

/// The plateau if the mass was held there, and not merely turning.
pub fn held(times: &[f64], values: &[f64]) -> Option<Plateau> {
    let values = without_outliers(values);
    let (low, high) = bounds(&values);
    let (range, noise) = (high - low, fast_noise(&values));
    let plateau @ Plateau { end, level } = plateau_in(&values, range, noise)?;
    // The first half of them: at the end it may have set off already.
    let first = &values[..end.div_ceil(2)];
    let spread = first.iter().map(|value| (value - level).powi(2)).sum::<f64>();
    let calm = (spread / first.len() as f64).sqrt() < (CALM * range).max(2.0 * noise);
    let away = (values[end] - level).signum();
    let way = |i: usize| away * (values[i] - level);
    let back = BACK * range + NOISY * noise;
    let mut farthest = way(end);
    let turned = (end..values.len()).find(|&i| {
        farthest = farthest.max(way(i));
        way(i) < farthest - back
    });
    let takes = match turned {
        Some(i) => times[i] - times[end],
        None => {
            let middle = (end..values.len()).find(|&i| way(i) > 0.5 * range)?;
            ONE_WAY * (times[middle] - times[end])
        }
    };
    (calm && times[end] - times[0] > LONG * takes).then_some(plateau)
}
