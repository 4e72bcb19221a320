//! The exact motion and methods laid over it, with a lens on the end, where they differ most.

use federpendel::{Kind, Mix, Outcome, TurningPoint};

use super::{Axis, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the overlay shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct OverlayData<'a> {
    /// Which laws of friction act.
    pub mix: Mix,
    /// How the motion is known.
    pub kind: Kind,
    /// Times of the exact samples, rising, s.
    pub times: &'a [f64],
    /// Position at each time, m.
    pub positions: &'a [f64],
    /// Turning points within the record, in order; they belong to the curve even where no sample falls on
    /// them.
    pub turning_points: &'a [TurningPoint],
    /// How the motion ends.
    pub outcome: &'a Outcome,
    /// Half width of the sticking band, m; zero without Coulomb friction.
    pub sticking_offset: f64,
    /// The methods, in the order of the legend; up to twelve are told apart.
    pub methods: &'a [MethodCurve<'a>],
}

/// The motion as a method has it.
#[derive(Debug, Clone, Copy)]
pub struct MethodCurve<'a> {
    /// Its name.
    pub name: &'a str,
    /// Which of the twelve looks it has: the same in every plot.
    pub number: usize,
    /// Rising times, s.
    pub times: &'a [f64],
    /// Position at each, m.
    pub positions: &'a [f64],
}

/// How far beyond the exact positions a method is followed, as a share of their range.
const BEYOND: f64 = 0.25;

/// How much of what follows the rest the lens shows, as a share of what it shows before it.
const AFTER_REST: f64 = 0.35;

impl Plot {
    /// The exact motion with every method over it and, below, the last two swings before the rest (without
    /// one, the last two periods of the record) seen closer, unless that is all of it.
    pub fn overlay(catalogue: &Catalogue, data: &OverlayData<'_>) -> Self {
        let duration = data.times.last().copied().unwrap_or(0.0);
        let title =
            catalogue.format("plot-overlay-title", &[("mix", catalogue.mix(data.mix).into())]);
        let mut plot = panel(catalogue, data, title, (0.0, duration));
        let (from, until) = closer(data, duration);
        plot.description = description(catalogue, data, &plot.title, (duration, from, until));
        if 0.0 < from && from < until {
            let id = match rest(data, duration) {
                Some(_) => "plot-overlay-last-swings",
                None => "plot-overlay-last-periods",
            };
            plot.lens = Some(Box::new(panel(catalogue, data, catalogue.text(id), (from, until))));
        }
        plot
    }
}

/// All curves over a part of the record, as high as the exact motion there.
pub(super) fn panel(
    catalogue: &Catalogue,
    data: &OverlayData<'_>,
    title: String,
    part: (f64, f64),
) -> Plot {
    let exact = exact(data);
    let inside = exact.iter().filter(|point| (part.0..=part.1).contains(&point.0));
    let (low, high) = inside.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), point| {
        (low.min(point.1), high.max(point.1))
    });
    let height = low.abs().max(high.abs());
    let height = if height.is_finite() && height > 0.0 { height } else { data.sticking_offset };
    let room = BEYOND * (high - low);
    let room = if room > 0.0 { room } else { height };
    let name = catalogue.text("plot-position");
    let position = Axis::new(catalogue, &name, "x", "m", height).within(low - room, high + room);
    window(catalogue, data, title, part, position)
}

/// All curves over a part of the record, as far as this axis shows them.
pub(super) fn window(
    catalogue: &Catalogue,
    data: &OverlayData<'_>,
    title: String,
    (from, until): (f64, f64),
    position: Axis,
) -> Plot {
    let duration = data.times.last().copied().unwrap_or(0.0);
    let time = Axis::new(catalogue, &catalogue.text("plot-time"), "t", "s", duration);
    let mut plot = Plot::new(catalogue, title, time.within(from, until), position);
    plot.add(motion_name(catalogue, data.kind), Role::Exact, Style::WIDE, exact(data));
    for method in data.methods {
        let points = method.times.iter().copied().zip(method.positions.iter().copied());
        let (from, until) = (from - (until - from), until + (until - from));
        // A step outside on each side lets the line reach the edge.
        let points = points.filter(|point| (from..=until).contains(&point.0));
        plot.add(
            method.name,
            Role::Comparison(method.number),
            Style::comparison(method.number),
            points,
        );
    }
    if data.sticking_offset > 0.0 {
        let offset = catalogue.quantity(data.sticking_offset, "m", DIGITS);
        let name = catalogue.format("plot-sticking-band", &[("offset", offset.into())]);
        plot.add_band(name, -data.sticking_offset, data.sticking_offset);
    }
    plot
}

fn motion_name(catalogue: &Catalogue, kind: Kind) -> String {
    catalogue.text(match kind {
        Kind::ClosedForm | Kind::FirstIntegral => "plot-exact-motion",
        Kind::Series => "plot-motion-to-rounding",
    })
}

/// The samples and the turning points in order of time.
fn exact(data: &OverlayData<'_>) -> Vec<(f64, f64)> {
    let samples = data.times.iter().copied().zip(data.positions.iter().copied());
    let turning_points = data.turning_points.iter().map(|point| (point.time, point.position));
    let mut points: Vec<_> = samples.chain(turning_points).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Time of the rest, if the record holds it.
pub(super) fn rest(data: &OverlayData<'_>, duration: f64) -> Option<f64> {
    match data.outcome {
        Outcome::Rests(rest) if rest.time <= duration => Some(rest.time),
        _ => None,
    }
}

/// From when to when the lens looks: from the third last turning point on, the rest being the last, or over
/// the last two periods.
fn closer(data: &OverlayData<'_>, duration: f64) -> (f64, f64) {
    let before = |time: f64| {
        let turns = data.turning_points.iter().filter(move |point| point.time < time);
        turns.map(|point| point.time).collect::<Vec<_>>()
    };
    let back = |turns: &[f64], n: usize| turns.len().checked_sub(n).map_or(0.0, |i| turns[i]);
    match rest(data, duration) {
        Some(time) if time > 0.0 => {
            let from = back(&before(time), 2);
            (from, (time + AFTER_REST * (time - from)).min(duration))
        }
        _ => (back(&before(duration), 4), duration),
    }
}

/// Where the exact motion and every method are at the end of the record.
pub(super) fn ends(catalogue: &Catalogue, data: &OverlayData<'_>) -> String {
    let end = |name: String, positions: &[f64]| {
        let last = catalogue.quantity(positions.last().copied().unwrap_or(0.0), "m", DIGITS);
        catalogue.format("plot-errors-method", &[("name", name.into()), ("error", last.into())])
    };
    let exact = end(motion_name(catalogue, data.kind), data.positions);
    let methods = data.methods.iter().map(|method| end(method.name.to_owned(), method.positions));
    std::iter::once(exact).chain(methods).collect::<Vec<_>>().join("; ")
}

fn description(
    catalogue: &Catalogue,
    data: &OverlayData<'_>,
    title: &str,
    (duration, from, until): (f64, f64, f64),
) -> String {
    let time = |value: f64| catalogue.quantity(value, "s", DIGITS).into();
    catalogue.format(
        "plot-overlay-description",
        &[
            ("title", title.into()),
            ("duration", time(duration)),
            ("from", time(from)),
            ("until", time(until)),
            ("outcome", catalogue.outcome(data.outcome).into()),
            ("methods", ends(catalogue, data).into()),
        ],
    )
}
