//! What several drawings have in common: the wall, the guide, the spring and the mass.

use super::pen::{Anchor, Pen, Point};

/// Half the width and the height of the mass.
pub const MASS: Point = (40.0, 84.0);
/// How far the strokes go that mark what does not move, and how far apart they are.
const HATCH: (f64, f64) = (9.0, 12.0);
/// Turns of the spring.
const TURNS: usize = 9;

/// A wall that ends on the guide at `foot`, and the guide from there to `end`.
pub fn ground(pen: &mut Pen, foot: Point, height: f64, end: f64) {
    let (x, y) = foot;
    pen.group("fixed", |pen| {
        pen.line(&[(x, y - height), foot, (end, y)]);
        for place in 1..=(height / HATCH.1) as usize {
            let y = y - height + HATCH.1 * place as f64;
            pen.line(&[(x, y - HATCH.0), (x - HATCH.0, y)]);
        }
        for place in 1..=((end - x) / HATCH.1) as usize {
            let x = x + HATCH.1 * place as f64;
            pen.line(&[(x, y), (x - HATCH.0, y + HATCH.0)]);
        }
    });
}

/// A spring along a height from `left` to `right`.
pub fn spring(pen: &mut Pen, left: f64, right: f64, height: f64) {
    let straight = 10.0;
    let step = (right - left - 2.0 * straight) / (2 * TURNS) as f64;
    let mut points = vec![(left, height), (left + straight, height)];
    for half in 0..2 * TURNS {
        let side = if half % 2 == 0 { -11.0 } else { 11.0 };
        points.push((left + straight + step * (half as f64 + 0.5), height + side));
    }
    points.extend([(right - straight, height), (right, height)]);
    pen.group("spring", |pen| pen.line(&points));
}

/// The mass, standing on `foot`.
pub fn mass(pen: &mut Pen, foot: Point) {
    let ((x, y), (half, height)) = (foot, MASS);
    pen.group("mass", |pen| {
        pen.outline(&[
            (x - half, y),
            (x - half, y - height),
            (x + half, y - height),
            (x + half, y),
        ]);
        pen.label((x + half - 8.0, y - height + 20.0), Anchor::End, "$m$");
    });
}
