//! The extremes of a recording: where it turns, before anything is known about the motion.

use std::borrow::Cow;

use nalgebra::{Matrix3, Vector3};

/// A local extreme of the recorded quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Time, s.
    pub time: f64,
    /// Value.
    pub value: f64,
}

/// What a first look at a recording finds.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// Alternating maxima and minima that stand out of the noise; the last is where it comes to
    /// rest if it does.
    pub extremes: Vec<Extreme>,
    /// The recording, smoothed over a small part of a swing.
    pub smooth: Vec<f64>,
    /// Half a period, s.
    pub half: f64,
    /// Standard deviation of what smoothing took away; of noise, where the sampling is fine.
    pub noise: f64,
    /// Standard deviation of the noise that smoothing left.
    pub left: f64,
}

/// Smoothing and parabolas reach this share of half a period to either side: cos changes there by
/// an eighth of its height, and the shape is the same at every extreme, so that amplitudes keep
/// their ratios.
const REACH: f64 = 0.2;
/// What comes this near to where it ends up, as a share of the way, has got there for a first look.
const ARRIVED: f64 = 0.1;
/// A value this many standard deviations of the noise off its neighbours is an outlier to a first
/// look.
const OUTLIER: f64 = 8.0;

/// Looks at `values` at rising `times`; none if they never move or turn less than twice.
pub fn look(times: &[f64], values: &[f64]) -> Option<Look> {
    let values: &[f64] = &without_outliers(values);
    let (low, high) = bounds(values);
    let range = high - low;
    if range <= 0.0 {
        return None;
    }
    // At first only the widest turns, which noise does not feign; then all, smoothed to their
    // measure.
    let wide = [0.35, 0.2].iter().map(|share| turns(values, share * range));
    let wide = wide.into_iter().find(|found| found.len() >= 3)?;
    let mut half = spacing(times, values, &wide)?;
    let mut found = None;
    let step = (times[times.len() - 1] - times[0]) / (times.len() - 1) as f64;
    for _ in 0..2 {
        // Of a large recording one smoothed copy is enough.
        drop(found.take());
        // To the middle between two times: else rounding decides which of them it takes in.
        let reach = ((REACH * half / step).floor() + 0.5) * step;
        let smooth = smoothed(times, values, reach);
        let (noise, left) = noise(values, &smooth, 2.0 * reach / step);
        // Beyond what the noise of so many smoothed values spans.
        let count = (values.len() as f64 * step / reach).max(3.0);
        let above = (2.0 * (2.0 * count.ln()).sqrt() + 1.0) * left;
        let mut pivots = turns(&smooth, above.max(2e-3 * range));
        // Where a recording begins in the middle of a swing it does not turn.
        if pivots.first().is_some_and(|&i| times[i] - times[0] < REACH * half) {
            pivots.remove(0);
        }
        let first = &pivots[..pivots.len().min(wide.len().max(8))];
        half = spacing(times, &smooth, first).unwrap_or(half);
        found = Some((smooth, noise, left, pivots));
    }
    let (smooth, noise, left, pivots) = found?;
    let extremes = pivots.iter().map(|&i| vertex(times, values, i, REACH * half)).collect();
    Some(Look { extremes, smooth, half, noise, left })
}

/// The standard deviation of the noise, as second differences over neighbours show it; an upper
/// bound where the sampling is coarse. Their median sees no steps and no outliers.
pub fn fast_noise(values: &[f64]) -> f64 {
    // A second difference has √6 of it.
    spread(values.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2])) / 6f64.sqrt()
}

/// The same from fourth differences: a motion sampled a dozen times in half a period adds a thousandth of its
/// amplitude at most, and it is too small where neighbours share their noise or a sensor its steps.
pub fn finest_noise(values: &[f64]) -> f64 {
    let fourth = |w: &[f64]| w[0] - 4.0 * w[1] + 6.0 * w[2] - 4.0 * w[3] + w[4];
    // A fourth difference has √70 of it.
    spread(values.windows(5).map(fourth)) / 70f64.sqrt()
}

/// The standard deviation of normal numbers around zero, from the median of their sizes, which outliers do not
/// sway; zero of none.
pub fn spread(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut sizes: Vec<f64> = numbers.map(f64::abs).collect();
    1.4826 * median(&mut sizes).unwrap_or(0.0)
}

/// The values, with those that stand far off the median of five neighbours replaced by it.
pub fn without_outliers(values: &[f64]) -> Cow<'_, [f64]> {
    let limit = OUTLIER * fast_noise(values);
    let mut clean = Cow::Borrowed(values);
    for (i, around) in values.windows(5).enumerate() {
        let mut five = [around[0], around[1], around[2], around[3], around[4]];
        let middle = median(&mut five).unwrap_or(around[2]);
        if limit > 0.0 && (around[2] - middle).abs() > limit {
            clean.to_mut()[i + 2] = middle;
        }
    }
    clean
}

/// The lowest and the highest.
pub fn bounds(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &x| (l.min(x), h.max(x)))
}

