//! The exact motion and methods laid over it, without a lens: a figure above another, such as their errors.

use super::Plot;
use super::overlay::{OverlayData, ends, panel};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

impl Plot {
    /// The exact motion with every method over it, as [`Plot::overlay`] has them but without a lens. What runs
    /// away is cut off, so that the exact motion keeps its height.
    pub fn beside(catalogue: &Catalogue, data: &OverlayData<'_>) -> Self {
        let duration = data.times.last().copied().unwrap_or(0.0);
        let title =
            catalogue.format("plot-overlay-title", &[("mix", catalogue.mix(data.mix).into())]);
        let mut plot = panel(catalogue, data, title, (0.0, duration));
        plot.description = catalogue.format(
            "plot-beside-description",
            &[
                ("title", plot.title.clone().into()),
                ("duration", catalogue.quantity(duration, "s", DIGITS).into()),
                ("outcome", catalogue.outcome(data.outcome).into()),
                ("methods", ends(catalogue, data).into()),
            ],
        );
        plot
    }
}
