//! How far methods are from the exact motion, against time.

use federpendel::Mix;

use super::{Axis, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plot of the errors shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct ErrorsData<'a> {
    /// Which laws of friction act.
    pub mix: Mix,
    /// Amplitude max(|x0|, |v0|/ω0) of the release, m: errors far below its rounding are left out.
    pub amplitude: f64,
    /// The methods, in the order of the legend; up to twelve are told apart.
    pub methods: &'a [MethodErrors<'a>],
}

/// The errors of one method.
#[derive(Debug, Clone, Copy)]
pub struct MethodErrors<'a> {
    /// Its name.
    pub name: &'a str,
    /// Which of the twelve looks it has: the same in every plot.
    pub number: usize,
    /// Rising times, s.
    pub times: &'a [f64],
    /// Error of the position at each, of either sign, m.
    pub errors: &'a [f64],
}

/// The range of errors that is shown, over the amplitude: a tenth of a rounding, and a method that runs away.
const SHOWN: (f64, f64) = (1e-17, 1e3);

impl Plot {
    /// |error of the position| of each method against time, on a logarithmic axis. Where it is zero nothing
    /// is drawn.
    pub fn errors(catalogue: &Catalogue, data: &ErrorsData<'_>) -> Self {
        let times = data.methods.iter().flat_map(|method| method.times);
        let duration = times.copied().fold(0.0, f64::max);
        let time = Axis::new(catalogue, &catalogue.text("plot-time"), "t", "s", duration);
        let title =
            catalogue.format("plot-errors-title", &[("mix", catalogue.mix(data.mix).into())]);
        let error = length_of_error(catalogue, "plot-error");
        let (floor, ceiling) = (SHOWN.0 * data.amplitude, SHOWN.1 * data.amplitude);
        let mut plot = Plot::new(
            catalogue,
            title,
            time.from_zero().within(0.0, duration),
            error.within(floor, ceiling),
        );
        plot.description = description(catalogue, data, &plot.title, duration);
        for method in data.methods {
            let errors = method.errors.iter().map(|error| error.abs());
            let points = method
                .times
                .iter()
                .copied()
                .zip(errors)
                .filter(|point| point.1 > 0.0 && point.1 >= floor);
            plot.add(
                method.name,
                Role::Comparison(method.number),
                Style::comparison(method.number),
                points,
            );
        }
        plot.say_if_empty(catalogue);
        plot
    }

    /// Says in the middle of the plot that it shows no error, if so.
    pub(super) fn say_if_empty(&mut self, catalogue: &Catalogue) {
        if self.series.iter().all(|series| series.points.is_empty()) {
            self.x.with_zero = false;
            let (x, y) = (self.x_span(), self.y_span());
            let text = catalogue.text("plot-no-errors");
            self.notes.push(super::Note { text, point: (x.at(0.5), y.at(0.5)) });
        }
    }
}

/// The axis of errors of the position, in metres throughout: powers of ten of another unit mislead.
pub(super) fn length_of_error(catalogue: &Catalogue, id: &str) -> Axis {
    Axis::new(catalogue, &catalogue.text(id), "|Δx|", "m", 1.0).logarithmic()
}

fn description(catalogue: &Catalogue, data: &ErrorsData<'_>, title: &str, duration: f64) -> String {
    let method = |method: &MethodErrors<'_>| {
        let largest = method.errors.iter().fold(0.0, |most: f64, error| most.max(error.abs()));
        let error = catalogue.quantity(largest, "m", 2);
        let variables = [("name", method.name.into()), ("error", error.into())];
        catalogue.format("plot-errors-method", &variables)
    };
    let methods: Vec<_> = data.methods.iter().map(method).collect();
    catalogue.format(
        "plot-errors-description",
        &[
            ("title", title.into()),
            ("duration", catalogue.quantity(duration, "s", DIGITS).into()),
            ("methods", methods.join("; ").into()),
        ],
    )
}
