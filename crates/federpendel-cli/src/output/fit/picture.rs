//! What a picture of a fit shows.

use federpendel_report::recording::Fitted;
use federpendel_text::Catalogue;
use federpendel_text::plot::Plot;

/// What a picture of a fit shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Picture {
    /// The recording with the fit, and what that leaves.
    #[default]
    Fit,
    /// Loss per swing against amplitude.
    Decrement,
}

impl Picture {
    /// All of them.
    pub const ALL: [Picture; 2] = [Picture::Fit, Picture::Decrement];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Picture::Fit => "fit",
            Picture::Decrement => "decrement",
        }
    }

    /// The picture of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|picture| picture.name() == name)
    }

    /// The picture of `fit` for a file.
    pub(super) fn plot(self, fit: &Fitted, catalogue: &Catalogue) -> Plot {
        match self {
            Picture::Fit => {
                let [mut plot, residuals] = fit.plots(catalogue);
                plot.lens = Some(Box::new(residuals));
                plot
            }
            Picture::Decrement => fit.decrement(catalogue),
        }
    }

    /// The picture of `fit` for a terminal, which has no room for what a fit leaves.
    pub(super) fn on_terminal(self, fit: &Fitted, catalogue: &Catalogue) -> Plot {
        Plot { lens: None, ..self.plot(fit, catalogue) }
    }
}
