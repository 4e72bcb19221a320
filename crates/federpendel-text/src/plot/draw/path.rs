//! Lines as SVG paths, with no more points and signs than their shape needs.

pub(super) type Point = (f64, f64);

/// How far a line may be from the points that it leaves out, px.
const TOLERANCE: f64 = 0.1;

/// The points without which the line would leave its place by more than the tolerance (Ramer, Comput. Graph.
/// Image Process. 1, 244, 1972; Douglas and Peucker, Cartographica 10, 112, 1973).
pub(super) fn simplified(points: &[Point]) -> Vec<Point> {
    let mut kept = vec![false; points.len()];
    for end in [0, points.len().saturating_sub(1)] {
        if let Some(kept) = kept.get_mut(end) {
            *kept = true;
        }
    }
    let mut parts = vec![(0, points.len().saturating_sub(1))];
    while let Some((first, last)) = parts.pop() {
        let off = |i: usize| distance(points[i], points[first], points[last]);
        let farthest = (first + 1..last).max_by(|&a, &b| off(a).total_cmp(&off(b)));
        if let Some(farthest) = farthest.filter(|&i| off(i) > TOLERANCE) {
            kept[farthest] = true;
            parts.extend([(first, farthest), (farthest, last)]);
        }
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

/// How far `point` is from the straight piece between `from` and `to`.
fn distance(point: Point, from: Point, to: Point) -> f64 {
    let (along, across) = (to.0 - from.0, to.1 - from.1);
    let (x, y) = (point.0 - from.0, point.1 - from.1);
    let squared = along * along + across * across;
    let share = if squared > 0.0 { (x * along + y * across) / squared } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    (x - share * along).hypot(y - share * across)
}

/// A path through the points in tenths of a pixel, each written as the step from the last.
pub(super) fn path(points: &[Point]) -> String {
    let tenths = |value: f64| (10.0 * value).round() as i64;
    let mut path = String::new();
    let mut last = (0, 0);
    for (i, &(x, y)) in points.iter().enumerate() {
        let now = (tenths(x), tenths(y));
        let (right, down) = (now.0 - last.0, now.1 - last.1);
        if i == 0 {
            path = format!("M{} {}l", short(right), short(down));
        } else if (right, down) != (0, 0) || points.len() == 2 {
            let gap = if path.ends_with('l') || right < 0 { "" } else { " " };
            let between = if down < 0 { "" } else { " " };
            path += &format!("{gap}{}{between}{}", short(right), short(down));
        }
        last = now;
    }
    path
}

/// A number of tenths in as few signs as it needs.
fn short(tenths: i64) -> String {
    let (sign, size) = (if tenths < 0 { "-" } else { "" }, tenths.unsigned_abs());
    match (size / 10, size % 10) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, part) => format!("{sign}.{part}"),
        (whole, part) => format!("{sign}{whole}.{part}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points of a path written here.
    fn read(path: &str) -> Vec<Point> {
        let (start, steps) = path.split_once('l').expect("a line");
        let numbers = |text: &str| -> Vec<f64> {
            let spaced = text.replace(['M', 'z'], "").replace('-', " -");
            spaced.split_whitespace().map(|number| number.parse().expect("a number")).collect()
        };
        let mut at = (0.0, 0.0);
        let all = [numbers(start), numbers(steps)].concat();
        let go = |step: &[f64]| {
            at = (at.0 + step[0], at.1 + step[1]);
            at
        };
        all.chunks(2).map(go).collect()
    }

    #[test]
    fn a_curve_keeps_its_place_with_few_points() {
        let points: Vec<Point> = (0..2000)
            .map(|i| 0.25 * f64::from(i))
            .map(|x| (60.0 + x, 200.0 - 150.0 * (0.1 * x).cos()))
            .collect();
        let kept = simplified(&points);
        assert!(kept.len() < points.len() / 5, "{}", kept.len());
        let written = read(&path(&kept));
        assert!(written.len() <= kept.len());
        for point in &points {
            let near = written.windows(2).map(|pair| distance(*point, pair[0], pair[1]));
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(near < 0.2, "{point:?} {near}");
        }
    }

    #[test]
    fn ends_corners_and_closed_lines_stay() {
        let corner = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 5.0)];
        assert_eq!(simplified(&corner), [(0.0, 0.0), (2.0, 0.0), (2.0, 5.0)]);
        let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)];
        assert_eq!(simplified(&square), square);
        assert_eq!(simplified(&[]), []);
        assert_eq!(simplified(&corner[..1]), corner[..1]);
        assert_eq!(path(&[(10.04, 0.5), (10.5, -3.0), (0.0, 2.0)]), "M10 .5l.5-3.5-10.5 5");
    }
}
