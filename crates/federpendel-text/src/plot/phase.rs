//! The phase portrait: velocity against displacement.

use federpendel::{Mix, Outcome, State, TurningPoint};

use super::{Axis, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the phase portrait shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct PhaseData<'a> {
    /// Which laws of friction act.
    pub mix: Mix,
    /// States in order of time, from the release on. The curve goes straight from one to the next, so
    /// that each swing needs some dozens.
    pub states: &'a [State],
    /// Turning points within the record, in order.
    pub turning_points: &'a [TurningPoint],
    /// How the motion ends. A rest is marked only if the last state has come to it.
    pub outcome: &'a Outcome,
    /// Half width of the sticking band, m; zero without Coulomb friction.
    pub sticking_offset: f64,
}

type Coordinate = fn(&State) -> f64;

/// How far the bar of the sticking band goes, in largest displacements: a wide band would leave nothing to
/// see of the motion.
const WIDEST_BAR: f64 = 1.5;

/// Half the height of the bar, over the largest velocity.
const BAR: f64 = 0.02;
const BAR_POINTS: u16 = 200;

impl Plot {
    /// The phase portrait: v against x, with release, turning points and rest, and the sticking band as a
    /// bar on v = 0.
    pub fn phase(catalogue: &Catalogue, data: &PhaseData<'_>) -> Self {
        let largest = |value: Coordinate| {
            data.states.iter().map(value).fold(0.0, |most: f64, value| most.max(value.abs()))
        };
        let (width, height) = (largest(|state| state.position), largest(|state| state.velocity));
        let extent = if width > 0.0 { width } else { data.sticking_offset };
        let position = Axis::new(catalogue, &catalogue.text("plot-position"), "x", "m", extent);
        let velocity = Axis::new(catalogue, &catalogue.text("plot-speed"), "v", "m/s", height);
        let title =
            catalogue.format("plot-phase-title", &[("mix", catalogue.mix(data.mix).into())]);
        let mut plot = Plot::new(catalogue, title, position.from_zero(), velocity.from_zero());
        plot.description = description(catalogue, data, &plot.title);

        let curve = data.states.iter().map(|state| (state.position, state.velocity));
        plot.add(catalogue.text("plot-motion"), Role::Exact, Style::SOLID, curve);
        plot.add_points(catalogue, data);
        if data.sticking_offset > 0.0 {
            let offset = catalogue.quantity(data.sticking_offset, "m", DIGITS);
            let name = catalogue.format("plot-sticking-band", &[("offset", offset.into())]);
            let widest = if width > 0.0 { WIDEST_BAR * width } else { data.sticking_offset };
            let end = data.sticking_offset.min(widest);
            // An area, which ends where the band ends; a thick line would be round beyond it.
            let half = BAR * if height > 0.0 { height } else { plot.y.unit_size };
            // With points enough for a terminal, which draws an area as upright lines.
            let points = (0..=BAR_POINTS)
                .map(|i| (end * (2.0 * f64::from(i) / f64::from(BAR_POINTS) - 1.0), half));
            plot.add(name, Role::Sticking, Style::SOLID, points);
            let lower = -half / plot.y.unit_size;
            if let Some(bar) = plot.series.last_mut() {
                bar.lower = Some(vec![lower; bar.points.len()]);
            }
        }
        plot
    }

    /// Release, turning points and rest.
    fn add_points(&mut self, catalogue: &Catalogue, data: &PhaseData<'_>) {
        let rest = match (data.outcome, data.states.last()) {
            (Outcome::Rests(rest), Some(last)) if last.position == rest.position => {
                Some(rest.position)
            }
            _ => None,
        };
        // The last turning point may be the rest, which has a marker of its own.
        let moving = data.turning_points.iter().map(|point| point.position);
        let moving: Vec<_> =
            moving.filter(|x| rest.is_none_or(|rest| rest != *x)).map(|x| (x, 0.0)).collect();
        if !moving.is_empty() {
            let name = catalogue.text("plot-turning-points");
            self.add(name, Role::TurningPoints, Style::Markers(Marker::Circle), moving);
        }
        if let Some(state) = release(data) {
            let position = catalogue.quantity(state.position, "m", DIGITS);
            let velocity = catalogue.quantity(state.velocity, "m/s", DIGITS);
            let variables = [("position", position.into()), ("velocity", velocity.into())];
            let name = catalogue.format("plot-release", &variables);
            let point = [(state.position, state.velocity)];
            self.add(name, Role::Release, Style::Markers(Marker::Triangle), point);
        }
        if let Some(rest) = rest {
            let position = catalogue.quantity(rest, "m", DIGITS);
            let name = catalogue.format("plot-phase-rest", &[("position", position.into())]);
            self.add(name, Role::Rest, Style::Markers(Marker::Diamond), [(rest, 0.0)]);
        }
    }
}

/// The first state; a velocity that rounding alone has left is none.
fn release(data: &PhaseData<'_>) -> Option<State> {
    let fastest = data.states.iter().fold(0.0, |most: f64, state| most.max(state.velocity.abs()));
    let first = data.states.first()?;
    let moves = first.velocity.abs() > 1e-12 * fastest;
    Some(State { velocity: if moves { first.velocity } else { 0.0 }, ..*first })
}

fn description(catalogue: &Catalogue, data: &PhaseData<'_>, title: &str) -> String {
    let extreme = |value: Coordinate, pick: fn(f64, f64) -> f64, unit: &str| {
        let found = data.states.iter().map(value).reduce(pick).unwrap_or(0.0);
        catalogue.quantity(found, unit, DIGITS).into()
    };
    let (x, v): (Coordinate, Coordinate) = (|state| state.position, |state| state.velocity);
    let release = release(data).unwrap_or(State { position: 0.0, velocity: 0.0 });
    catalogue.format(
        "plot-phase-description",
        &[
            ("title", title.into()),
            ("position", catalogue.quantity(release.position, "m", DIGITS).into()),
            ("velocity", catalogue.quantity(release.velocity, "m/s", DIGITS).into()),
            ("lowest", extreme(x, f64::min, "m")),
            ("highest", extreme(x, f64::max, "m")),
            ("slowest", extreme(v, f64::min, "m/s")),
            ("fastest", extreme(v, f64::max, "m/s")),
            ("outcome", catalogue.outcome(data.outcome).into()),
        ],
    )
}
