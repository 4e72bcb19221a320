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
        let mut plot = frame(catalogue, data, data.values);
        let inside = data.first..data.first + data.fitted.len();
        let pairs = |range: std::ops::Range<usize>| {
            data.times[range.clone()].iter().copied().zip(data.values[range].iter().copied())
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
        let fit = data.times[inside].iter().copied().zip(data.fitted.iter().copied());
        plot.add(catalogue.text("plot-fit"), Role::Comparison(1), Style::LONG_DASHED, fit);
        let (low, high) = extremes(data.values);
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
        let residuals: Vec<f64> = data.values[inside.clone()]
            .iter()
            .zip(data.fitted)
            .map(|(value, fit)| value - fit)
            .collect();
        let residual = catalogue.text("plot-residual-axis");
        let data = &RecordingData { quantity: &residual, ..*data };
        let mut plot = frame(catalogue, data, &residuals);
        let square = residuals.iter().map(|r| r * r).sum::<f64>() / residuals.len().max(1) as f64;
        plot.description = catalogue.format(
            "plot-residuals-description",
            &[("rms", catalogue.quantity(square.sqrt(), data.unit, 2).into())],
        );
        let points = data.times[inside].iter().copied().zip(residuals);
        plot.add(catalogue.text("plot-residual"), Role::Comparison(1), Style::THIN, points);
        plot
    }
}

fn frame(catalogue: &Catalogue, data: &RecordingData<'_>, values: &[f64]) -> Plot {
    let end = data.times.last().copied().unwrap_or(0.0).abs();
    let time = Axis::new(catalogue, &catalogue.text("plot-time"), "t", "s", end);
    let time = match data.times {
        [first, .., last] => time.spanning(*first, *last),
        _ => time,
    };
    let (low, high) = extremes(values);
    let unit = if data.unit.is_empty() { "1" } else { data.unit };
    let value = Axis::new(catalogue, data.quantity, data.symbol, unit, low.abs().max(high.abs()));
    Plot::new(catalogue, data.title.to_owned(), time, value)
}

fn extremes(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| {
        (low.min(value), high.max(value))
    })
}
