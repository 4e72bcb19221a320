//! The mass in a stream, with what its drag depends on.

use federpendel_text::Catalogue;

use super::pen::{Anchor, Pen, Point, Said};

const SIZE: (f64, f64) = (640.0, 352.0);
const MIDDLE: Point = (300.0, 160.0);
const RADIUS: f64 = 58.0;
/// Heights from which the fluid comes, above and below the middle.
const HEIGHTS: [f64; 4] = [14.0, 46.0, 82.0, 120.0];

/// A round body held in a stream of the velocity v: density of the fluid, frontal area, drag coefficient, and the
/// force. Ids begin with `id`.
pub fn stream(id: &str, catalogue: &Catalogue) -> String {
    let mut pen = Pen::default();
    let (x, y) = MIDDLE;
    pen.group("flow", |pen| {
        for (height, side) in HEIGHTS.into_iter().flat_map(|height| [(height, 1.0), (height, -1.0)])
        {
            let line = streamline(height);
            pen.line(&line.into_iter().map(|at| (x + at.0, y + side * at.1)).collect::<Vec<_>>());
        }
        wake(pen, 1.0);
        wake(pen, -1.0);
    });
    pen.group("mass", |pen| pen.circle(MIDDLE, RADIUS));
    pen.group("area", |pen| pen.ellipse(MIDDLE, (15.0, RADIUS)));
    labels(&mut pen, catalogue);
    pen.finish(id, SIZE, &Said::plain(catalogue, "sketch-stream", "sketch-stream.description"))
}

fn labels(pen: &mut Pen, catalogue: &Catalogue) {
    let (x, y) = MIDDLE;
    pen.group("velocity", |pen| {
        pen.arrow((40.0, y), (120.0, y));
        pen.label((128.0, y + 6.0), Anchor::Start, "$v$");
    });
    pen.group("force friction", |pen| {
        pen.arrow((x + RADIUS, y), (x + RADIUS + 110.0, y));
        pen.label((x + RADIUS + 116.0, y + 6.0), Anchor::Start, "$F_R$");
    });
    let below = SIZE.1 - 12.0;
    pen.group("thin", |pen| {
        pen.line(&[(x - 4.0, y + 30.0), (x - 60.0, below - 22.0)]);
        pen.line(&[(x + 0.7 * RADIUS, y + 0.7 * RADIUS), (x + 120.0, below - 22.0)]);
    });
    pen.label((20.0, below), Anchor::Start, &catalogue.text("sketch-stream.density"));
    pen.label((x - 50.0, below), Anchor::Middle, &catalogue.text("sketch-stream.area"));
    pen.label((SIZE.0 - 20.0, below), Anchor::End, &catalogue.text("sketch-stream.coefficient"));
}

/// A line of flow that comes from `height` far away: until it passes the body, that of a flow without friction
/// around a cylinder, y (1 − R²/(x² + y²)) = height; then straight on, since the flow tears off.
fn streamline(height: f64) -> Vec<Point> {
    let (left, right, step) = (-280.0, 320.0, 10.0);
    let before = (0..=(-left / step) as usize).map(|place| {
        let x = left + step * place as f64;
        (x, distance(x, height))
    });
    before.chain([(right, distance(0.0, height))]).collect()
}

/// The y of a line of flow at `x`, by bisection.
fn distance(x: f64, height: f64) -> f64 {
    let (mut low, mut high) = (height, height + RADIUS);
    for _ in 0..40 {
        let y = 0.5 * (low + high);
        let reached = y * (1.0 - RADIUS * RADIUS / (x * x + y * y));
        if reached < height { low = y } else { high = y }
    }
    0.5 * (low + high)
}

/// An eddy behind the body, turning inwards.
fn wake(pen: &mut Pen, side: f64) {
    let (x, y) = (MIDDLE.0 + RADIUS + 62.0, MIDDLE.1 + side * 34.0);
    let spiral = (0..=40).map(|place| {
        let (angle, radius) = (0.3 * f64::from(place), 18.0 - 0.36 * f64::from(place));
        (x - 1.5 * radius * angle.cos(), y + side * radius * angle.sin())
    });
    pen.line(&spiral.collect::<Vec<_>>());
}
