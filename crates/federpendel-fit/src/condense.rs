//! Recordings with far more values than the motion needs: means of neighbours are fitted instead.
//!
//! The mean of m values of cos ωt, a phase δ apart, is smaller by sin(mδ/2) / (m sin(δ/2)), the Dirichlet kernel: with
//! 100 blocks in a swing by 4e-5. The means are stretched by that about their middle. What is left comes of the centre
//! f of a swing, which is stretched with it: 4e-5 of the dry friction, far less than its standard error.
//! The time of a block is the mean of its times.

use std::f64::consts::PI;

use crate::Recording;
use crate::extremes::look;
use crate::least_squares::Minimum;
use crate::model::evaluate;
use crate::problem::parameters;
use crate::window::Window;

/// From so many values on a recording is condensed,
const MANY: usize = 100_000;
/// to at least so many in all,
const KEPT: usize = 50_000;
/// and so many in a swing.
const IN_SWING: f64 = 100.0;

/// A condensed recording.
pub struct Condensed {
    /// The means.
    pub recording: Recording,
    /// Index of the first value of each block, and that after the last.
    starts: Vec<usize>,
}

/// The means of neighbours, if there are enough for that.
pub fn condense(recording: &Recording) -> Option<Condensed> {
    let (times, values) = (&recording.times, &recording.values);
    let count = times.len();
    if count < MANY {
        return None;
    }
    let span = times[count - 1] - times[0];
    let step = span / (count - 1) as f64;
    let half = look(times, values).map_or(span / 2.0, |look| look.half);
    let size = ((half / step / IN_SWING) as usize).min(count / KEPT);
    if size < 2 {
        return None;
    }
    let starts = blocks(times, size, 2.0 * step * size as f64);
    let mean = |all: &[f64]| -> Vec<f64> {
        let one = |pair: &[usize]| {
            let block = &all[pair[0]..pair[1]];
            block.iter().sum::<f64>() / block.len() as f64
        };
        starts.windows(2).map(one).collect()
    };
    let mut means = mean(values);
    stretch(&mut means, PI * step / half, size as f64);
    let recording = Recording { times: mean(times), values: means, ..without_values(recording) };
    Some(Condensed { recording, starts })
}

/// Undoes what taking means of `size` values, a phase `apart`, takes from the amplitude.
fn stretch(means: &mut [f64], apart: f64, size: f64) {
    let kernel = (size * apart / 2.0).sin() / (size * (apart / 2.0).sin());
    let middle = means.iter().sum::<f64>() / means.len() as f64;
    means.iter_mut().for_each(|mean| *mean = middle + (*mean - middle) / kernel);
}

fn without_values(recording: &Recording) -> Recording {
    let Recording { quantity, unit, .. } = recording;
    Recording { times: vec![], values: vec![], quantity: *quantity, unit: unit.clone() }
}

/// Where blocks of `size` values begin, none of them with a gap in it that makes it longer than `longest`.
fn blocks(times: &[f64], size: usize, longest: f64) -> Vec<usize> {
    let mut starts = vec![0];
    let mut first = 0;
    for (i, time) in times.iter().enumerate() {
        if i - first >= size || time - times[first] > longest {
            starts.push(i);
            first = i;
        }
    }
    starts.push(times.len());
    starts
}

impl Condensed {
    /// All values of `recording` within a window of the means, and that window among them. It begins with the first
    /// value after the first mean, whose time is that of the initial state.
    pub fn whole<'a>(&self, recording: &'a Recording, window: &Window) -> (Whole<'a>, Window) {
        let first = recording.times.partition_point(|time| *time < window.from);
        let end = self.starts[window.end];
        let to = recording.times[end - 1];
        let window = Window { first, end, to, ..*window };
        (Whole { recording, window }, window)
    }
}

/// All values of a condensed recording.
pub struct Whole<'a> {
    recording: &'a Recording,
    window: Window,
}

/// Parts that residuals of all values are computed in: the model walks on from the initial state for each, but only the
/// times of a part are copied.
const PARTS: usize = 8;

impl Whole<'_> {
    /// How many values there are.
    pub fn len(&self) -> usize {
        self.window.end - self.window.first
    }

    /// Hands out value minus model at each; none where the model cannot be computed.
    pub fn residuals(&self, minimum: &Minimum, mut take: impl FnMut(f64)) -> Option<()> {
        let Window { first, end, from, .. } = self.window;
        let (times, values) =
            (&self.recording.times[first..end], &self.recording.values[first..end]);
        let size = times.len().div_ceil(PARTS).max(1);
        // The first time is only that of the initial state.
        let mut clock = Vec::with_capacity(1 + size);
        let mut model = vec![0.0; 1 + size];
        let stop = minimum.ending.stop(&minimum.at);
        for (times, values) in times.chunks(size).zip(values.chunks(size)) {
            clock.clear();
            clock.push(from);
            clock.extend_from_slice(times);
            let model = &mut model[..clock.len()];
            let (parameters, quantity) = (parameters(&minimum.at), self.recording.quantity);
            evaluate(&parameters, stop, &clock, quantity, model, None).ok()?;
            values.iter().zip(&model[1..]).for_each(|(value, model)| take(value - model));
        }
        Some(())
    }
}
