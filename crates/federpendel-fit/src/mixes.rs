//! All mixes of the laws fitted, each from what the others found.

use federpendel::Mix;

use crate::Quantity;
use crate::extremes::Look;
use crate::growing::grow;
use crate::least_squares::{Effort, Minimum, minimise, solve};
use crate::problem::{Ending, LAWS, Normal, OMEGA, Problem, Vector};
use crate::{jumps, start, stop};

/// A fitted mix.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// The laws that may act.
    pub mix: Mix,
    /// The minimum.
    pub minimum: Minimum,
    /// Minima with the rest at another turning point that fit about as well, or even better where it is not
    /// the natural one.
    pub beside: Vec<Minimum>,
}

impl Fitted {
    /// The lowest sum of squares, wherever the mass rests.
    pub fn lowest(&self) -> f64 {
        let all = self.beside.iter().chain([&self.minimum]);
        all.map(|minimum| minimum.normal.cost).fold(f64::INFINITY, f64::min)
    }
}

/// Which parameters are free in a mix.
pub fn free(mix: Mix) -> [bool; 7] {
    let mut free = [true; 7];
    LAWS.iter().zip(start::laws(mix)).for_each(|(&i, acts)| free[i] = acts);
    free
}

/// Whether `small` has no law that `large` lacks.
pub fn within(small: Mix, large: Mix) -> bool {
    start::laws(small).iter().zip(start::laws(large)).all(|(&s, l)| !s || l)
}

/// Fits every mix of the `allowed` laws, the largest first.
pub fn fit_all(problem: &mut Problem, look: Option<&Look>, allowed: Mix) -> Option<Vec<Fitted>> {
    problem.spread = (problem.quantity == Quantity::Acceleration).then(|| problem.step());
    let seen = look.and_then(|look| turns_seen(problem, look));
    let mixes = start::mixes(allowed);
    let mut fitted: Vec<Fitted> = Vec::new();
    let mut lowest = None;
    for &mix in mixes.iter().rev() {
        let from = if fitted.is_empty() {
            first(problem, look, allowed)?
        } else {
            nearest(problem, look, &fitted, mix)?
        };
        let found = refine(problem, &from, mix, seen, lowest);
        // With jumps spread, as the sums that it is held against.
        let jumping = found.as_ref().map(|found| &found.minimum);
        lowest = lowest.or(jumping.and_then(|at| problem.normal(&at.at, at.ending)));
        fitted.extend(found);
    }
    let order =
        (0..fitted.len()).rev().flat_map(|small| (0..small).map(move |large| (small, large)));
    for (small, large) in order {
        lead(problem, &mut fitted, small, large, seen);
    }
    problem.spread = None;
    Some(fitted)
}

/// A law more never fits worse: where the search of the larger mix ended too high, the smaller one shows
/// it the way.
fn lead(
    problem: &mut Problem,
    fitted: &mut [Fitted],
    small: usize,
    large: usize,
    seen: Option<u64>,
) {
    let (Fitted { mix, minimum, .. }, other) = (&fitted[small], &fitted[large]);
    let cost = other.minimum.normal.cost;
    if !within(*mix, other.mix) || minimum.normal.cost >= cost * (1.0 - 1e-9) {
        return;
    }
    let again = refine(problem, minimum, other.mix, seen, None);
    if let Some(again) = again.filter(|again| again.minimum.normal.cost < cost) {
        fitted[large] = again;
    }
}

/// The number of turning points that the extremes show, if rest follows them.
fn turns_seen(problem: &Problem, look: &Look) -> Option<u64> {
    let last = look.extremes.last()?;
    let rests = problem.times[problem.len() - 1] > last.time + 1.2 * look.half;
    rests.then_some(look.extremes.len() as u64)
}

/// The minimum of a mix near `from`. `lowest` is the lowest sum of squares so far: fits far above it are
/// not worth the search between jumps.
fn refine(
    problem: &mut Problem,
    from: &Minimum,
    mix: Mix,
    seen: Option<u64>,
    lowest: Option<Normal>,
) -> Option<Fitted> {
    let free = free(mix);
    if !mix.coulomb {
        let minimum = minimise(problem, &from.at, &free, Ending::Natural, Effort::FINE)?;
        return Some(Fitted { mix, minimum, beside: vec![] });
    }
    let (found, beside) = stop::search(problem, from, &free, seen)?;
    let hopeless = 1.0 + HOPELESS / problem.len() as f64;
    let near = lowest.is_none_or(|lowest| found.normal.cost < hopeless * lowest.cost);
    let minimum = jumps::settle(problem, found, &free, near);
    let beside = beside.into_iter().map(|found| jumps::settle(problem, found, &free, near));
    let beside = beside.collect();
    Some(Fitted { mix, minimum, beside })
}

/// A fit so many variances above the best is rejected, wherever exactly its minimum lies.
const HOPELESS: f64 = 400.0;

