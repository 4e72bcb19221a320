//! Fewer bytes for the same picture, and ids that are unlike those of other pictures on a page.

use kuva::render::render::{PathData, Primitive, Scene};

type Point = (f64, f64);

/// How far a line may be from the points that it leaves out, px.
const TOLERANCE: f64 = 0.1;

/// Writes lines and areas with no more points than their shape needs.
pub(super) fn paths(scene: &mut Scene) {
    for element in &mut scene.elements {
        match element {
            Primitive::PolyLine { points, stroke, stroke_width, stroke_dasharray } => {
                let path = PathData {
                    d: path(&simplified(points)),
                    fill: None,
                    stroke: stroke.clone(),
                    stroke_width: *stroke_width,
                    opacity: None,
                    stroke_dasharray: stroke_dasharray.take(),
                };
                *element = Primitive::Path(Box::new(path));
            }
            Primitive::Path(path_data) => {
                if let Some(points) = outline(&path_data.d) {
                    path_data.d = path(&simplified(&points)) + "z";
                }
            }
            _ => {}
        }
    }
}

/// Makes the ids of the scene of `id`: those of kuva count all pictures drawn so far, so that the same plot would
/// be written differently.
pub(super) fn ids(scene: &mut Scene, id: &str) {
    let clips = scene.elements.iter_mut().filter_map(|element| match element {
        Primitive::ClipStart { id, .. } => Some(id),
        _ => None,
    });
    for (number, clip) in clips.enumerate() {
        let theirs = format!("\"{clip}\"");
        *clip = format!("{id}-clip-{number}");
        for definition in &mut scene.defs {
            *definition = definition.replace(&theirs, &format!("\"{clip}\""));
        }
    }
}

/// The points of a path that is one closed line of straight pieces in absolute coordinates.
fn outline(path: &str) -> Option<Vec<Point>> {
    let numbers: Vec<f64> = path
        .strip_prefix('M')?
        .strip_suffix('Z')?
        .split([' ', 'L', ','])
        .filter(|part| !part.is_empty())
        .map(|part| part.parse().ok())
        .collect::<Option<_>>()?;
    let pairs = numbers.chunks_exact(2);
    pairs.remainder().is_empty().then(|| pairs.map(|pair| (pair[0], pair[1])).collect())
}

/// The points without which the line would leave its place by more than the tolerance (Ramer, Comput. Graph.
/// Image Process. 1, 244, 1972; Douglas and Peucker, Cartographica 10, 112, 1973).
fn simplified(points: &[Point]) -> Vec<Point> {
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
fn path(points: &[Point]) -> String {
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
        assert_eq!(
            outline("M 1.5 2 L 3 4 L 5 6 Z"),
            Some(vec![(1.5, 2.0), (3.0, 4.0), (5.0, 6.0)])
        );
        assert_eq!(outline("M 1 2 A 3 4 5 6 Z"), None);
        assert_eq!(outline("M 1 2 L 3 Z"), None);
    }
}
