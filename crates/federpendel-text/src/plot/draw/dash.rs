//! Broken lines piece by piece: kuva's PNG begins the pattern anew at every point of a line, so that a
//! line of many points would look solid, and does not enlarge it with the picture.

use kuva::render::render::{Primitive, Scene};

type Point = (f64, f64);

/// Replaces every broken line of the scene by its pieces.
pub(super) fn spell_out(scene: &mut Scene) {
    scene.elements = std::mem::take(&mut scene.elements).into_iter().flat_map(broken).collect();
}

fn broken(element: Primitive) -> Vec<Primitive> {
    match element {
        Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray: Some(pattern) } => {
            let solid = |points| {
                let stroke = stroke.clone();
                Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray: None }
            };
            pieces(&points, &lengths(&pattern)).into_iter().map(solid).collect()
        }
        // In the legend.
        Primitive::Line { x1, y1, x2, y2, stroke, stroke_width, stroke_dasharray } => {
            broken(Primitive::PolyLine {
                points: vec![(x1, y1), (x2, y2)],
                stroke,
                stroke_width,
                stroke_dasharray,
            })
        }
        other => vec![other],
    }
}

fn lengths(pattern: &str) -> Vec<f64> {
    pattern.split_whitespace().filter_map(|length| length.parse().ok()).collect()
}

/// The pieces of the line through `points` that are drawn; `pattern` alternates between the lengths
/// of pieces and of gaps.
fn pieces(points: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    if pattern.is_empty() || pattern.iter().any(|length| *length <= 0.0) {
        return vec![points.to_vec()];
    }
    let mut pieces = vec![points.iter().take(1).copied().collect::<Vec<_>>()];
    let (mut part, mut left) = (0, pattern[0]);
    for pair in points.windows(2) {
        let ((mut x, mut y), to) = (pair[0], pair[1]);
        let mut length = (to.0 - x).hypot(to.1 - y);
        while length > left {
            let along = left / length;
            (x, y) = (x + (to.0 - x) * along, y + (to.1 - y) * along);
            length -= left;
            part += 1;
            left = pattern[part % pattern.len()];
            match pieces.last_mut() {
                Some(piece) if part % 2 == 1 => piece.push((x, y)),
                _ => pieces.push(vec![(x, y)]),
            }
        }
        left -= length;
        if let Some(piece) = pieces.last_mut().filter(|_| part % 2 == 0) {
            piece.push(to);
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pattern_runs_on_through_the_points() {
        let points: Vec<_> = (0..=20).map(|i| (f64::from(i), 0.0)).collect();
        let pieces = pieces(&points, &[5.0, 3.0]);
        let ends: Vec<_> =
            pieces.iter().map(|piece| (piece[0].0, piece[piece.len() - 1].0)).collect();
        assert_eq!(ends, [(0.0, 5.0), (8.0, 13.0), (16.0, 20.0)]);
    }
}
