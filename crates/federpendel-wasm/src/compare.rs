//! The error lens: a formula of the article or a numeric method beside the exact motion.

use federpendel::lens::{Candidate, Findings, Remark};
use federpendel::scheme::Setting;
use federpendel::{motion, parameter};
use federpendel_text::Catalogue;
use serde::Serialize;

use crate::Refusal;
use crate::motion::Solution;

/// A method that can be held beside the exact motion.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Method {
    /// Its name on the command line.
    pub id: &'static str,
    /// What it is called.
    pub label: String,
    /// Whether it takes steps of one length, which the user chooses.
    pub needs_step: bool,
    /// The declared order of a numeric method.
    pub order: Option<u32>,
}

/// The curve of a method, and what was found of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Compared {
    /// Times, positions, and how far these are from the exact motion, one behind the other.
    pub numbers: Vec<f64>,
    /// What there is to say: error, order, rest, and what is wrong with a formula of the article.
    pub sentences: Vec<String>,
}

/// All methods, those of `federpendel compare`: the formulas of the article, then what takes steps.
pub fn methods(catalogue: &Catalogue) -> Vec<Method> {
    let method = |candidate: Candidate| Method {
        id: candidate.name(),
        label: catalogue.text(&format!("method-{}", candidate.name())),
        needs_step: matches!(candidate, Candidate::Scheme(scheme) if !scheme.adaptive),
        order: candidate.order(),
    };
    Candidate::all().into_iter().map(method).collect()
}

/// Most steps that a page can wait for.
const MOST_STEPS: u64 = 200_000;

/// The method of this name beside a motion, with a time step (s) if it takes steps, at `count` times of the record.
///
/// # Errors
/// A method that is not known, does not apply or fails, or a step that is not allowed or too short to wait for.
pub fn compare(
    solution: &Solution,
    catalogue: &Catalogue,
    name: &str,
    step: f64,
    count: usize,
) -> Result<Compared, Refusal> {
    let candidate =
        Candidate::named(name).ok_or_else(|| Refusal::new("method", name.to_owned()))?;
    let core = |error: &federpendel::Error| Refusal::core(catalogue, error);
    let motion = solution.motion();
    candidate.applies(motion.oscillator()).map_err(|error| core(&error))?;
    let setting = setting(solution, candidate, step).map_err(|error| core(&error))?;
    let found = || -> federpendel::Result<_> {
        let times = motion::even_times(solution.duration(), count)?;
        let states = candidate.states(motion, &times, &setting)?;
        let findings = Findings::of(candidate, motion, (&times, &states), &setting)?;
        let exact = motion.samples(&times)?;
        Ok((times, states, findings, exact, candidate.equation(motion)?))
    };
    let (times, states, findings, exact, equation) = found().map_err(|error| core(&error))?;
    let errors = states.iter().zip(&exact).map(|(state, sample)| state.position - sample.position);
    let errors: Vec<_> = errors.collect();
    let positions = states.iter().map(|state| state.position);
    let bound = motion.error_bound(solution.duration()).map_err(|error| core(&error))?;
    let rounding = bound + motion.phase_error(solution.duration());
    let mut sentences = catalogue.findings(candidate.order(), &findings, rounding);
    let remark = Remark::of(candidate, motion);
    sentences.extend(remark.map(|remark| catalogue.remark(remark, equation)));
    Ok(Compared { numbers: times.into_iter().chain(positions).chain(errors).collect(), sentences })
}

fn setting(solution: &Solution, candidate: Candidate, step: f64) -> federpendel::Result<Setting> {
    let setting = Setting::of(solution.motion());
    match candidate {
        Candidate::Scheme(scheme) if !scheme.adaptive => {
            let (time, time_step) = (solution.duration(), parameter::TIME_STEP.check(step)?);
            let (steps, limit) = (time / time_step, MOST_STEPS);
            if steps > limit as f64 {
                return Err(federpendel::Error::TooManySteps { time, time_step, steps, limit });
            }
            setting.with_time_step(time_step)
        }
        _ => Ok(setting),
    }
}
