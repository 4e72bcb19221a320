//! The pictures of a comparison.

use federpendel_text::Catalogue;
use federpendel_text::plot::{
    ConvergenceData, ErrorsData, MethodCurve, MethodErrors, MethodRungs, OverlayData, Plot,
};

use crate::comparison::{Candidate, Comparison};

/// What a picture of a comparison shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Picture {
    /// Error against time.
    #[default]
    Error,
    /// Largest error against time step.
    Convergence,
    /// Largest error against steps taken.
    Work,
    /// The motions, with a lens on the last swings.
    Motion,
}

/// A method and numbers at the times of the record.
type Curve = (Candidate, Vec<f64>);

impl Picture {
    /// All of them.
    pub const ALL: [Picture; 4] =
        [Picture::Error, Picture::Convergence, Picture::Work, Picture::Motion];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Picture::Error => "error",
            Picture::Convergence => "convergence",
            Picture::Work => "work",
            Picture::Motion => "motion",
        }
    }

    /// The picture of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|picture| picture.name() == name)
    }

    /// The picture of `comparison`; methods that failed are not in it.
    pub(super) fn plot(self, comparison: &Comparison, catalogue: &Catalogue) -> Plot {
        match self {
            Picture::Error => errors(comparison, catalogue),
            Picture::Convergence => ladders(comparison, catalogue, Plot::convergence),
            Picture::Work => ladders(comparison, catalogue, Plot::work),
            Picture::Motion => overlay(comparison, catalogue),
        }
    }
}

fn errors(comparison: &Comparison, catalogue: &Catalogue) -> Plot {
    let record = &comparison.record;
    let times: Vec<f64> = record.exact.iter().map(|sample| sample.time).collect();
    let curves: Vec<Curve> = comparison
        .measured()
        .map(|(candidate, measured)| {
            let pairs = measured.states.iter().zip(&record.exact);
            (candidate, pairs.map(|(state, exact)| state.position - exact.position).collect())
        })
        .collect();
    let methods: Vec<_> = curves
        .iter()
        .map(|(candidate, errors)| MethodErrors {
            name: candidate.name(),
            number: candidate.number(),
            times: &times,
            errors,
        })
        .collect();
    let mix = record.motion.oscillator().friction().mix();
    let amplitude = record.motion.amplitude();
    Plot::errors(catalogue, &ErrorsData { mix, amplitude, methods: &methods })
}

fn ladders(
    comparison: &Comparison,
    catalogue: &Catalogue,
    plot: fn(&Catalogue, &ConvergenceData<'_>) -> Plot,
) -> Plot {
    let methods: Vec<_> = comparison
        .measured()
        .filter_map(|(candidate, measured)| {
            let (name, number) = (candidate.name(), candidate.number());
            let rungs = &measured.ladder.rungs[..];
            let order = candidate.order().filter(|_| !rungs.is_empty())?;
            Some(MethodRungs { name, number, order, rungs })
        })
        .collect();
    let mix = comparison.record.motion.oscillator().friction().mix();
    plot(catalogue, &ConvergenceData { mix, methods: &methods })
}

fn overlay(comparison: &Comparison, catalogue: &Catalogue) -> Plot {
    let record = &comparison.record;
    let times: Vec<f64> = record.exact.iter().map(|sample| sample.time).collect();
    let positions: Vec<f64> = record.exact.iter().map(|sample| sample.position).collect();
    let curves: Vec<Curve> = comparison
        .measured()
        .map(|(candidate, measured)| {
            (candidate, measured.states.iter().map(|state| state.position).collect())
        })
        .collect();
    let methods: Vec<_> = curves
        .iter()
        .map(|(candidate, positions)| MethodCurve {
            name: candidate.name(),
            number: candidate.number(),
            times: &times,
            positions,
        })
        .collect();
    let oscillator = record.motion.oscillator();
    Plot::overlay(
        catalogue,
        &OverlayData {
            mix: oscillator.friction().mix(),
            kind: record.motion.kind(),
            times: &times,
            positions: &positions,
            turning_points: &record.plotted_turning_points(),
            outcome: &record.outcome,
            sticking_offset: oscillator.sticking_offset(),
            methods: &methods,
        },
    )
}
