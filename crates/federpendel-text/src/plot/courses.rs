//! Several motions in one plot: displacement against time.

use super::{Axis, Dash, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plot of several motions shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct CoursesData<'a> {
    /// What they have in common: the title.
    pub title: &'a str,
    /// The motions, in the order of the legend; up to four are told apart without colour.
    pub curves: &'a [Course<'a>],
}

/// One of the motions.
#[derive(Debug, Clone, Copy)]
pub struct Course<'a> {
    /// Its name.
    pub name: &'a str,
    /// What it stands for: the law of friction that acts, or a number among others.
    pub role: Role,
    /// Rising times, s.
    pub times: &'a [f64],
    /// Position at each, m.
    pub positions: &'a [f64],
}

/// How the lines are broken, in the order of the legend.
const DASHES: [Dash; 4] = [Dash::Solid, Dash::LongDashed, Dash::Dotted, Dash::Dashed];

/// What is smaller than this, over the largest displacement, is not told from zero.
const VISIBLE: f64 = 1e-5;

impl Plot {
    /// Several motions x(t), each with a look of its own.
    pub fn courses(catalogue: &Catalogue, data: &CoursesData<'_>) -> Self {
        let largest = |values: &mut dyn Iterator<Item = &f64>| {
            values.fold(0.0, |most: f64, value| most.max(value.abs()))
        };
        let duration = largest(&mut data.curves.iter().flat_map(|curve| curve.times));
        let height = largest(&mut data.curves.iter().flat_map(|curve| curve.positions));
        let time = Axis::new(catalogue, &catalogue.text("plot-time"), "t", "s", duration);
        let position = Axis::new(catalogue, &catalogue.text("plot-position"), "x", "m", height);
        let title = data.title.to_owned();
        let mut plot = Plot::new(catalogue, title, time, position.from_zero());
        plot.description = description(catalogue, data, duration, height);
        for (curve, dash) in data.curves.iter().zip(DASHES.into_iter().cycle()) {
            let points = curve.times.iter().copied().zip(curve.positions.iter().copied());
            plot.add(curve.name, curve.role, Style::Line { dash, width: 1.0 }, points);
        }
        plot
    }
}

fn description(
    catalogue: &Catalogue,
    data: &CoursesData<'_>,
    duration: f64,
    height: f64,
) -> String {
    let course = |curve: &Course<'_>| {
        let length = |x: Option<f64>| {
            // What has died away is zero for a reader.
            let x = x.filter(|x| x.abs() > VISIBLE * height).unwrap_or(0.0);
            catalogue.quantity(x, "m", DIGITS).into()
        };
        let positions = || curve.positions.iter().copied();
        let variables = [
            ("name", curve.name.into()),
            ("start", length(positions().next())),
            ("lowest", length(positions().reduce(f64::min))),
            ("highest", length(positions().reduce(f64::max))),
            ("end", length(positions().last())),
        ];
        catalogue.format("plot-courses-course", &variables)
    };
    let courses: Vec<_> = data.curves.iter().map(course).collect();
    let variables = [
        ("title", catalogue.quoted(data.title).into()),
        ("duration", catalogue.quantity(duration, "s", DIGITS).into()),
        ("courses", courses.join("; ").into()),
    ];
    catalogue.format("plot-courses-description", &variables)
}
