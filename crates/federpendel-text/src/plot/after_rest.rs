//! What methods do after the mass has come to rest.

use super::overlay::{OverlayData, ends, panel, rest, window};
use super::{Axis, Note, Plot};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// How high the plot is, in half widths of the sticking band.
const HEIGHT: f64 = 1.3;

impl Plot {
    /// The exact motion and every method from the last swing before the rest to the end of the record, as high
    /// as the sticking band: what creeps, chatters or swings on there. A record without a rest is shown whole,
    /// and the plot says so.
    pub fn after_rest(catalogue: &Catalogue, data: &OverlayData<'_>) -> Self {
        let duration = data.times.last().copied().unwrap_or(0.0);
        let title =
            catalogue.format("plot-after-rest-title", &[("mix", catalogue.mix(data.mix).into())]);
        let Some(rest) = rest(data, duration) else {
            return without(panel(catalogue, data, title, (0.0, duration)), catalogue);
        };
        let height = HEIGHT * data.sticking_offset;
        let name = catalogue.text("plot-position");
        let position = Axis::new(catalogue, &name, "x", "m", height).within(-height, height);
        let from = last_turn(data, rest);
        let mut plot = window(catalogue, data, title, (from, duration), position);
        let time = |value: f64| catalogue.quantity(value, "s", DIGITS).into();
        plot.description = catalogue.format(
            "plot-after-rest-description",
            &[
                ("title", plot.title.clone().into()),
                ("from", time(from)),
                ("until", time(duration)),
                ("rest", time(rest)),
                ("offset", catalogue.quantity(data.sticking_offset, "m", DIGITS).into()),
                ("methods", ends(catalogue, data).into()),
            ],
        );
        plot
    }
}

/// Says that there is no rest in the record.
fn without(mut plot: Plot, catalogue: &Catalogue) -> Plot {
    let (x, y) = (plot.x_span(), plot.y_span());
    let text = catalogue.text("plot-after-rest-none");
    plot.description = format!("{}: {text}.", plot.title);
    plot.notes.push(Note { text, point: (x.at(0.5), y.at(0.9)) });
    plot
}

/// Time of the last turning point before the rest; without one, of the release.
fn last_turn(data: &OverlayData<'_>, rest: f64) -> f64 {
    let turns = data.turning_points.iter().map(|point| point.time);
    turns.rev().find(|time| *time < rest).unwrap_or(0.0)
}
