//! What a fit found, in sentences.

use federpendel::Mix;
use federpendel_fit::{Fault, Laws, Model, Standing, damping};
use federpendel_text::Catalogue;

use super::Fitted;
use super::caution::{cautions, rests};
use super::law::{LAWS, Law};
use super::physical::{symbol, value};

/// From this share of the lost energy on a law dominates.
const DOMINATES: f64 = 2.0 / 3.0;

/// From so many standard errors on nobody asks whether a law is there.
const BEYOND_DOUBT: f64 = 10.0;

/// All laws at once.
const ALL: Mix = Mix { stokes: true, coulomb: true, newton: true };

/// The verdict: what acts and how strongly, what is not needed, what cannot be told, what is wrong.
pub fn sentences(fit: &Fitted, catalogue: &Catalogue) -> Vec<String> {
    let report = &fit.report;
    let asked = matches!(report.laws, Laws::Exactly(_));
    let Some(model) = report.best() else { return vec![] };
    let mut sentences = Vec::new();
    if asked {
        sentences.push(as_asked(fit, model, catalogue));
    }
    if !report.adequacy.adequate {
        // What acts cannot be told from a motion that no mix describes.
        sentences.push(wrong(fit, catalogue));
        sentences.extend(cautions(fit, model, catalogue));
        return sentences;
    }
    if !asked {
        sentences.push(match report.verdict.alternatives[..] {
            [] => acting(fit, model, catalogue),
            _ => open(fit, catalogue),
        });
    }
    sentences.extend(asked_rejected(fit, catalogue));
    sentences.extend(physically(fit, catalogue));
    sentences.extend(regime(fit, catalogue));
    sentences.extend(not_needed(fit, catalogue));
    sentences.extend(cautions(fit, model, catalogue));
    sentences.extend(not_separated(fit, catalogue));
    sentences.extend(model.rest.as_ref().map(|rest| rests(rest, catalogue)));
    sentences
}

