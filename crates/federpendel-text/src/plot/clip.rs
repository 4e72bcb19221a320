//! What of a curve lies within the axes: back ends draw beyond them.

use super::Span;

type Point = (f64, f64);

/// A hair beyond the axes, so that a point on the edge counts as inside.
const SLACK: f64 = 1e-9;

/// The pieces of the line through `points` within both spans. Points that cannot be shown at all (not
/// finite, or not positive on a logarithmic axis) are left out.
pub(crate) fn clip(points: &[Point], x: &Span, y: &Span) -> Vec<Vec<Point>> {
    let place = |point: &Point| Some((x.fraction(point.0)?, y.fraction(point.1)?));
    let shown: Vec<_> =
        points.iter().filter_map(|point| place(point).map(|place| (*point, place))).collect();
    if let [(point, place)] = shown[..] {
        return if inside(place) { vec![vec![point]] } else { Vec::new() };
    }
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut open = false;
    for pair in shown.windows(2) {
        let ((from, a), (to, b)) = (pair[0], pair[1]);
        let Some((first, last)) = range(a, b) else {
            open = false;
            continue;
        };
        let at = |share: f64| {
            let along = |a: f64, b: f64| a + (b - a) * share;
            (x.at(along(a.0, b.0)), y.at(along(a.1, b.1)))
        };
        if !open {
            pieces.push(vec![if first > 0.0 { at(first) } else { from }]);
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(if last < 1.0 { at(last) } else { to });
        }
        open = last >= 1.0;
    }
    pieces
}

/// Whether a point, given by where it lies along both spans, is within them.
pub(crate) fn inside(place: Point) -> bool {
    let within = |fraction: f64| (-SLACK..=1.0 + SLACK).contains(&fraction);
    within(place.0) && within(place.1)
}

/// Between which shares of its length the way from `a` to `b` lies inside (Liang and Barsky, ACM Trans.
/// Graph. 3, 1, 1984).
fn range(a: Point, b: Point) -> Option<(f64, f64)> {
    let (mut first, mut last) = (0.0, 1.0);
    for (a, b) in [(a.0, b.0), (a.1, b.1)] {
        let step = b - a;
        for (edge, room) in [(-step, a + SLACK), (step, 1.0 + SLACK - a)] {
            if edge == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if edge < 0.0 {
                first = f64::max(first, room / edge);
            } else {
                last = f64::min(last, room / edge);
            }
        }
    }
    (first <= last).then_some((first, last))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::Scale;

    #[test]
    fn a_line_that_leaves_and_comes_back_is_two_pieces() {
        let span = Span { low: 0.0, high: 10.0, scale: Scale::Linear };
        let pieces = clip(&[(1.0, 5.0), (3.0, 15.0), (5.0, 5.0), (6.0, 5.0)], &span, &span);
        assert_eq!(pieces.len(), 2);
        assert_eq!(
            (pieces[0][0], pieces[1][1], pieces[1][2]),
            ((1.0, 5.0), (5.0, 5.0), (6.0, 5.0))
        );
        assert!((pieces[0][1].0 - 2.0).abs() < 1e-6 && (pieces[0][1].1 - 10.0).abs() < 1e-6);
        assert!((pieces[1][0].0 - 4.0).abs() < 1e-6);
    }

    #[test]
    fn a_line_across_the_whole_picture_is_cut_at_both_ends() {
        let x = Span { low: 0.0, high: 1.0, scale: Scale::Linear };
        let y = Span { low: 1e-4, high: 1.0, scale: Scale::Logarithmic };
        let pieces = clip(&[(0.0, 1e-6), (0.5, 0.0), (1.0, 1e2)], &x, &y);
        assert_eq!(pieces.len(), 1);
        assert!((pieces[0][0].0 - 0.25).abs() < 1e-6 && (pieces[0][0].1 / 1e-4 - 1.0).abs() < 1e-6);
        assert!((pieces[0][1].0 - 0.75).abs() < 1e-6 && (pieces[0][1].1 - 1.0).abs() < 1e-6);
        assert!(clip(&[(2.0, 0.1), (3.0, 0.1)], &x, &y).is_empty());
    }
}
