//! Stacked areas in braille dots, told apart by their patterns.

use super::braille::Canvas;
use crate::plot::{Plot, Role, Series, Span};

/// Whether the dot at `x` and `y` of an area of this role is set.
fn is_set(role: Role, x: i64, y: i64) -> bool {
    match role {
        Role::Kinetic => x.rem_euclid(4) == 0 && y.rem_euclid(4) == 0,
        Role::Potential => x.rem_euclid(2) == 0,
        Role::Stokes => y.rem_euclid(4) == 1,
        Role::Newton => (x + y).rem_euclid(2) == 0,
        _ => true,
    }
}

/// Fills the areas of `plot` column by column; between two areas a row of dots is left out.
pub(super) fn draw(plot: &Plot, canvas: &mut Canvas, x: &Span, y: &Span) {
    let (width, height) = (canvas.width(), canvas.height());
    for series in plot.series.iter().filter(|series| series.lower.is_some()) {
        for right in 0..width {
            let at = x.at(right as f64 / (width - 1) as f64);
            let Some((low, high)) = edges(series, at) else { continue };
            let down = |value: f64| {
                let up = y.fraction(value).unwrap_or(0.0).clamp(0.0, 1.0);
                height - 1 - (up * (height - 1) as f64).round() as i64
            };
            for dot in down(high) + 1..=down(low) {
                if is_set(series.role, right, dot) {
                    canvas.dot(right, dot, Some(series.role));
                }
            }
        }
    }
}

/// The lower and the upper edge of an area at `x`.
fn edges(series: &Series, x: f64) -> Option<(f64, f64)> {
    let lower = series.lower.as_ref()?;
    let after = series.points.partition_point(|point| point.0 <= x);
    let (before, after) = (after.checked_sub(1)?, after.min(series.points.len() - 1));
    let ((from, high), (to, next_high)) = (series.points[before], series.points[after]);
    let share = if to > from { (x - from) / (to - from) } else { 0.0 };
    let (low, next_low) = (*lower.get(before)?, *lower.get(after)?);
    Some((low + share * (next_low - low), high + share * (next_high - high)))
}

/// A piece of an area, for the legend.
pub(super) fn sample(role: Role) -> String {
    let mut canvas = Canvas::new(3, 1);
    for (x, y) in (0..6).flat_map(|x| (0..4).map(move |y| (x, y))) {
        if is_set(role, x, y) {
            canvas.dot(x, y, None);
        }
    }
    canvas.row(0).iter().map(|cell| cell.character()).collect()
}
