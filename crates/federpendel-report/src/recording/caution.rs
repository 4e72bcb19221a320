//! What makes a verdict less sure than its numbers say.

use std::f64::consts::PI;

use federpendel_fit::{Edge, Fault, Loss, Model, Rest};
use federpendel_text::Catalogue;

use super::verdict::STRONG;
use super::{Fitted, edge};

/// Verdicts of fewer swings than these often err.
const FEW_SWINGS: f64 = 5.0;

/// Fewer values in a swing leave its shape open.
const FEW_VALUES: f64 = 4.0;

/// A fitted part shorter than this share of the recording is said.
const SMALL_PART: f64 = 0.5;

/// Sentences of caution.
pub fn cautions(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> Vec<String> {
    [
        pattern(fit, catalogue),
        part(fit, catalogue),
        swings(fit, model, catalogue),
        values(fit, model, catalogue),
        clipping(fit, catalogue),
        outliers(fit, catalogue),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// What makes up the residuals where no noise does, though it is little beside the motion.
fn pattern(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    if fit.report.asked_rejected() {
        // What another mix leaves no trace of says nothing of all mixes.
        return None;
    }
    let finding = fit.report.adequacy.slight()?;
    let effect = format!("{} %", catalogue.number(100.0 * finding.effect, 2));
    let id = match finding.fault {
        Fault::Softening => "fit-slight-softening",
        Fault::Hardening => "fit-slight-hardening",
        Fault::PeriodDrift => "fit-slight-period-drift",
        Fault::Losses | Fault::Residual => "fit-slight-losses",
        Fault::ZeroDrift => "fit-slight-zero-drift",
        Fault::Shape => "fit-slight-shape",
    };
    Some(catalogue.format(id, &[("effect", effect.into())]))
}

/// That only a part was fitted, where the rest is something else than a hand before or a rest after: a small one, or one
/// without first values that only a misfit tells of.
fn part(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let (window, times) = (&fit.report.window, &fit.read.recording.times);
    let whole = times.last()? - times.first()?;
    let strange = [window.begins, window.ends].into_iter().find(|edge| {
        use Edge::{Disturbed, Driven, Misfit, Stopped, Unrest};
        matches!(edge, Driven | Misfit | Disturbed | Unrest | Stopped)
    })?;
    let small = window.to - window.from < SMALL_PART * whole;
    (small || window.begins == Edge::Misfit).then(|| {
        let variables = [
            ("from", catalogue.quantity(window.from, "s", 4).into()),
            ("to", catalogue.quantity(window.to, "s", 4).into()),
            ("why", edge(catalogue, strange).into()),
        ];
        catalogue.format("fit-caution-part", &variables)
    })
}

/// Half periods of the undamped motion in the fitted part, up to this time.
fn half_periods(fit: &Fitted, model: &Model, until: f64) -> f64 {
    model.value("angular_frequency") * (until - fit.report.window.from) / PI
}

fn swings(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> Option<String> {
    let strong = model.value("damping_rate") > STRONG * model.value("angular_frequency");
    // A mass at rest swings no more.
    let until = model.rest.map_or(fit.report.window.to, |rest| rest.time);
    let swings = half_periods(fit, model, until);
    (swings < FEW_SWINGS && !strong).then(|| {
        if (swings - 1.0).abs() < 0.05 {
            return catalogue.text("fit-caution-one-swing");
        }
        let number = ("number", catalogue.number(swings, 2).into());
        catalogue.format("fit-caution-swings", &[number])
    })
}

fn values(fit: &Fitted, model: &Model, catalogue: &Catalogue) -> Option<String> {
    let values = fit.report.samples as f64 / half_periods(fit, model, fit.report.window.to);
    (values < FEW_VALUES).then(|| {
        let number = ("number", catalogue.number(values, 2).into());
        catalogue.format("fit-caution-values", &[number])
    })
}

/// Values far off all others, which sway least squares.
fn outliers(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let report = &fit.report;
    // What a sensor clipped is not to be left aside as outliers are.
    let clipped = report.clipping.is_some_and(|clipping| !clipping.left_out);
    (report.outliers > 0 && report.loss == Loss::Squares && !clipped)
        .then(|| catalogue.format("fit-caution-outliers", &[("count", report.outliers.into())]))
}

/// When the mass comes to rest, as far as it is known.
pub fn rests(rest: &Rest, catalogue: &Catalogue) -> String {
    let time = |time: f64| catalogue.quantity(time, "s", 4).into();
    let (from, to) = rest.between;
    match to {
        _ if rest.early.is_some() => {
            catalogue.format("fit-rests-early", &[("time", time(rest.time))])
        }
        Some(to) if from == to => catalogue.format("fit-rests", &[("time", time(from))]),
        Some(to) => {
            catalogue.format("fit-rests-between", &[("from", time(from)), ("to", time(to))])
        }
        None => catalogue.format("fit-rests-or-not", &[("from", time(from))]),
    }
}

/// That the sensor clipped swings, and what helps.
fn clipping(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    let clipping = fit.report.clipping?;
    let level = |level: f64| catalogue.quantity(level, &fit.report.unit, 3);
    let levels = [clipping.low, clipping.high].into_iter().flatten().map(level);
    let levels = levels.reduce(|one, other| {
        catalogue.format("fit-and", &[("one", one.into()), ("other", other.into())])
    })?;
    let helps = if clipping.left_out {
        "fit-clipped-left-out"
    } else if clipping.enough {
        "fit-clipped-later"
    } else {
        "fit-clipped-smaller"
    };
    let time = catalogue.quantity(clipping.until, "s", 3);
    let helps = catalogue.format(helps, &[("time", time.into()), ("flag", "--from".into())]);
    let variables =
        [("levels", levels.into()), ("count", clipping.turns.into()), ("helps", helps.into())];
    Some(catalogue.format("fit-clipped", &variables))
}

#[cfg(test)]
mod tests {
    use federpendel_text::Language;

    use super::*;

    #[test]
    fn a_rest_that_is_open_is_said_so() {
        let catalogue = Catalogue::new(Language::English);
        let said = |between| {
            let rest = Rest {
                time: 0.9,
                between,
                position: 0.0,
                turning_points: 9,
                static_acceleration: (0.1, None),
                static_above_kinetic: false,
                early: None,
            };
            rests(&rest, &catalogue)
        };
        let closed = said((0.9, Some(0.9)));
        assert!(closed.contains("900 ms") && !closed.contains("open"), "{closed}");
        let open = said((0.8, Some(0.9)));
        assert!(["open", "800 ms", "900 ms"].iter().all(|word| open.contains(word)), "{open}");
        let never = said((0.9, None));
        assert!(never.contains("open") && never.contains("swings on"), "{never}");
    }
}
