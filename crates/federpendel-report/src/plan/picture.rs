//! The picture of a plan.

use federpendel_fit::plan::{Plan, RESOLVED};
use federpendel_text::Catalogue;
use federpendel_text::plot::{Plot, SignificanceCurve, SignificanceData};

use super::law::{name, role};

/// Coefficient over standard error of each expected law, against the amplitude of release.
pub fn plot(catalogue: &Catalogue, plan: &Plan) -> Plot {
    let amplitudes: Vec<f64> = plan.rows.iter().map(|row| row.amplitude).collect();
    let laws: Vec<_> = plan
        .prospects
        .iter()
        .map(|prospect| {
            let place = prospect.law as usize;
            let known = plan.rows.iter().map(|row| row.laws[place]);
            let curve: Vec<f64> =
                known.map(|known| known.map_or(0.0, |known| known.significance)).collect();
            (prospect.law, name(catalogue, prospect.law), curve)
        })
        .collect();
    let curves: Vec<_> = laws
        .iter()
        .map(|(law, name, significances)| SignificanceCurve {
            name,
            role: role(*law),
            amplitudes: &amplitudes,
            significances,
        })
        .collect();
    let data = SignificanceData {
        mix: plan.setup.expected(),
        curves: &curves,
        amplitudes: (plan.setup.smallest(), plan.setup.max_amplitude),
        threshold: RESOLVED,
    };
    Plot::significance(catalogue, &data)
}