/// The largest mix from a cold start.
fn first(problem: &mut Problem, look: Option<&Look>, allowed: Mix) -> Option<Minimum> {
    let ending = Ending::Natural;
    let mut best: Option<Minimum> = None;
    if let Some(look) = look {
        let starts = regressed(problem, look, allowed);
        best = grow(problem, &starts, &free(allowed), ending, look.half);
    }
    if look.is_none_or(|look| look.extremes.len() < FEW) {
        let half = look.map_or(problem.times[problem.len() - 1] - problem.times[0], |l| l.half);
        let starts = start::grid(problem);
        let starts: Vec<_> = starts.iter().flat_map(|s| as_each_law(s, allowed)).collect();
        let other = grow(problem, &starts, &free(allowed), ending, half);
        let better = |a: &Minimum, b: &Minimum| a.normal.cost < b.normal.cost;
        best = match (best, other) {
            (Some(best), Some(other)) if better(&other, &best) => Some(other),
            (best, other) => best.or(other),
        };
    }
    best
}

/// Below so many extremes the grid is asked too.
const FEW: usize = 5;

/// Starts from the losses of amplitude, with all laws and with each alone.
fn regressed(problem: &Problem, look: &Look, allowed: Mix) -> Vec<Vector> {
    let omega = std::f64::consts::PI / look.half;
    let mut all: Vec<[f64; 3]> = Vec::new();
    for mix in start::mixes(allowed).into_iter().rev() {
        let laws = start::laws(mix).iter().filter(|&&acts| acts).count();
        if mix == allowed || laws == 1 {
            let found = start::coefficients(look, problem.quantity, omega, mix);
            if !all.contains(&found) {
                all.push(found);
            }
        }
    }
    all.into_iter().filter_map(|c| start::with(problem, look.half, c)).collect()
}

/// A viscous start, and what each allowed law alone would be that takes as much at first.
fn as_each_law(start: &Vector, allowed: Mix) -> Vec<Vector> {
    let rate = start[LAWS[0]];
    let omega = start[OMEGA];
    let amplitude = start[4].hypot(start[5] / omega).max(f64::MIN_POSITIVE);
    // The same loss over a swing about 0.7 times as wide as the first.
    let mean = 0.7 * amplitude;
    let pi = std::f64::consts::PI;
    let alone = [rate, 0.5 * pi * rate * omega * mean, 0.75 * pi * rate / (omega * mean)];
    let one = |i: usize| {
        let mut other = *start;
        LAWS.iter().for_each(|&law| other[law] = 0.0);
        other[LAWS[i]] = alone[i];
        other
    };
    (0..3).filter(|&i| start::laws(allowed)[i]).map(one).collect()
}

/// The best point to start `mix` from: the larger mixes with their other laws taken away, and the
/// losses.
fn nearest(
    problem: &mut Problem,
    look: Option<&Look>,
    fitted: &[Fitted],
    mix: Mix,
) -> Option<Minimum> {
    let free = free(mix);
    let mut starts: Vec<(Vector, Ending)> = Vec::new();
    for large in fitted.iter().filter(|large| within(mix, large.mix)) {
        let minimum = &large.minimum;
        let ending = if mix.coulomb { minimum.ending } else { Ending::Natural };
        starts.extend(without(minimum, &free).map(|at| (at, ending)));
        if let (Some(look), true) = (look, large.mix == fitted[0].mix) {
            let omega = minimum.at[OMEGA];
            let found = start::coefficients(look, problem.quantity, omega, mix);
            let mut at = minimum.at;
            LAWS.iter().zip(found).for_each(|(&i, c)| at[i] = c);
            starts.push((at, ending));
        }
    }
    // Each larger mix is near in its own way. What is tried is no end of a search.
    let tried = starts.into_iter().filter_map(|(at, ending)| {
        let normal = problem.normal(&at, ending)?;
        let reason = crate::least_squares::StopReason::StepLimit;
        Some(Minimum { at, normal, ending, reason })
    });
    tried.min_by(|a, b| a.normal.cost.total_cmp(&b.normal.cost))
}

/// `minimum` with the laws that are not `free` taken away and the rest moved as the quadratic model
/// of the sum of squares says.
fn without(minimum: &Minimum, free: &[bool; 7]) -> Option<Vector> {
    let mut gone = Vector::zeros();
    LAWS.iter().filter(|&&i| !free[i]).for_each(|&i| gone[i] = -minimum.at[i]);
    let moved =
        solve(&minimum.normal.information, &-(minimum.normal.information * gone), free, 0.0)?;
    let mut at = minimum.at + gone + moved;
    LAWS.iter().for_each(|&i| at[i] = at[i].max(0.0));
    let sane = (0.7..1.4).contains(&(at[OMEGA] / minimum.at[OMEGA]));
    if !sane {
        at = minimum.at + gone;
    }
    Some(at)
}
