//! Which laws act: likelihood ratios, information criteria and the verdict.

use federpendel::Mix;

use crate::mixes::within;
use crate::report::FitReport;
use crate::start::{laws, mix};

/// A mix with its sum of squares.
#[derive(Debug, Clone, Copy)]
pub struct Candidate {
    /// The laws.
    pub mix: Mix,
    /// The sum of squares of its fit.
    pub cost: f64,
    /// Its laws without those that came out as none: it says nothing that this mix does not.
    pub core: Mix,
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
pub fn verdict(candidates: &[Candidate], effective: f64) -> Option<Verdict> {
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
fn rejection(small: &Candidate, candidates: &[Candidate], effective: f64) -> Option<f64> {
    let larger = candidates.iter().filter(|c| c.mix != small.mix && within(small.mix, c.mix));
    larger.map(|large| p_value(small, large, effective)).reduce(f64::min)
}

impl FitReport {
    /// With this probability a larger mix fits better by as much as the best of them does, if `mix`
    /// were right; below [`LEVEL`] it is rejected. None for the largest mix, and for one that was
    /// not fitted.
    pub fn rejection(&self, mix: Mix) -> Option<f64> {
        let candidate = |model: &crate::Model| Candidate {
            mix: model.mix,
            cost: model.chi_square,
            core: crate::start::mix(
                ["damping_rate", "coulomb_acceleration", "newton_rate"]
                    .map(|law| model.value(law) > 0.0),
            ),
        };
        let candidates: Vec<_> = self.models.iter().map(candidate).collect();
        let small = candidates.iter().find(|candidate| candidate.mix == mix)?;
        rejection(small, &candidates, self.effective_samples)
    }
}

fn size(mix: Mix) -> usize {
    laws(mix).iter().filter(|&&acts| acts).count()
}

/// The probability of a likelihood ratio as high, if the smaller mix is right.
///
/// Coefficients cannot fall below zero, so each law more adds a χ² only every other time: ½χ²₀ +
/// ½χ²₁ for one (Chernoff 1954), binomial weights for more (Self & Liang 1987, for independent
/// coefficients).
fn p_value(small: &Candidate, large: &Candidate, effective: f64) -> f64 {
    let ratio = if within(large.core, small.mix) {
        // What it has more came out as none.
        0.0
    } else if large.cost > 0.0 {
        (effective * (small.cost / large.cost).ln()).max(0.0)
    } else if small.cost > 0.0 {
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

/// The probability that χ² with one, two or three degrees of freedom exceeds `x`.
fn tails(x: f64) -> [f64; 3] {
    if x == f64::INFINITY {
        return [0.0; 3];
    }
    let one = erfc((x / 2.0).sqrt());
    let two = (-x / 2.0).exp();
    [one, two, one + (2.0 * x / std::f64::consts::PI).sqrt() * two]
}

/// The complementary error function for x ≥ 0, to 1.2e-7 of itself (Press et al., Numerical
/// Recipes, 6.2).
fn erfc(x: f64) -> f64 {
    const C: [f64; 10] = [
        -1.26551223,
        1.00002368,
        0.37409196,
        0.09678418,
        -0.18628806,
        0.27886807,
        -1.13520398,
        1.48851587,
        -0.82215223,
        0.17087277,
    ];
    let t = 1.0 / (1.0 + 0.5 * x);
    t * (-x * x + C.iter().rev().fold(0.0, |sum, c| sum * t + c)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mix_with_an_idle_law_is_no_alternative() {
        // Quadratic friction beside Stokes is there; dry friction came out as none.
        let (stokes, newton) = ([true, false, false], [true, false, true]);
        let candidate = |laws, core, cost| Candidate { mix: mix(laws), core: mix(core), cost };
        let candidates = [
            candidate([true; 3], newton, 1.0),
            candidate([true, true, false], stokes, 1.2),
            candidate(newton, newton, 1.0),
            candidate(stokes, stokes, 1.2),
        ];
        let verdict = verdict(&candidates, 1000.0).expect("there are candidates");
        assert_eq!((verdict.mix, verdict.alternatives), (mix(newton), vec![]));
        assert_eq!(verdict.laws, [Standing::Acts, Standing::NotNeeded, Standing::Acts]);
    }

    #[test]
    fn tails_are_those_of_tables() {
        // Abramowitz & Stegun, table 26.8: 5 % and 1 % points.
        for (x, i, p) in
            [(3.84146, 0, 0.05), (6.63490, 0, 0.01), (9.21034, 1, 0.01), (11.3449, 2, 0.01)]
        {
            assert!((tails(x)[i] / p - 1.0).abs() < 1e-4, "{x} {:?}", tails(x));
        }
    }
}
