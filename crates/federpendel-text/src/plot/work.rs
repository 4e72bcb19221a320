//! What accuracy costs: error against steps taken.

use super::convergence::{ConvergenceData, MethodRungs};
use super::errors::length_of_error;
use super::{Axis, Plot, Role, Style};
use crate::catalogue::Catalogue;

impl Plot {
    /// Largest error against the number of steps, both logarithmic, one curve per method.
    pub fn work(catalogue: &Catalogue, data: &ConvergenceData<'_>) -> Self {
        let steps = Axis::new(catalogue, &catalogue.text("plot-steps"), "N", "1", 1.0);
        let title = catalogue.format("plot-work-title", &[("mix", catalogue.mix(data.mix).into())]);
        let error = length_of_error(catalogue, "plot-largest-error");
        let mut plot = Plot::new(catalogue, title, steps.logarithmic(), error);
        plot.description = description(catalogue, data, &plot.title);
        for method in data.methods {
            let points = method.shown().map(|rung| (rung.steps as f64, rung.error));
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
}

fn description(catalogue: &Catalogue, data: &ConvergenceData<'_>, title: &str) -> String {
    let method = |method: &MethodRungs<'_>| {
        let best = method.shown().min_by(|a, b| a.error.total_cmp(&b.error))?;
        let variables = [
            ("name", method.name.into()),
            ("error", catalogue.quantity(best.error, "m", 2).into()),
            ("steps", best.steps.to_string().into()),
        ];
        Some(catalogue.format("plot-work-method", &variables))
    };
    let methods: Vec<_> = data.methods.iter().filter_map(method).collect();
    let methods = match methods.is_empty() {
        true => catalogue.text("plot-no-errors"),
        false => methods.join("; "),
    };
    catalogue
        .format("plot-work-description", &[("title", title.into()), ("methods", methods.into())])
}
