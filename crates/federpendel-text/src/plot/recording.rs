//! What a sensor recorded, the fitted motion over it, and what the fit leaves.

use super::{Axis, Dash, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plots of a recording show.
#[derive(Debug, Clone, Copy)]
pub struct RecordingData<'a> {
    /// Title.
    pub title: &'a str,
    /// What is recorded, in a word.
    pub quantity: &'a str,
    /// Its symbol.
    pub symbol: &'a str,
    /// Its unit.
    pub unit: &'a str,
    /// All times of the recording, s, rising.
    pub times: &'a [f64],
    /// The value at each.
    pub values: &'a [f64],
    /// Place of the first value that was fitted.
    pub first: usize,
    /// What the fit says at the values from there on.
    pub fitted: &'a [f64],
}

/// Most values that are marked one by one.
const MOST_MARKERS: usize = 60;

impl Plot {
    /// The recorded values, those outside the fitted part in grey, and the fit.
    pub fn recording(catalogue: &Catalogue, data: &RecordingData<'_>) -> Self {
        let (low, high) = extremes(data.values.iter().copied());
        let mut plot = frame(catalogue, data, (low, high));
        let inside = data.first..data.first + data.fitted.len();
        let pairs = |range: std::ops::Range<usize>| {
            let values = data.values[range.clone()].iter().copied();
            sketch(&data.times[range], values)
        };
        let outside = [0..inside.start, inside.end..data.values.len()];
        for (place, range) in outside.into_iter().enumerate().filter(|(_, range)| !range.is_empty())
        {
            let name = if place == 0 { catalogue.text("plot-not-fitted") } else { String::new() };
            plot.add(name, Role::Sticking, Style::DOTTED, pairs(range));
        }
        let style = if inside.len() <= MOST_MARKERS {
            Style::Markers(Marker::Circle)
        } else {
            Style::Line { dash: Dash::Solid, width: 1.6 }
        };
        plot.add(catalogue.text("plot-recorded"), Role::Exact, style, pairs(inside.clone()));
        let fit = sketch(&data.times[inside], data.fitted.iter().copied());
        plot.add(catalogue.text("plot-fit"), Role::Comparison(1), Style::LONG_DASHED, fit);
        let duration =
            data.times.last().copied().unwrap_or(0.0) - data.times.first().copied().unwrap_or(0.0);
        plot.description = catalogue.format(
            "plot-recording-description",
            &[
                ("title", data.title.into()),
                ("samples", data.values.len().into()),
                ("duration", catalogue.quantity(duration, "s", DIGITS).into()),
                ("lowest", catalogue.quantity(low, data.unit, DIGITS).into()),
                ("highest", catalogue.quantity(high, data.unit, DIGITS).into()),
            ],
        );
        plot
    }

    /// Recorded minus fitted, over the fitted part.
    pub fn residuals(catalogue: &Catalogue, data: &RecordingData<'_>) -> Self {
        let inside = data.first..data.first + data.fitted.len();
        let residuals =
            || data.values[inside.clone()].iter().zip(data.fitted).map(|(value, fit)| value - fit);
        let residual = catalogue.text("plot-residual-axis");
        let data = &RecordingData { quantity: &residual, ..*data };
        let mut plot = frame(catalogue, data, extremes(residuals()));
        let square = residuals().map(|r| r * r).sum::<f64>() / data.fitted.len().max(1) as f64;
        plot.description = catalogue.format(
            "plot-residuals-description",
            &[("rms", catalogue.quantity(square.sqrt(), data.unit, 2).into())],
        );
        let points = sketch(&data.times[inside.clone()], residuals());
        plot.add(catalogue.text("plot-residual"), Role::Comparison(1), Style::THIN, points);
        plot
    }
}

fn frame(catalogue: &Catalogue, data: &RecordingData<'_>, (low, high): (f64, f64)) -> Plot {
    let end = data.times.last().copied().unwrap_or(0.0).abs();
    let time = Axis::new(catalogue, &catalogue.text("plot-time"), "t", "s", end);
    let time = match data.times {
        [first, .., last] => time.spanning(*first, *last),
        _ => time,
    };
    let unit = if data.unit.is_empty() { "1" } else { data.unit };
    let value = Axis::new(catalogue, data.quantity, data.symbol, unit, low.abs().max(high.abs()));
    Plot::new(catalogue, data.title.to_owned(), time, value)
}

fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}

/// The points of a curve, of a large recording only those that a picture many times as wide as any could show: of each
/// column the first, the lowest, the highest and the last.
fn sketch(times: &[f64], values: impl Iterator<Item = f64>) -> Vec<(f64, f64)> {
    const COLUMNS: usize = 20_000;
    let points = times.iter().copied().zip(values);
    let (Some(first), Some(last)) = (times.first(), times.last()) else { return Vec::new() };
    if times.len() <= 4 * COLUMNS {
        return points.collect();
    }
    let column = |time: f64| ((time - first) / (last - first) * COLUMNS as f64) as usize;
    let mut sketch = Vec::new();
    // First, lowest, highest and last of a column.
    let mut corners: Option<[(f64, f64); 4]> = None;
    for point in points {
        match &mut corners {
            Some([first, low, high, last]) if column(first.0) == column(point.0) => {
                *last = point;
                if point.1 < low.1 {
                    *low = point;
                }
                if point.1 > high.1 {
                    *high = point;
                }
            }
            _ => sketch.extend(corners.replace([point; 4]).into_iter().flat_map(in_order)),
        }
    }
    sketch.extend(corners.into_iter().flat_map(in_order));
    sketch
}

/// Points by time, each once.
fn in_order(mut points: [(f64, f64); 4]) -> Vec<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut points = points.to_vec();
    points.dedup();
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sketch_keeps_every_peak() {
        let times: Vec<f64> = (0..1_000_000).map(|i| f64::from(i) * 1e-3).collect();
        let mut values: Vec<f64> = times.iter().map(|time| (7.0 * time).sin()).collect();
        (values[123_456], values[777_777]) = (5.0, -6.0);
        let sketch = sketch(&times, values.iter().copied());
        assert!(sketch.len() < 100_000, "{}", sketch.len());
        assert!(sketch.is_sorted_by(|a, b| a.0 < b.0));
        for i in [0, 123_456, 777_777, 999_999] {
            assert!(sketch.contains(&(times[i], values[i])), "{i}");
        }
        // No value lies beyond the sketch around it.
        let mut around = sketch.windows(2).map(|pair| (pair[0].0, pair[1].0));
        assert!(around.all(|(from, to)| to - from < 2.0 * 1e3 / 20_000.0));
        assert!(sketch.iter().all(|(time, value)| values[(time * 1e3).round() as usize] == *value));
        let few = &times[..1000];
        let all: Vec<_> = few.iter().copied().zip(values.iter().copied()).collect();
        assert_eq!(super::sketch(few, values[..1000].iter().copied()), all);
    }
}
