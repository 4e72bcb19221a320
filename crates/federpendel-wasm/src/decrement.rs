//! What each swing costs, from the plot that shows it, so that the page has the words and curves of all other pictures.

use federpendel_text::plot::{Plot, Role, Series};
use serde::Serialize;

/// Loss of amplitude of each swing against its mean amplitude, and what the laws are to cost; in the plot's SI units.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Decrement {
    /// Mean amplitude of each swing.
    pub amplitude: Vec<f64>,
    /// Its loss.
    pub loss: Vec<f64>,
    /// Amplitudes at which the laws are given.
    pub grid: Vec<f64>,
    /// The averaged law, all that acts together first.
    pub parts: Vec<Part>,
}

/// The loss that one law costs at each amplitude of the grid.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Part {
    /// `stokes`, `coulomb`, `newton` or `all`.
    pub law: &'static str,
    /// Its name with its number.
    pub label: String,
    /// The loss.
    pub loss: Vec<f64>,
}

impl Decrement {
    /// What `plot` shows of these `swings`, pairs of mean amplitude and loss.
    pub fn of(plot: &Plot, swings: &[(f64, f64)]) -> Self {
        let size = (plot.x.unit_size, plot.y.unit_size);
        let curves: Vec<_> =
            plot.series.iter().filter_map(|series| Some((law(series)?, series))).collect();
        let grid = curves.first().map_or(Vec::new(), |(_, series)| {
            series.points.iter().map(|point| point.0 * size.0).collect()
        });
        let part = |(law, series): &(&'static str, &Series)| Part {
            law,
            label: series.name.clone(),
            loss: series.points.iter().map(|point| point.1 * size.1).collect(),
        };
        Decrement {
            amplitude: swings.iter().map(|swing| swing.0).collect(),
            loss: swings.iter().map(|swing| swing.1).collect(),
            grid,
            parts: curves.iter().map(part).collect(),
        }
    }

    /// What `plot` shows, swings included.
    pub fn shown(plot: &Plot) -> Self {
        let size = (plot.x.unit_size, plot.y.unit_size);
        let marked = plot.series.iter().filter(|series| series.role == Role::Swings);
        let points = marked.flat_map(|series| &series.points);
        let swings: Vec<_> = points.map(|point| (point.0 * size.0, point.1 * size.1)).collect();
        Self::of(plot, &swings)
    }
}

/// Which law a series shows.
fn law(series: &Series) -> Option<&'static str> {
    match series.role {
        Role::Stokes => Some("stokes"),
        Role::Coulomb => Some("coulomb"),
        Role::Newton => Some("newton"),
        Role::Exact => Some("all"),
        _ => None,
    }
}
