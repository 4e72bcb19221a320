//! The plot of a motion: x(t), its envelope and turning points, the sticking band, the rest.

use federpendel::{Kind, Mix, Outcome, TurningPoint};

use super::{Axis, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;

/// What the plot of a motion shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct MotionData<'a> {
    /// Which laws of friction act.
    pub mix: Mix,
    /// Times of the samples, rising, s.
    pub times: &'a [f64],
    /// Position at each time, m.
    pub positions: &'a [f64],
    /// Turning points within the record, in order. They also keep the curve's full height where
    /// there are fewer samples than swings; of very many, evenly chosen neighbours will do.
    pub turning_points: &'a [TurningPoint],
    /// Whether it is released with velocity zero, so that the envelope begins at the release.
    pub from_rest: bool,
    /// How the motion ends.
    pub outcome: &'a Outcome,
    /// Half width of the sticking band, m; zero without Coulomb friction.
    pub sticking_offset: f64,
}

impl Plot {
    /// The plot of x(t) with the envelope through the turning points, the sticking band and, if the
    /// record holds it, the rest.
    pub fn motion(catalogue: &Catalogue, data: &MotionData<'_>) -> Self {
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let height = match largest(data.positions) {
            0.0 => data.sticking_offset,
            height => height,
        };
        let duration = largest(data.times);
        let time = Axis::new(catalogue, &catalogue.text("plot-time"), "t", "s", duration);
        let position =
            Axis::new(catalogue, &catalogue.text("plot-position"), "x", "m", height).from_zero();
        let title =
            catalogue.format("plot-motion-title", &[("mix", catalogue.mix(data.mix).into())]);
        let mut plot = Plot::new(catalogue, title, time, position);
        plot.description = description(catalogue, data, &plot.title, duration);

        plot.add(catalogue.text("plot-position"), Role::Exact, Style::SOLID, curve(data));
        let envelope = envelope(data);
        if envelope.len() > 1 {
            let mirrored = envelope.clone().into_iter().map(|(time, x)| (time, -x));
            plot.add(catalogue.text("plot-envelope"), Role::Envelope, Style::DASHED, envelope);
            plot.add("", Role::Envelope, Style::DASHED, mirrored);
        }
        let rest = rest_within(data, duration);
        let turning_points = data.turning_points.iter().map(|point| (point.time, point.position));
        let moving: Vec<_> =
            turning_points.filter(|point| rest.is_none_or(|rest| point.0 < rest.0)).collect();
        if !moving.is_empty() {
            let style = Style::Markers(Marker::Circle);
            plot.add(catalogue.text("plot-turning-points"), Role::TurningPoints, style, moving);
        }
        if let Some((time, position)) = rest {
            let name = catalogue.format(
                "plot-rest",
                &[
                    ("time", catalogue.quantity(time, "s", 4).into()),
                    ("position", catalogue.quantity(position, "m", 4).into()),
                ],
            );
            plot.add(name, Role::Rest, Style::Markers(Marker::Diamond), [(time, position)]);
        }
        if data.sticking_offset > 0.0 {
            let offset = catalogue.quantity(data.sticking_offset, "m", 4);
            let name = catalogue.format("plot-sticking-band", &[("offset", offset.into())]);
            plot.add_band(name, -data.sticking_offset, data.sticking_offset);
        }
        plot
    }

    /// Holds another curve (s, m) beside the motion, which is of this `kind`: the curve dashed above
    /// it, the motion named as what it is and wide enough to be seen where the two agree.
    pub fn compare(
        &mut self,
        catalogue: &Catalogue,
        kind: Kind,
        name: &str,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) {
        let Some(motion) = self.series.iter().position(|series| series.role == Role::Exact) else {
            return;
        };
        self.series[motion].name = catalogue.text(match kind {
            Kind::ClosedForm | Kind::FirstIntegral => "plot-exact-motion",
            Kind::Series => "plot-motion-to-rounding",
        });
        self.series[motion].style = Style::WIDE;
        self.add(name, Role::Comparison(0), Style::LONG_DASHED, points);
        let curve = self.series.pop();
        let heights = curve.iter().flat_map(|curve| &curve.points).map(|point| point.1);
        let extreme = |pick: fn(f64, f64) -> f64| {
            let height = heights.clone().reduce(pick).unwrap_or(0.0);
            catalogue.quantity(height * self.y.unit_size, "m", 4).into()
        };
        let variables =
            [("name", name.into()), ("lowest", extreme(f64::min)), ("highest", extreme(f64::max))];
        let sentence = catalogue.format("plot-comparison-description", &variables);
        self.description = format!("{} {sentence}", self.description);
        // Second in the legend, beside the motion.
        self.series.splice(motion + 1..motion + 1, curve);
    }
}

/// The samples and the turning points in order of time: the extremes belong to the curve even where
/// no sample falls on them.
fn curve(data: &MotionData<'_>) -> Vec<(f64, f64)> {
    let samples = data.times.iter().copied().zip(data.positions.iter().copied());
    let turning_points = data.turning_points.iter().map(|point| (point.time, point.position));
    let mut points: Vec<_> = samples.chain(turning_points).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// |x| at the turning points, and at the release if that is one.
fn envelope(data: &MotionData<'_>) -> Vec<(f64, f64)> {
    let release = match (data.from_rest, data.times, data.positions) {
        (true, [time, ..], [position, ..]) => Some((*time, position.abs())),
        _ => None,
    };
    let turning_points = data.turning_points.iter().map(|point| (point.time, point.position.abs()));
    release.into_iter().chain(turning_points).collect()
}

fn rest_within(data: &MotionData<'_>, duration: f64) -> Option<(f64, f64)> {
    match data.outcome {
        Outcome::Rests(rest) if rest.time <= duration => Some((rest.time, rest.position)),
        _ => None,
    }
}

fn description(catalogue: &Catalogue, data: &MotionData<'_>, title: &str, duration: f64) -> String {
    let length = |x: f64| catalogue.quantity(x, "m", 4).into();
    let positions: Vec<_> = curve(data).into_iter().map(|point| point.1).collect();
    let extreme =
        |pick: fn(f64, f64) -> f64| length(positions.iter().copied().reduce(pick).unwrap_or(0.0));
    catalogue.format(
        "plot-motion-description",
        &[
            ("title", title.into()),
            ("duration", catalogue.quantity(duration, "s", 4).into()),
            ("start", length(data.positions.first().copied().unwrap_or(0.0))),
            ("lowest", extreme(f64::min)),
            ("highest", extreme(f64::max)),
            ("outcome", catalogue.outcome(data.outcome).into()),
        ],
    )
}