/// The indices between which `values` run by more than `threshold` before they turn back:
/// alternating maxima and minima, the first and last values left out if nothing turns there.
fn turns(values: &[f64], threshold: f64) -> Vec<usize> {
    let mut found = Vec::new();
    let (mut low, mut high) = (0, 0);
    // +1 while the values rise, −1 while they fall, 0 as long as neither is clear.
    let mut way = 0;
    for (i, &value) in values.iter().enumerate() {
        if value > values[high] {
            high = i;
        }
        if value < values[low] {
            low = i;
        }
        if way >= 0 && value < values[high] - threshold {
            found.push(high);
            (way, low) = (-1, i);
        } else if way <= 0 && value > values[low] + threshold {
            found.push(low);
            (way, high) = (1, i);
        }
    }
    // Where it ends up is a turn too if it came far enough.
    let last = if way > 0 { high } else { low };
    let far = found.last().is_some_and(|&i: &usize| (values[last] - values[i]).abs() > threshold);
    if far && last + 1 < values.len() {
        found.push(last);
    }
    found
}

/// The median time between neighbouring turns.
fn spacing(times: &[f64], values: &[f64], turns: &[usize]) -> Option<f64> {
    let mut gaps: Vec<f64> = turns.windows(2).map(|w| times[w[1]] - times[w[0]]).collect();
    // Where it rests any value may be the extreme: of few turns the last is where it gets there.
    if let ([.., before, last], Some(gap)) = (turns, gaps.last_mut()) {
        let near = ARRIVED * (values[*before] - values[*last]).abs();
        let there = (*before..=*last).find(|&i| (values[i] - values[*last]).abs() <= near);
        *gap = there.map_or(*gap, |i| times[i] - times[*before]);
    }
    median(&mut gaps)
}

/// The median; none of nothing. Changes the order.
pub fn median(values: &mut [f64]) -> Option<f64> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// The mean over the times within `reach` of each time.
fn smoothed(times: &[f64], values: &[f64], reach: f64) -> Vec<f64> {
    let (mut first, mut end, mut sum) = (0, 0, 0.0);
    let mut mean = |&time: &f64| {
        while end < times.len() && times[end] <= time + reach {
            sum += values[end];
            end += 1;
        }
        while times[first] < time - reach {
            sum -= values[first];
            first += 1;
        }
        sum / (end - first) as f64
    };
    times.iter().map(&mut mean).collect()
}

/// Standard deviations of the noise of the values and of what smoothing over `within` of them
/// leaves.
fn noise(values: &[f64], smooth: &[f64], within: f64) -> (f64, f64) {
    let slow = spread(values.iter().zip(smooth).map(|(value, smooth)| value - smooth));
    let noise = fast_noise(values).min(slow);
    (noise, noise / within.max(1.0).sqrt())
}

/// The vertex of the parabola through the values within `reach` of index `i`, at least five of
/// them.
fn vertex(times: &[f64], values: &[f64], i: usize, reach: f64) -> Extreme {
    let (mut first, mut end) = (i.saturating_sub(2), (i + 3).min(times.len()));
    while first > 0 && times[first - 1] >= times[i] - reach {
        first -= 1;
    }
    while end < times.len() && times[end] <= times[i] + reach {
        end += 1;
    }
    let unit = (times[end - 1] - times[first]).max(f64::MIN_POSITIVE);
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for k in first..end {
        let u = (times[k] - times[i]) / unit;
        let row = Vector3::new(1.0, u, u * u);
        matrix += row * row.transpose();
        right += row * values[k];
    }
    let plain = Extreme { time: times[i], value: values[i] };
    let Some(c) = matrix.cholesky().map(|factor| factor.solve(&right)) else { return plain };
    let u = -c[1] / (2.0 * c[2]);
    if u.is_finite() && u.abs() <= 0.5 {
        Extreme { time: times[i] + u * unit, value: c[0] + u * (c[1] + u * c[2]) }
    } else {
        // Flat, as at rest: the mean level.
        Extreme { time: times[i], value: c[0] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_of_a_decay_are_found() {
        let times: Vec<f64> = (0..2000).map(|i| 3.0 + 0.01 * f64::from(i)).collect();
        let value = |t: f64| 5.0 + (-0.05 * (t - 3.0)).exp() * (3.0 * (t - 3.0)).sin();
        let mut values: Vec<f64> = times.iter().map(|&t| value(t)).collect();
        // One outlier changes nothing.
        values[700] += 30.0;
        let look = look(&times, &values).expect("it turns");
        let half = std::f64::consts::PI / 3.0;
        assert!((look.half / half - 1.0).abs() < 0.01, "{}", look.half);
        assert_eq!(look.extremes.len(), 19);
        for (n, extreme) in look.extremes.iter().enumerate() {
            let exact = 3.0 + (n as f64 + 0.5) * half - 0.05 / 9.0;
            assert!((extreme.time - exact).abs() < 0.01, "{n}: {extreme:?} {exact}");
            assert!((extreme.value - value(exact)).abs() < 0.01, "{n}: {extreme:?}");
        }
    }

    #[test]
    fn what_does_not_turn_has_no_extremes() {
        let times: Vec<f64> = (0..100).map(f64::from).collect();
        assert!(look(&times, &times).is_none());
        assert!(look(&times, &[1.0; 100]).is_none());
    }
}
