//! A plan in a few sentences.

use federpendel_fit::plan::{Limit, Pair, Plan, Prospect};
use federpendel_text::{Catalogue, Value};

use super::law::{coefficient, name};

/// Digits of amplitudes and durations: those of a plan have two, those of the user may have more.
const DIGITS: usize = 3;

/// From this correlation on two laws look alike.
const ALIKE: f64 = 0.9;

/// What to do, what that shows and what it does not.
pub fn sentences(catalogue: &Catalogue, plan: &Plan) -> Vec<String> {
    let mut sentences = vec![advice(catalogue, plan)];
    sentences.extend(drowned(catalogue, plan));
    let unresolved = plan.prospects.iter().filter(|prospect| prospect.smallest.is_none());
    sentences.extend(unresolved.map(|prospect| self::unresolved(catalogue, plan, prospect)));
    let alike = |pair: &&Pair| !pair.separated && pair.correlation.abs() >= ALIKE;
    sentences.extend(plan.pairs.iter().filter(alike).map(|pair| confused(catalogue, plan, pair)));
    sentences.extend(plan.limits.iter().map(|limit| self::limit(catalogue, plan, limit)));
    sentences
}

fn length(catalogue: &Catalogue, value: f64) -> Value<'static> {
    catalogue.quantity(value, "m", DIGITS).into()
}

fn time(catalogue: &Catalogue, value: f64) -> Value<'static> {
    catalogue.quantity(value, "s", DIGITS).into()
}

fn advice(catalogue: &Catalogue, plan: &Plan) -> String {
    if plan.prospects.is_empty() {
        return catalogue.text("plan-none-expected");
    }
    let Some(advice) = plan.advice() else {
        let amplitude = length(catalogue, plan.setup.max_amplitude);
        return catalogue.format("plan-advice-none", &[("amplitude", amplitude)]);
    };
    let variables = [
        ("amplitude", length(catalogue, advice.amplitude)),
        ("duration", time(catalogue, advice.duration)),
        ("mix", catalogue.mix(advice.laws).into()),
    ];
    let resolved = plan.prospects.iter().filter(|prospect| prospect.smallest.is_some()).count();
    let id = if resolved == 1 { "plan-advice-one" } else { "plan-advice-some" };
    catalogue.format(id, &variables)
}

/// Which of the laws that can be resolved is lost first, and where.
fn drowned(catalogue: &Catalogue, plan: &Plan) -> Option<String> {
    let resolved = plan.prospects.iter().filter(|prospect| prospect.smallest.is_some());
    let drowned = resolved.filter_map(|prospect| Some((prospect.drowned?, prospect.law)));
    let (amplitude, law) = drowned.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let variables =
        [("amplitude", length(catalogue, amplitude)), ("law", name(catalogue, law).into())];
    // Where too few swings remain nothing is planned, however well the law might show.
    let planned = plan.rows.iter().any(|row| row.amplitude == amplitude && row.longest > 0.0);
    let id = if planned { "plan-drowns" } else { "plan-too-few-swings" };
    Some(catalogue.format(id, &variables))
}

/// A law that even the largest amplitude does not resolve, and what would.
fn unresolved(catalogue: &Catalogue, plan: &Plan, prospect: &Prospect) -> String {
    let law = ("law", name(catalogue, prospect.law).into());
    let amplitude = ("amplitude", length(catalogue, plan.setup.max_amplitude));
    let (Some(known), Some(factor)) = (prospect.largest, prospect.noise_factor()) else {
        return catalogue.format("plan-unseen", &[law, amplitude]);
    };
    let mut variables = vec![
        law,
        amplitude,
        ("significance", catalogue.number(known.significance, 2).into()),
        ("factor", catalogue.number(factor, 2).into()),
        ("square", catalogue.number(factor * factor, 2).into()),
    ];
    match prospect.beyond {
        None => catalogue.format("plan-unresolved", &variables),
        Some(beyond) => {
            variables.push(("beyond", length(catalogue, beyond)));
            catalogue.format("plan-unresolved-beyond", &variables)
        }
    }
}

/// Two laws that look alike.
fn confused(catalogue: &Catalogue, plan: &Plan, pair: &Pair) -> String {
    let [one, other] = pair.laws.map(|law| name(catalogue, law).into());
    let variables = [
        ("one", one),
        ("other", other),
        ("amplitude", length(catalogue, plan.setup.max_amplitude)),
        ("correlation", catalogue.number(pair.correlation, 2).into()),
    ];
    catalogue.format("plan-confused", &variables)
}

/// How little of a law that is not expected would show.
fn limit(catalogue: &Catalogue, plan: &Plan, limit: &Limit) -> String {
    let variables = [
        ("law", name(catalogue, limit.law).into()),
        ("value", coefficient(catalogue, limit.law, limit.resolved()).into()),
        ("amplitude", length(catalogue, plan.setup.max_amplitude)),
        ("duration", time(catalogue, limit.duration)),
    ];
    catalogue.format("plan-limit", &variables)
}
