//! How the error of methods falls with the time step.

use std::collections::BTreeSet;

use federpendel::Mix;
use federpendel::lens::{Rung, order};

use super::errors::length_of_error;
use super::{Axis, Plot, Role, Scale, Span, Style};
use crate::catalogue::Catalogue;

/// What the plots of convergence and of work show.
#[derive(Debug, Clone, Copy)]
pub struct ConvergenceData<'a> {
    /// Which laws of friction act.
    pub mix: Mix,
    /// The methods, in the order of the legend; up to twelve are told apart.
    pub methods: &'a [MethodRungs<'a>],
}

/// A method with its errors at several time steps.
#[derive(Debug, Clone, Copy)]
pub struct MethodRungs<'a> {
    /// Its name.
    pub name: &'a str,
    /// Which of the twelve looks it has: the same in every plot.
    pub number: usize,
    /// The order it has where the motion is smooth.
    pub order: u32,
    /// Its errors, from the longest step to the shortest.
    pub rungs: &'a [Rung],
}

impl MethodRungs<'_> {
    /// The rungs whose error can be shown on a logarithmic axis.
    pub(super) fn shown(&self) -> impl Iterator<Item = &Rung> + '_ {
        self.rungs.iter().filter(|rung| rung.error > 0.0 && rung.error.is_finite())
    }
}

/// Height of the triangle of first order, as a share of the logarithm of all errors: enough for a number.
const HEIGHT: f64 = 0.055;

/// How far the triangles stay below the lowest error above them, as the same share.
const GAP: f64 = 0.12;

impl Plot {
    /// Largest error against time step, both logarithmic, one curve per method. The triangles in the corner show
    /// the slopes of the orders that the methods have by design.
    pub fn convergence(catalogue: &Catalogue, data: &ConvergenceData<'_>) -> Self {
        let steps = data.methods.iter().flat_map(|method| method.shown());
        let longest = steps.fold(0.0, |most: f64, rung| most.max(rung.time_step));
        let step = Axis::new(catalogue, &catalogue.text("plot-time-step"), "Δt", "s", longest);
        let title =
            catalogue.format("plot-convergence-title", &[("mix", catalogue.mix(data.mix).into())]);
        let error = length_of_error(catalogue, "plot-largest-error");
        let mut plot = Plot::new(catalogue, title, step.logarithmic(), error);
        plot.description = description(catalogue, data, &plot.title);
        for method in data.methods {
            let name = match order(method.rungs) {
                Some(slope) => {
                    let slope = slope_text(catalogue, slope);
                    let variables = [("name", method.name.into()), ("order", slope.into())];
                    catalogue.format("plot-order-observed", &variables)
                }
                None => method.name.to_owned(),
            };
            let points = method.shown().map(|rung| (rung.time_step, rung.error));
            plot.add(
                name,
                Role::Comparison(method.number),
                Style::comparison(method.number),
                points,
            );
        }
        plot.add_triangles(catalogue, data);
        plot.say_if_empty(catalogue);
        plot
    }

    /// One triangle in another on a common base, from which each rises with the slope of an order, at long steps
    /// and below all curves: there no method can be.
    fn add_triangles(&mut self, catalogue: &Catalogue, data: &ConvergenceData<'_>) {
        let rungs = || data.methods.iter().flat_map(|method| method.shown());
        let shown = data.methods.iter().filter(|method| method.shown().next().is_some());
        let orders: BTreeSet<u32> = shown.map(|method| method.order).collect();
        let Some(steepest) = orders.last() else { return };
        let (steps, errors) = (
            Span::of(rungs().map(|rung| rung.time_step), Scale::Logarithmic),
            Span::of(rungs().map(|rung| rung.error), Scale::Logarithmic),
        );
        let share = |share: f64| (errors.high / errors.low).powf(share);
        let width = share(HEIGHT);
        // Some room on the right for the numbers.
        let (from, to) = (steps.at(0.95) / width, steps.at(0.95));
        let above = rungs().filter(|rung| rung.time_step >= 0.7 * from).map(|rung| rung.error);
        let lowest = above.fold(f64::INFINITY, f64::min);
        let base = lowest / share(GAP) / width.powi(*steepest as i32);
        let top = |order: u32| base * width.powi(order as i32);
        if !(base > 0.0 && top(*steepest).is_finite()) {
            return;
        }
        let corner = [(from, base), (to, base), (to, top(*steepest))];
        self.add("", Role::Guide, Style::THIN, corner);
        for &order in &orders {
            self.add("", Role::Guide, Style::THIN, [(from, base), (to, top(order))]);
            self.add_note(order.to_string(), (steps.at(0.975), top(order) / share(0.02)));
        }
        self.add_note(catalogue.text("plot-order"), (to, top(*steepest) * share(0.03)));
    }
}

/// A slope to tenths, all of them written: “2.0”.
fn slope_text(catalogue: &Catalogue, slope: f64) -> String {
    let sign = catalogue.language().decimal_sign().to_string();
    // Adding zero turns −0.0 into 0.0.
    format!("{:.1}", (10.0 * slope).round() / 10.0 + 0.0).replace('.', &sign)
}

fn description(catalogue: &Catalogue, data: &ConvergenceData<'_>, title: &str) -> String {
    let method = |method: &MethodRungs<'_>| {
        let observed = match order(method.rungs) {
            Some(slope) => slope_text(catalogue, slope),
            None => catalogue.text("plot-convergence-unobserved"),
        };
        let least = method.shown().map(|rung| rung.error).fold(f64::INFINITY, f64::min);
        let least = if least.is_finite() { least } else { 0.0 };
        catalogue.format(
            "plot-convergence-method",
            &[
                ("name", method.name.into()),
                ("order", method.order.to_string().into()),
                ("observed", observed.into()),
                ("error", catalogue.quantity(least, "m", 2).into()),
            ],
        )
    };
    let methods: Vec<_> = data.methods.iter().map(method).collect();
    let variables = [("title", title.into()), ("methods", methods.join("; ").into())];
    catalogue.format("plot-convergence-description", &variables)
}
