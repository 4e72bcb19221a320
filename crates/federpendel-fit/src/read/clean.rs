//! From rows as they stand in a file to a recording: in order, each time once.

use super::below::starts_over;
use super::error::ReadError;
use super::row::{Kept, LineNumbers};
use super::{LEAST_ROWS, Note, Rows};

/// A step this many times longer than usual is a gap.
const GAP: f64 = 5.0;

/// Most steps that the usual one is found from.
const STEPS: usize = 100_000;

/// Times and values of a run put in order, and what was done to them.
pub(super) struct Clean {
    pub times: Vec<f64>,
    pub values: Vec<f64>,
    pub notes: Vec<Note>,
}

/// Puts rows in order. `time` and `value` are the names of the columns.
pub(super) fn clean(kept: Kept, time: &str, value: &str) -> Result<Clean, ReadError> {
    let Kept { mut times, mut values, lines, missing, cut_off, .. } = kept;
    let mut notes = Vec::new();
    notes.extend(cut_off.map(|line| Note::CutOff { line }));
    notes.extend(missing.map(Note::Missing));
    enough(times.len())?;
    if times.iter().all(|time| *time == times[0]) {
        return Err(ReadError::ConstantTime { column: time.to_owned(), value: times[0] });
    }
    let order = sorted(&mut times, &mut values, &lines, &mut notes)?;
    let line = |row: usize| lines.of(order.as_ref().map_or(row, |order| order[row]));
    merge(&mut times, &mut values, line, &mut notes);
    enough(times.len())?;
    if values.iter().all(|value| *value == values[0]) {
        return Err(ReadError::ConstantValue { column: value.to_owned(), value: values[0] });
    }
    times.shrink_to_fit();
    values.shrink_to_fit();
    Ok(Clean { times, values, notes })
}

fn enough(rows: usize) -> Result<(), ReadError> {
    let least = LEAST_ROWS;
    if rows < least { Err(ReadError::TooFewRows { rows, least }) } else { Ok(()) }
}

/// Sorts by time and tells where each row came from, if they were not in order.
fn sorted(
    times: &mut Vec<f64>,
    values: &mut Vec<f64>,
    lines: &LineNumbers,
    notes: &mut Vec<Note>,
) -> Result<Option<Vec<usize>>, ReadError> {
    let falls = || times.windows(2).enumerate().filter(|(_, pair)| pair[1] < pair[0]);
    let Some((first, _)) = falls().next() else { return Ok(None) };
    let count = falls().count();
    if let Some(row) = starts_over(times) {
        let (value, before) = (times[row], times[row - 1]);
        return Err(ReadError::StartsOver { line: lines.of(row), value, before });
    }
    notes.push(Note::Sorted(Rows { count, first_line: lines.of(first + 1) }));
    let mut order: Vec<usize> = (0..times.len()).collect();
    // Rows of one time stay in order, without the room that a stable sort takes.
    order.sort_unstable_by(|a, b| times[*a].total_cmp(&times[*b]).then(a.cmp(b)));
    *times = order.iter().map(|row| times[*row]).collect();
    *values = order.iter().map(|row| values[*row]).collect();
    Ok(Some(order))
}

/// Takes the mean of the values of one time, and notes gaps.
fn merge(
    times: &mut Vec<f64>,
    values: &mut Vec<f64>,
    line: impl Fn(usize) -> usize,
    notes: &mut Vec<Note>,
) {
    let longest_usual = GAP * usual_step(times);
    let (mut same, mut gaps, mut longest) = (None, None, 0.0_f64);
    let (mut last, mut weight) = (0, 1.0);
    for row in 1..times.len() {
        let step = times[row] - times[last];
        if step == 0.0 {
            Rows::count(&mut same, line(row), 1);
            weight += 1.0;
            values[last] += (values[row] - values[last]) / weight;
            continue;
        }
        if step > longest_usual {
            Rows::count(&mut gaps, line(row), 1);
            longest = longest.max(step);
        }
        last += 1;
        (times[last], values[last]) = (times[row], values[row]);
        weight = 1.0;
    }
    times.truncate(last + 1);
    values.truncate(last + 1);
    notes.extend(same.map(Note::Averaged));
    notes.extend(gaps.map(|rows| Note::Gaps { rows, longest, usual: longest_usual / GAP }));
}

/// The median of the steps that are not zero, or of some of them.
fn usual_step(times: &[f64]) -> f64 {
    let stride = times.len() / STEPS + 1;
    let steps = times.windows(2).step_by(stride).map(|pair| pair[1] - pair[0]);
    let mut steps: Vec<f64> = steps.filter(|step| *step > 0.0).collect();
    if steps.is_empty() {
        return f64::INFINITY;
    }
    let middle = steps.len() / 2;
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}
