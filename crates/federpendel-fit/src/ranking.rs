//! Which laws act: likelihood ratios, information criteria and the verdict.

use federpendel::Mix;

use crate::covariance::NORMAL;
use crate::mixes::within;
use crate::problem::{LAWS, NAMES};
use crate::report::{FitReport, Parameter};
use crate::start::{laws, mix};
use crate::tails::tails;

/// A mix with its sum of squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// The laws.
    pub mix: Mix,
    /// The sum of squares of its fit.
    pub cost: f64,
    /// The lowest sum of squares, wherever the mass comes to rest.
    pub lowest: f64,
    /// Its laws without those that came out as none: it says nothing that this mix does not.
    pub core: Mix,
}

/// All fitted mixes, and as how many independent values theirs tell.
#[derive(Debug, Clone, PartialEq)]
pub struct Ranking {
    /// The mixes.
    pub candidates: Vec<Candidate>,
    /// The effective number of the values that were fitted.
    pub effective: f64,
}

/// How good a fit is for its number of parameters; lower is better.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Criteria {
    /// Akaike's.
    pub aic: f64,
    /// Akaike's, corrected for few values.
    pub aicc: f64,
    /// Bayes' (Schwarz).
    pub bic: f64,
}

/// The criteria of a fit with `fitted` parameters to values that tell as much as `effective`
/// independent ones; the variance counts as a parameter too.
pub fn criteria(mean_square: f64, fitted: usize, effective: f64) -> Criteria {
    let k = (fitted + 1) as f64;
    let fit = effective * mean_square.ln();
    let aic = fit + 2.0 * k;
    let few = (effective - k - 1.0).max(1.0);
    Criteria { aic, aicc: aic + 2.0 * k * (k + 1.0) / few, bic: fit + k * effective.ln() }
}

/// How a law stands after all fits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Standing {
    /// Every mix without it is rejected.
    Acts,
    /// Some of the simplest mixes that are left have it, others do not.
    Open,
    /// None of the simplest mixes that are left has it.
    NotNeeded,
    /// It was not allowed.
    Excluded,
}

/// The laws that the recording shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The simplest mix that is not rejected, of equally simple ones that which fits best; or the one that
    /// was asked for.
    pub mix: Mix,
    /// Other mixes that are not rejected and of which no part is: the recording does not tell them
    /// from the first.
    pub alternatives: Vec<Mix>,
    /// How Stokes, Coulomb and Newton friction stand, in this order.
    pub laws: [Standing; 3],
    /// The probability of a likelihood ratio as high as that for the law beside all others, if it
    /// did not act; none where it was not allowed.
    pub p_values: [Option<f64>; 3],
}

/// A law is taken where it would seem to act less often than this by chance.
pub const LEVEL: f64 = 0.01;

/// The verdict from the fits of all allowed mixes.
pub fn verdict(ranking: &Ranking) -> Option<Verdict> {
    let Ranking { candidates, effective } = ranking;
    let effective = *effective;
    let left: Vec<&Candidate> = candidates
        .iter()
        .filter(|c| c.core == c.mix && !rejected(c, candidates, effective))
        .collect();
    let simplest =
        |c: &&Candidate| !left.iter().any(|other| other.mix != c.mix && within(other.mix, c.mix));
    let mut minimal: Vec<&Candidate> = left.iter().copied().filter(simplest).collect();
    minimal.sort_by(|a, b| size(a.mix).cmp(&size(b.mix)).then(a.cost.total_cmp(&b.cost)));
    let best = minimal.first()?;
    let largest = candidates.iter().max_by_key(|c| size(c.mix))?;
    let stands = |i: usize| {
        let has = |c: &&&Candidate| laws(c.mix)[i];
        if !laws(largest.mix)[i] {
            Standing::Excluded
        } else if left.iter().all(|c| laws(c.mix)[i]) {
            Standing::Acts
        } else if minimal.iter().any(|c| has(&c)) {
            Standing::Open
        } else {
            Standing::NotNeeded
        }
    };
    let p = |i: usize| {
        let mut others = laws(largest.mix);
        others[i] = false;
        let small = candidates.iter().find(|c| c.mix == mix(others))?;
        laws(largest.mix)[i].then(|| p_value(small, largest, effective))
    };
    Some(Verdict {
        mix: best.mix,
        alternatives: minimal[1..].iter().map(|c| c.mix).collect(),
        laws: [0, 1, 2].map(stands),
        p_values: [0, 1, 2].map(p),
    })
}

fn rejected(small: &Candidate, candidates: &[Candidate], effective: f64) -> bool {
    rejection(small, candidates, effective).is_some_and(|p| p < LEVEL)
}

/// The least probability of a likelihood ratio as high as that of a larger mix, if `small` were
/// right; none where there is no larger one.
pub fn rejection(small: &Candidate, candidates: &[Candidate], effective: f64) -> Option<f64> {
    let larger = candidates.iter().filter(|c| c.mix != small.mix && within(small.mix, c.mix));
    larger.map(|large| p_value(small, large, effective)).reduce(f64::min)
}

impl FitReport {
    /// With this probability a larger mix fits better by as much as the best of them does, if `mix`
    /// were right; below [`LEVEL`] it is rejected. None for the largest mix, and for one that was
    /// not fitted.
    pub fn rejection(&self, mix: Mix) -> Option<f64> {
        self.ranking.rejection(mix)
    }

    /// Whether a mix was asked for that is rejected.
    pub fn asked_rejected(&self) -> bool {
        self.asked_rejection.is_some_and(|p| p < LEVEL)
    }
}

