//! How far laws of friction stand out of the noise, against the amplitude of release.

use federpendel::Mix;

use super::{Axis, Dash, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;

/// What the plot of the significance shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct SignificanceData<'a> {
    /// The laws that act.
    pub mix: Mix,
    /// The laws, in the order of the legend; up to three are told apart without colour.
    pub curves: &'a [SignificanceCurve<'a>],
    /// Smallest and largest amplitude of release, m.
    pub amplitudes: (f64, f64),
    /// From here on a law is resolved.
    pub threshold: f64,
}

/// One of the laws.
#[derive(Debug, Clone, Copy)]
pub struct SignificanceCurve<'a> {
    /// Its name.
    pub name: &'a str,
    /// What it stands for.
    pub role: Role,
    /// Rising amplitudes of release, m.
    pub amplitudes: &'a [f64],
    /// The coefficient over its standard error at each; zero where nothing is known.
    pub significances: &'a [f64],
}

/// Dashes and markers, in the order of the legend.
const LOOKS: [Style; 3] = [
    Style::Marked { dash: Dash::Solid, marker: Marker::Circle },
    Style::Marked { dash: Dash::LongDashed, marker: Marker::Square },
    Style::Marked { dash: Dash::Dotted, marker: Marker::Triangle },
];

/// Below this share of the threshold nothing is shown.
const FLOOR: f64 = 0.02;

impl Plot {
    /// Coefficient over standard error of each law against the amplitude of release, both logarithmic, with a line where
    /// a law is resolved.
    pub fn significance(catalogue: &Catalogue, data: &SignificanceData<'_>) -> Self {
        let (from, to) = data.amplitudes;
        let amplitude = Axis::new(catalogue, &catalogue.text("plan-plot-amplitude"), "A", "m", to);
        let significance =
            Axis::new(catalogue, &catalogue.text("plan-plot-significance"), "", "1", 1.0);
        let mix = [("mix", catalogue.mix(data.mix).into())];
        let title = catalogue.format("plan-plot-title", &mix);
        let mut plot = Plot::new(
            catalogue,
            title,
            amplitude.logarithmic().within(from, to),
            significance.logarithmic(),
        );
        plot.description = description(catalogue, data, &plot.title);
        for (curve, look) in data.curves.iter().zip(LOOKS.into_iter().cycle()) {
            let points = curve.amplitudes.iter().copied().zip(curve.significances.iter().copied());
            let shown = points.filter(|point| point.1 > FLOOR * data.threshold);
            plot.add(curve.name, curve.role, look, shown);
        }
        let line = [(from, data.threshold), (to, data.threshold)];
        let variables = [("threshold", catalogue.number(data.threshold, 2).into())];
        let name = catalogue.format("plan-plot-threshold", &variables);
        plot.add(name, Role::Guide, Style::SOLID, line);
        plot
    }
}

fn description(catalogue: &Catalogue, data: &SignificanceData<'_>, title: &str) -> String {
    let number = |value: Option<&f64>| catalogue.number(value.copied().unwrap_or(0.0), 2).into();
    let law = |curve: &SignificanceCurve<'_>| {
        let variables = [
            ("name", curve.name.into()),
            ("first", number(curve.significances.first())),
            ("last", number(curve.significances.last())),
        ];
        catalogue.format("plan-plot-law", &variables)
    };
    let laws: Vec<_> = data.curves.iter().map(law).collect();
    let length = |value: f64| catalogue.quantity(value, "m", 3).into();
    let variables = [
        ("title", title.into()),
        ("from", length(data.amplitudes.0)),
        ("to", length(data.amplitudes.1)),
        ("laws", laws.join("; ").into()),
        ("threshold", catalogue.number(data.threshold, 2).into()),
    ];
    catalogue.format("plan-plot-description", &variables)
}
