//! A curve with fewer points that looks the same.

use super::Span;

/// The points of a curve as far as `columns` columns can show them: of each column the first, the
/// lowest, the highest and the last, so that a fast oscillation fills its range and no false beat
/// appears. Curves that go back in x are left as they are.
pub(crate) fn thin(points: &[(f64, f64)], span: &Span, columns: usize) -> Vec<(f64, f64)> {
    let rising = points.windows(2).all(|pair| pair[0].0 <= pair[1].0);
    if points.len() <= 4 * columns || !rising {
        return points.to_vec();
    }
    let column =
        |x: f64| span.fraction(x).map(|fraction| (fraction * columns as f64).floor() as i64);
    points
        .chunk_by(|a, b| column(a.0) == column(b.0))
        .flat_map(|chunk| {
            let by_height = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
            let place = |point: Option<&(f64, f64)>| {
                point.and_then(|point| chunk.iter().position(|other| other == point)).unwrap_or(0)
            };
            let mut kept = vec![
                0,
                place(chunk.iter().min_by(by_height)),
                place(chunk.iter().max_by(by_height)),
                chunk.len() - 1,
            ];
            kept.sort_unstable();
            kept.dedup();
            kept.into_iter().map(|i| chunk[i])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::Scale;

    #[test]
    fn a_fast_oscillation_fills_its_range_in_every_column() {
        let points: Vec<_> =
            (0..1_000_000).map(|i| (f64::from(i), if i % 2 == 0 { 1.0 } else { -1.0 })).collect();
        let span = Span::of(points.iter().map(|point| point.0), Scale::Linear);
        let thinned = thin(&points, &span, 100);
        assert!(thinned.len() <= 404);
        for column in 0..100 {
            let inside = |point: &&(f64, f64)| (point.0 / 1e4) as usize == column;
            let heights: Vec<_> = thinned.iter().filter(inside).map(|point| point.1).collect();
            assert!(heights.contains(&1.0) && heights.contains(&-1.0), "column {column}");
        }
        assert!(thinned.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    }

    #[test]
    fn few_points_and_closed_curves_stay_as_they_are() {
        let circle: Vec<_> = (0..1000).map(|i| (f64::from(i).cos(), f64::from(i).sin())).collect();
        let span = Span { low: -1.0, high: 1.0, scale: Scale::Linear };
        assert_eq!(thin(&circle, &span, 10), circle);
        assert_eq!(thin(&circle[..3], &span, 10), circle[..3]);
    }
}