impl Ranking {
    /// The same, from what the verdict follows from.
    pub(crate) fn rejection(&self, mix: Mix) -> Option<f64> {
        let small = self.candidates.iter().find(|candidate| candidate.mix == mix)?;
        rejection(small, &self.candidates, self.effective)
    }
}

impl Verdict {
    /// Leaves open whether those laws act whose own coefficient in the verdict's mix, as `fitted`, may be
    /// zero, whatever the likelihood ratios say: these see the best fits only, not how far they reach.
    pub fn doubt(&mut self, fitted: &[Parameter]) {
        for (i, law) in LAWS.into_iter().enumerate() {
            let Some(parameter) = fitted.iter().find(|one| one.name == NAMES[law]) else {
                continue;
            };
            let errors = parameter.value.zip(parameter.stderr).map(|(value, error)| value / error);
            // Of what one swing before a rest bounds from below only there is no value.
            let above = parameter.value.is_none() || errors.is_some_and(|errors| errors > NORMAL);
            let sure = above && parameter.interval95.0.is_some_and(|low| low > 0.0);
            if sure || self.laws[i] != Standing::Acts {
                continue;
            }
            let mut others = laws(self.mix);
            others[i] = false;
            self.laws[i] = Standing::Open;
            self.alternatives.push(mix(others));
        }
    }
}

fn size(mix: Mix) -> usize {
    laws(mix).iter().filter(|&&acts| acts).count()
}

/// The probability of a likelihood ratio as high, if the smaller mix is right. Where dry friction acts in
/// both, the mass may rest wherever each fits best.
///
/// Coefficients cannot fall below zero, so each law more adds a χ² only every other time: ½χ²₀ +
/// ½χ²₁ for one (Chernoff 1954), binomial weights for more (Self & Liang 1987, for independent
/// coefficients).
fn p_value(small: &Candidate, large: &Candidate, effective: f64) -> f64 {
    let cost = |one: &Candidate| if small.mix.coulomb { one.lowest } else { one.cost };
    let (above, below) = (cost(small), cost(large));
    let ratio = if within(large.core, small.mix) {
        // What it has more came out as none.
        0.0
    } else if below > 0.0 {
        (effective * (above / below).ln()).max(0.0)
    } else if above > 0.0 {
        f64::INFINITY
    } else {
        0.0
    };
    let [one, two, three] = tails(ratio);
    match size(large.mix) - size(small.mix) {
        1 => one / 2.0,
        2 => one / 2.0 + two / 4.0,
        _ => (3.0 * one + 3.0 * two + three) / 8.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mix_with_an_idle_law_is_no_alternative() {
        // Quadratic friction beside Stokes is there; dry friction came out as none.
        let (stokes, newton) = ([true, false, false], [true, false, true]);
        let candidate = |laws, core, cost| {
            let (mix, core) = (mix(laws), mix(core));
            Candidate { mix, core, cost, lowest: cost }
        };
        let candidates = vec![
            candidate([true; 3], newton, 1.0),
            candidate([true, true, false], stokes, 1.2),
            candidate(newton, newton, 1.0),
            candidate(stokes, stokes, 1.2),
        ];
        let ranking = Ranking { candidates, effective: 1000.0 };
        let verdict = verdict(&ranking).expect("there are candidates");
        assert_eq!((verdict.mix, verdict.alternatives), (mix(newton), vec![]));
        assert_eq!(verdict.laws, [Standing::Acts, Standing::NotNeeded, Standing::Acts]);
    }

    #[test]
    fn a_law_whose_own_interval_holds_none_is_open() {
        let acts = || Verdict {
            mix: mix([true, false, true]),
            alternatives: vec![],
            laws: [Standing::Acts, Standing::NotNeeded, Standing::Acts],
            p_values: [None; 3],
        };
        let parameter = |name, value, stderr, low| Parameter {
            name,
            value: Some(value),
            stderr,
            interval95: (low, None),
            at_bound: false,
        };
        // As the interval says, as the standard error does, and where there is none.
        let doubts =
            [(Some(0.2), Some(0.0)), (Some(0.3), Some(0.1)), (None, Some(0.1)), (Some(0.1), None)];
        for (stderr, low) in doubts.into_iter().chain([(Some(0.1), Some(0.2))]) {
            let stokes = parameter("damping_rate", 1.0, Some(0.01), Some(0.98));
            let newton = parameter("newton_rate", 0.41, stderr, low);
            let mut verdict = acts();
            verdict.doubt(&[stokes, newton]);
            if low == Some(0.2) {
                assert_eq!(verdict, acts());
            } else {
                assert_eq!(verdict.laws, [Standing::Acts, Standing::NotNeeded, Standing::Open]);
                assert_eq!(verdict.alternatives, [mix([true, false, false])]);
            }
        }
    }

    #[test]
    fn nested_mixes_are_compared_wherever_the_mass_rests() {
        let candidate =
            |laws, cost, lowest| Candidate { mix: mix(laws), core: mix(laws), cost, lowest };
        let (all, dry, stokes) = ([true; 3], [true, true, false], [true, false, false]);
        // Shown with the natural rest, though another fits better.
        let candidates = vec![
            candidate(all, 1.0, 1.0),
            candidate(dry, 1.02, 1.001),
            candidate([false, true, true], 1.5, 1.5),
            candidate([true, false, true], 1.5, 1.5),
            candidate(stokes, 1.5, 1.5),
        ];
        let verdict = verdict(&Ranking { candidates, effective: 1000.0 }).expect("a verdict");
        assert_eq!((verdict.mix, verdict.alternatives), (mix(dry), vec![]));
        assert_eq!(verdict.laws[2], Standing::NotNeeded);
    }
}
