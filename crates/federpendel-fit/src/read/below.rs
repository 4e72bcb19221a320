//! Runs below each other: the time starts over where the next begins.

use super::error::ReadError;
use super::row::Kept;

/// The runs of the rows of a file, called 1, 2, …, where they are below each other; of these the one that is asked for.
pub(super) fn runs(mut kept: Vec<Kept>, asked: Option<&str>) -> Result<Vec<Kept>, ReadError> {
    if !matches!(kept.as_slice(), [only] if only.run.name.is_none()) {
        return Ok(kept);
    }
    // The last is taken away first: no row is copied more than once.
    let starts = kept.last().map_or_else(Vec::new, |all| starts(&all.times));
    let mut runs: Vec<Kept> = Vec::new();
    for row in starts.into_iter().rev() {
        runs.extend(kept.last_mut().map(|all| all.split_off(row)));
    }
    kept.extend(runs.into_iter().rev());
    if kept.len() > 1 {
        for (at, kept) in kept.iter_mut().enumerate() {
            kept.run.name = Some((at + 1).to_string());
        }
    }
    let Some(asked) = asked else { return Ok(kept) };
    let runs: Vec<String> = kept.iter().filter_map(|kept| kept.run.name.clone()).collect();
    match runs.iter().position(|name| name == asked.trim()) {
        Some(at) => Ok(vec![kept.swap_remove(at)]),
        None => Err(ReadError::RunNotFound { asked: asked.to_owned(), runs }),
    }
}

/// The rows that begin all runs but the first.
fn starts(times: &[f64]) -> Vec<usize> {
    let mut starts: Vec<usize> = Vec::new();
    let last = |starts: &[usize]| starts.last().copied().unwrap_or(0);
    while let Some(row) = starts_over(&times[last(&starts)..]) {
        starts.push(last(&starts) + row);
    }
    starts
}

/// The first row whose time has fallen to the first tenth of those before and rises from there, as they did; none where
/// times fall often, which are out of order.
pub(super) fn starts_over(times: &[f64]) -> Option<usize> {
    const RISING: usize = 3;
    if times.windows(2).filter(|pair| pair[1] < pair[0]).count() * 10 >= times.len() {
        return None;
    }
    let rises = |part: &[f64]| part.windows(2).all(|pair| pair[0] <= pair[1]);
    let (mut low, mut high) = (times[0], times[0]);
    (1..times.len()).find(|row| {
        let time = times[*row];
        let falls = time < times[row - 1] && time <= low + 0.1 * (high - low);
        (low, high) = (low.min(time), high.max(time));
        let (before, after) = times.split_at(*row);
        falls
            && after.len() > RISING
            && before.len() > RISING
            && rises(&after[..=RISING])
            && rises(&before[before.len() - RISING..])
    })
}
