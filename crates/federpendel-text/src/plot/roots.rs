//! The roots of the characteristic equation in the complex plane, as Stokes damping grows.

use std::f64::consts::FRAC_PI_2;

use federpendel::article::{Complex, eq_36};
use federpendel::{Oscillator, Stokes};

use super::{Axis, Marker, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plot of the roots shows.
#[derive(Debug, Clone, Copy)]
pub struct RootsData {
    /// Angular frequency ω0 without friction, 1/s.
    pub omega0: f64,
    /// The experiment's own damping rate γ, 1/s.
    pub gamma: f64,
}

/// Damping rates that are marked, over ω0; the last is where the paths end, unless the experiment's own is larger.
const MARKED: [f64; 5] = [0.0, 0.5, 1.0, 1.5, 2.0];

/// Up to this damping ratio there is room for all marks.
const ROOM: f64 = 2.5;

/// Points on each quarter of the circle.
const POINTS: u32 = 60;

/// Where the axes end: on the left over the last root, on the right and at the top over ω0.
const LEFT: f64 = 1.1;
const RIGHT: f64 = 0.8;
const TOP: f64 = 1.3;

impl Plot {
    /// The roots λ of λ² + 2γλ + ω0² = 0 as γ grows: a pair on a circle, which meets at −ω0 and parts along the
    /// real axis; and the experiment's own pair.
    pub fn roots(catalogue: &Catalogue, data: &RootsData) -> Self {
        let axis = |id: &str, symbol| {
            Axis::new(catalogue, &catalogue.text(id), symbol, "1/s", data.omega0)
        };
        let (re, im) = (axis("plot-real-part", "Re λ"), axis("plot-imaginary-part", "Im λ"));
        let mut plot = Plot::new(catalogue, catalogue.text("plot-roots-title"), re, im);
        plot.equal_scales = true;
        plot.description = plot.title.clone();
        let ratio = data.gamma / data.omega0;
        let most = if ratio > 2.0 { 1.1 * ratio } else { 2.0 };
        let (Some(own), Some(ends)) = (roots(ratio), roots(most)) else { return plot };
        if !(data.omega0 * ends[1].re).is_finite() {
            return plot;
        }
        plot.description = description(catalogue, data, own, (most, ends));
        let left = LEFT * ends[1].re;
        let scaled = |root: Complex| (data.omega0 * root.re, data.omega0 * root.im);
        let line = |from, to| [from, to].map(|(re, im)| scaled(Complex::new(re, im)));
        plot.add("", Role::Guide, Style::THIN, line((left, 0.0), (RIGHT, 0.0)));
        plot.add("", Role::Guide, Style::THIN, line((0.0, -TOP), (0.0, TOP)));
        let looks = [(Role::Exact, Style::SOLID), (Role::Envelope, Style::LONG_DASHED)];
        for (i, (role, style)) in looks.into_iter().enumerate() {
            let name = catalogue.format(
                "plot-roots-path",
                &[("symbol", ["λ₁", "λ₂"][i].into()), ("most", catalogue.number(most, 3).into())],
            );
            let path = path(most).into_iter().map(|pair| scaled(pair[i]));
            plot.add(name, role, style, path);
        }
        plot.add_marks(catalogue, data.omega0, most, RIGHT - left);
        let gamma = catalogue.quantity(data.gamma, "1/s", DIGITS);
        let name = catalogue.format("plot-roots-own", &[("gamma", gamma.into())]);
        let style = Style::Markers(Marker::Diamond);
        plot.add(name, Role::Experiment, style, own.map(scaled));
        plot
    }

    /// Marks some damping rates up to `most` on the paths, with what they are beside one root of each pair, in
    /// a plot of this width over ω0.
    fn add_marks(&mut self, catalogue: &Catalogue, omega0: f64, most: f64, width: f64) {
        let marked = MARKED.into_iter().filter(|ratio| most <= ROOM || *ratio == 1.0);
        let mut points = Vec::new();
        for ratio in marked {
            let Some(pair) = roots(ratio) else { continue };
            points.extend(pair.map(|root| (omega0 * root.re, omega0 * root.im)));
            let text = match ratio {
                0.0 => "γ = 0".to_owned(),
                1.0 => "γ = ω₀".to_owned(),
                _ => format!("γ = {} ω₀", catalogue.number(ratio, 3)),
            };
            // Outside the circle, beside the axis, above the fast root; in shares of the width.
            let (root, right, up) = match ratio {
                0.0 => (pair[0], 0.09, 0.01),
                _ if ratio < 1.0 => (pair[0], -0.1, 0.01),
                1.0 => (pair[1], -0.09, 0.025),
                _ => (pair[1], 0.0, 0.025),
            };
            let point = (root.re + right * width, root.im + up * width);
            self.add_note(text, (omega0 * point.0, omega0 * point.1));
        }
        let name = catalogue.text("plot-roots-marks");
        self.add(name, Role::TurningPoints, Style::Markers(Marker::Circle), points);
    }
}

/// λ1 and λ2 over ω0 at a damping ratio; none for one that is no such.
fn roots(ratio: f64) -> Option<[Complex; 2]> {
    let oscillator = Oscillator::new(1.0, 1.0, Stokes::new(2.0 * ratio).ok()?).ok()?;
    eq_36(&oscillator).ok()
}

/// The pairs over ω0 for damping ratios up to `most`, evenly along the circle; beyond it they run straight on.
fn path(most: f64) -> Vec<[Complex; 2]> {
    let angle = |i: u32| FRAC_PI_2 * f64::from(i) / f64::from(POINTS);
    let ratios = (0..=POINTS).map(|i| angle(i).sin());
    ratios.chain([most]).filter_map(roots).collect()
}

/// The experiment's own pair in words.
fn own_text(catalogue: &Catalogue, data: &RootsData, own: [Complex; 2]) -> String {
    let number = |value: f64| catalogue.number(value, DIGITS).into();
    let gamma = ("gamma", number(data.gamma));
    let [slow, fast] = own.map(|root| number(data.omega0 * root.re));
    if own[0].im > 0.0 {
        let imaginary = number(data.omega0 * own[0].im);
        catalogue.format("plot-roots-own-pair", &[gamma, ("real", slow), ("imaginary", imaginary)])
    } else {
        catalogue.format("plot-roots-own-real", &[gamma, ("slow", slow), ("fast", fast)])
    }
}

fn description(
    catalogue: &Catalogue,
    data: &RootsData,
    own: [Complex; 2],
    (most, ends): (f64, [Complex; 2]),
) -> String {
    let rate = |value: f64| catalogue.quantity(value, "1/s", DIGITS).into();
    let [slow, fast] = ends.map(|root| rate(data.omega0 * root.re));
    catalogue.format(
        "plot-roots-description",
        &[
            ("title", catalogue.text("plot-roots-title").into()),
            ("omega", rate(data.omega0)),
            ("most", catalogue.number(most, 3).into()),
            ("slow", slow),
            ("fast", fast),
            ("own", own_text(catalogue, data, own).into()),
        ],
    )
}
