//! What a fit found, in sentences.

use federpendel::Mix;
use federpendel_fit::{Fault, Model, Standing};
use federpendel_text::Catalogue;

use super::Fitted;

/// The laws, each with the parameter that says how strongly it acts, in the order of the verdict.
const LAWS: [Law; 3] = [
    Law { name: "article-law-stokes", acts: "fit-law-stokes", parameter: "damping_rate" },
    Law { name: "article-law-coulomb", acts: "fit-law-coulomb", parameter: "coulomb_acceleration" },
    Law { name: "article-law-newton", acts: "fit-law-newton", parameter: "newton_rate" },
];

/// A law: the sentences that name it and say how strongly it acts, and its parameter.
struct Law {
    name: &'static str,
    acts: &'static str,
    parameter: &'static str,
}

/// The verdict: what acts and how strongly, what is not needed, what cannot be told, what is wrong.
pub fn sentences(fit: &Fitted, catalogue: &Catalogue) -> Vec<String> {
    let report = &fit.report;
    let mut sentences = Vec::new();
    if !report.adequacy.adequate {
        // What acts cannot be told from a motion that no mix describes.
        return vec![wrong(fit, catalogue)];
    }
    sentences.extend(report.best().map(|model| acting(fit, model, catalogue)));
    for (law, standing) in LAWS.iter().zip(report.verdict.laws) {
        if standing == Standing::NotNeeded {
            let law = catalogue.text(law.name);
            sentences.push(catalogue.format("fit-not-needed", &[("law", law.into())]));
        }
    }
    let mix = |mix: Mix| catalogue.mix(mix);
    for reach in &report.reaches {
        let [one, other] = reach.mixes.map(mix);
        let pair = [("one", one.into()), ("other", other.into())];
        sentences.push(match reach.from {
            Some(from) => {
                let amplitude = catalogue.quantity(from, &fit.report.length_unit(), 2);
                let [one, other] = pair;
                catalogue
                    .format("fit-cannot-separate", &[one, other, ("amplitude", amplitude.into())])
            }
            None => catalogue.format("fit-never-separates", &pair),
        });
    }
    let rest = report.best().and_then(|model| model.rest.as_ref());
    sentences.extend(rest.map(|rest| {
        let time = catalogue.quantity(rest.time, "s", 4);
        catalogue.format("fit-rests", &[("time", time.into())])
    }));
    sentences
}

/// The laws of the verdict's mix with their coefficients.
fn acting(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> String {
    let mix = fit.report.verdict.mix;
    let acts = [mix.stokes, mix.coulomb, mix.newton];
    let laws = LAWS.iter().zip(acts).filter(|(_, acts)| *acts).filter_map(|(law, _)| {
        let parameter = model.parameter(law.parameter)?;
        let error = parameter.stderr.unwrap_or(f64::NAN);
        let value = catalogue.measured(parameter.value?, error, &fit.report.unit_of(law.parameter));
        Some(catalogue.format(law.acts, &[("value", value.into())]))
    });
    let joined = laws.reduce(|one, other| {
        catalogue.format("fit-and", &[("one", one.into()), ("other", other.into())])
    });
    match joined {
        None => catalogue.text("fit-acts-none"),
        Some(laws) => catalogue.format("fit-acts", &[("laws", laws.into())]),
    }
}

/// Why no mix describes the recording: the gravest of what was found.
fn wrong(fit: &Fitted, catalogue: &Catalogue) -> String {
    let grave = fit.report.adequacy.findings.iter().find(|finding| finding.grave);
    catalogue.text(match grave.map(|finding| finding.fault) {
        Some(Fault::Softening) => "fit-wrong-softening",
        Some(Fault::Hardening) => "fit-wrong-hardening",
        Some(Fault::PeriodDrift) => "fit-wrong-period-drift",
        Some(Fault::Losses) => "fit-wrong-losses",
        Some(Fault::ZeroDrift) => "fit-wrong-zero-drift",
        Some(Fault::Shape) => "fit-wrong-shape",
        None => "fit-wrong",
    })
}