/// The laws of the verdict's mix with their coefficients, that which takes most energy first.
fn acting(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> String {
    let shares = fit.report.shares.unwrap_or_default();
    let mut acting: Vec<(&Law, f64)> =
        LAWS.iter().zip(shares).filter(|(law, _)| (law.acts)(model.mix)).collect();
    acting.sort_by(|(_, one), (_, other)| other.total_cmp(one));
    let Some(((first, share), others)) = acting.split_first() else {
        return catalogue.text(if fit.grows() { "fit-acts-growing" } else { "fit-acts-none" });
    };
    let percent = |share: f64| format!("{} %", catalogue.number(100.0 * share, 2));
    let variables = [
        ("law", first.name(catalogue).into()),
        ("value", first.value(fit, model, catalogue).into()),
        ("share", percent(*share).into()),
    ];
    let id = match others {
        [] => "fit-acts-alone",
        _ if *share >= DOMINATES => "fit-dominates",
        _ => "fit-leads",
    };
    let also = others.iter().map(|(law, share)| {
        let sigmas = law.sigmas(model).filter(|sigmas| *sigmas < BEYOND_DOUBT);
        let surely = sigmas.map(|sigmas| format!("{}σ, ", catalogue.number(sigmas.round(), 2)));
        let variables = [
            ("law", law.inside(catalogue).into()),
            ("value", law.value(fit, model, catalogue).into()),
            ("surely", surely.unwrap_or_default().into()),
            ("share", percent(*share).into()),
        ];
        catalogue.format("fit-acts-too", &variables)
    });
    let clauses: Vec<_> = std::iter::once(catalogue.format(id, &variables)).chain(also).collect();
    format!("{}.", clauses.join("; "))
}

/// The mixes that describe the recording equally well, each with its coefficients.
fn open(fit: &Fitted, catalogue: &Catalogue) -> String {
    let verdict = &fit.report.verdict;
    let mixes = std::iter::once(&verdict.mix).chain(&verdict.alternatives);
    let said = mixes.filter_map(|mix| {
        let model = fit.report.model(*mix)?;
        let acting = LAWS.iter().filter(|law| (law.acts)(*mix));
        let values: Vec<_> = acting.map(|law| law.value(fit, model, catalogue)).collect();
        let name = catalogue.mix(*mix);
        let values =
            if values.is_empty() { name } else { format!("{name} ({})", values.join(", ")) };
        Some(values)
    });
    let all = said.reduce(|one, other| {
        catalogue.format("fit-or", &[("one", one.into()), ("other", other.into())])
    });
    catalogue.format("fit-open", &[("mixes", all.unwrap_or_default().into())])
}

/// The verdict's coefficients in physical numbers, where a mass or the like was given.
fn physically(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let settled = fit.report.verdict.alternatives.is_empty();
    let physical = fit.physical.as_ref().filter(|_| settled)?;
    let numbers = physical.numbers();
    let known = |wanted: &str| {
        let (_, answer) = numbers.iter().find(|(name, _)| *name == wanted)?;
        let number = answer.as_ref().ok().filter(|number| number.value != Some(0.0))?;
        Some(match number.interval95 {
            (Some(least), None) if number.value.is_none() => {
                format!("{} ≥ {}", symbol(wanted), catalogue.quantity(least, number.unit, 2))
            }
            _ => format!("{} = {}", symbol(wanted), value(catalogue, number)),
        })
    };
    let dry = known("kinetic").or_else(|| known("coulomb_force"));
    let all: Vec<String> =
        [known("damping"), dry, known("newton_coefficient")].into_iter().flatten().collect();
    (!all.is_empty())
        .then(|| catalogue.format("fit-physically", &[("values", all.join(", ").into())]))
}

/// The coefficients of a mix that was asked for.
fn as_asked(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> String {
    let asked = LAWS.iter().filter(|law| (law.acts)(model.mix));
    let values: Vec<_> = asked.map(|law| law.value(fit, model, catalogue)).collect();
    match values[..] {
        [] => catalogue.text("fit-asked-none"),
        _ => catalogue.format("fit-asked", &[("values", values.join(", ").into())]),
    }
}

/// That further laws fit better than the mix that was asked for.
fn asked_rejected(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    fit.report.asked_rejected().then(|| catalogue.text("fit-asked-rejected"))
}

/// From this damping ratio on one cannot count swings, and the regime is said.
pub(super) const STRONG: f64 = 0.5;

/// Damping ratios within this factor of one are near critical.
const NEAR: f64 = 1.5;

/// Whether the motion is critical, or near it, where viscous friction is strong.
fn regime(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let ratio = damping(&fit.report)?.damping_ratio?;
    let (ratio, error) = (ratio.value?, ratio.stderr?);
    if ratio < STRONG {
        return None;
    }
    let surely = |distance: f64| distance.abs() > 2.0 * error;
    let id = if !surely(ratio - 1.0) || (1.0 / NEAR..=NEAR).contains(&ratio) {
        "fit-regime-critical"
    } else if ratio > 1.0 {
        "fit-regime-overdamped"
    } else {
        "fit-regime-strong"
    };
    Some(catalogue.format(id, &[("ratio", catalogue.measured(ratio, error, "1").into())]))
}

/// The laws without which the recording is described as well, in one sentence.
fn not_needed(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let standing = LAWS.iter().zip(fit.report.verdict.laws);
    let laws: Vec<_> =
        standing.filter(|(_, stands)| *stands == Standing::NotNeeded).map(|(law, _)| law).collect();
    let (first, others) = laws.split_first()?;
    let limited = |law: &Law, name: String| match law.limit(fit, catalogue) {
        Some(limit) => format!("{name} ({limit})"),
        None => name,
    };
    let all = others.iter().fold(limited(first, first.name(catalogue)), |one, other| {
        let other = limited(other, other.inside(catalogue));
        let pair = [("one", one.into()), ("other", other.into())];
        catalogue.format("fit-and", &pair)
    });
    let variables = [("laws", all.into()), ("number", laws.len().into())];
    Some(catalogue.format("fit-not-needed", &variables))
}

/// The mixes that this recording cannot tell apart, and what recording could.
fn not_separated(fit: &Fitted, catalogue: &Catalogue) -> Vec<String> {
    if fit.report.clipping.is_some() {
        // Of wider swings the sensor would clip more.
        return vec![];
    }
    let sentence = |reach: &federpendel_fit::Reach| {
        let [one, other] = reach.mixes.map(|mix| catalogue.mix(mix));
        let mut variables = vec![("one", one.into()), ("other", other.into())];
        let Some(from) = reach.from else {
            return catalogue.format("fit-never-separates", &variables);
        };
        let amplitude = catalogue.quantity(from, &fit.report.length_unit(), 2);
        variables.push(("amplitude", amplitude.into()));
        catalogue.format("fit-cannot-separate", &variables)
    };
    fit.report.reaches.iter().map(sentence).collect()
}

/// Why no mix describes the recording, or not the one that was asked for: the gravest of what was found.
fn wrong(fit: &Fitted, catalogue: &Catalogue) -> String {
    let grave = fit.report.adequacy.findings.iter().find(|finding| finding.grave);
    let asked = match fit.report.laws {
        Laws::Exactly(mix) if mix != ALL => Some(mix),
        _ => None,
    };
    let said = catalogue.text(match asked {
        None => "fit-no-mix",
        Some(mix) if mix == Mix::default() => "fit-not-undamped",
        Some(_) => "fit-not-this-mix",
    });
    let id = match grave.map(|finding| finding.fault) {
        Some(Fault::Softening) => "fit-wrong-softening",
        Some(Fault::Hardening) => "fit-wrong-hardening",
        Some(Fault::PeriodDrift) => "fit-wrong-period-drift",
        Some(Fault::Losses) if fit.grows() => "fit-wrong-growing",
        Some(Fault::Losses) if asked.is_some() => "fit-wrong-losses-asked",
        Some(Fault::Losses) => "fit-wrong-losses",
        Some(Fault::ZeroDrift) => "fit-wrong-zero-drift",
        Some(Fault::Shape) => "fit-wrong-shape",
        Some(Fault::Residual) => "fit-wrong-residual",
        None => "fit-wrong",
    };
    catalogue.format(id, &[("said", said.into())])
}
