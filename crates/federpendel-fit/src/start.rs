//! Where the search begins: start values from the extremes, or from a grid where there are few.

use std::f64::consts::PI;

use federpendel::Mix;
use nalgebra::{Matrix3, Vector3};

use crate::Quantity;
use crate::extremes::Look;
use crate::problem::{LAWS, Problem, Vector};
use crate::swings::Swing;

/// How fast the recorded quantity grows with the amplitude, in powers of ω0.
pub fn per_length(quantity: Quantity, omega: f64) -> f64 {
    match quantity {
        Quantity::Position => 1.0,
        Quantity::Velocity => omega,
        Quantity::Acceleration => omega * omega,
    }
}

/// The laws of a mix in the order of [`LAWS`].
pub fn laws(mix: Mix) -> [bool; 3] {
    [mix.stokes, mix.coulomb, mix.newton]
}

/// The mix of these laws.
pub fn mix(laws: [bool; 3]) -> Mix {
    Mix { stokes: laws[0], coulomb: laws[1], newton: laws[2] }
}

/// All mixes of no laws but those of `allowed`, the fewest first.
pub fn mixes(allowed: Mix) -> Vec<Mix> {
    let allowed = laws(allowed);
    let mut all: Vec<[bool; 3]> =
        (0..8u8).map(|bits| [0, 1, 2].map(|i| bits >> i & 1 == 1)).collect();
    all.retain(|some| (0..3).all(|i| !some[i] || allowed[i]));
    all.sort_by_key(|some| some.iter().filter(|&&acts| acts).count());
    all.into_iter().map(mix).collect()
}

/// The amplitude that a swing loses by friction of γ = 1, a_c = 1 and κ = 1, each averaged over the swing: together a
/// swing of amplitude A loses 2f + (πγ/ω0) A + (4/3) κ A².
fn losses(omega: f64, amplitude: f64) -> Vector3<f64> {
    Vector3::new(PI / omega * amplitude, 2.0 / (omega * omega), 4.0 / 3.0 * amplitude * amplitude)
}

/// γ, a_c and κ from the loss of amplitude per swing, without any below zero.
pub fn coefficients(look: &Look, quantity: Quantity, omega: f64, allowed: Mix) -> [f64; 3] {
    let swings = look.swings(quantity, omega);
    let mut best = (f64::INFINITY, [0.0; 3]);
    for subset in mixes(allowed) {
        let chosen = laws(subset);
        let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for &Swing { amplitude, loss } in &swings {
            let row = losses(omega, amplitude);
            let row = Vector3::from_fn(|i, _| if chosen[i] { row[i] } else { 0.0 });
            matrix += row * row.transpose();
            right += row * loss;
        }
        for i in 0..3 {
            matrix[(i, i)] = if chosen[i] { matrix[(i, i)] * (1.0 + 1e-12) } else { 1.0 };
        }
        let Some(found) = matrix.cholesky().map(|factor| factor.solve(&right)) else { continue };
        let error: f64 =
            swings.iter().map(|s| (s.loss - losses(omega, s.amplitude).dot(&found)).powi(2)).sum();
        if error < best.0 && found.iter().all(|&c| c >= 0.0) {
            best = (error, [found[0], found[1], found[2]]);
        }
    }
    best.1
}

/// The rate at which an amplitude `amplitude` decays under these coefficients, 1/s.
pub fn effective_rate(p: &Vector, amplitude: f64) -> f64 {
    let omega = p[0];
    let loss = losses(omega, amplitude).dot(&Vector3::new(p[1], p[2], p[3]));
    if amplitude > 0.0 { loss * omega / (PI * amplitude) } else { 0.0 }
}

/// State and zero from a linear fit of a damped oscillation over the first `span` seconds; with the
/// sum of squares that it leaves there.
pub fn state(problem: &Problem, omega: f64, rate: f64, span: f64) -> Option<(Vector, f64)> {
    let begin = problem.times[0];
    let rows = |time: f64| {
        let (c, s) = damped(omega, rate, time - begin);
        // The value and the slope of the recorded quantity at the first time, and the zero.
        Vector3::new(c + rate * s, s, 1.0)
    };
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    let count = problem.times.partition_point(|&t| t <= begin + span).max(6).min(problem.len());
    for (&time, &value) in problem.times.iter().zip(&problem.values).take(count) {
        let row = rows(time);
        matrix += row * row.transpose();
        right += row * value;
    }
    let unit = matrix.diagonal().map(|d| d.sqrt().max(f64::MIN_POSITIVE));
    let scaled = Matrix3::from_fn(|i, j| {
        matrix[(i, j)] / (unit[i] * unit[j]) + if i == j { 1e-12 } else { 0.0 }
    });
    let solved = scaled.cholesky()?.solve(&right.component_div(&unit)).component_div(&unit);
    let pairs = problem.times.iter().zip(&problem.values).take(count);
    let cost = pairs.map(|(&t, &value)| (value - rows(t).dot(&solved)).powi(2)).sum();
    let (value, slope) = (solved[0], solved[1]);
    // q, q' of one derivative from those of the next: x″ = −ω0² x − 2γ x'.
    let before =
        |(value, slope): (f64, f64)| (-(slope + 2.0 * rate * value) / (omega * omega), value);
    let (x, v) = match problem.quantity {
        Quantity::Position => (value, slope),
        Quantity::Velocity => before((value, slope)),
        Quantity::Acceleration => before(before((value, slope))),
    };
    Some((Vector::from([omega, 0.0, 0.0, 0.0, x, v, solved[2]]), cost))
}

/// e^(−γt) cos √Δ t and e^(−γt) sin(√Δ t)/√Δ, Δ = ω0² − γ², through all regimes.
fn damped(omega: f64, rate: f64, t: f64) -> (f64, f64) {
    let delta = omega * omega - rate * rate;
    let root = delta.abs().sqrt();
    if root * t < 1e-4 {
        let decay = (-rate * t).exp();
        (decay, decay * t)
    } else if delta > 0.0 {
        let decay = (-rate * t).exp();
        (decay * (root * t).cos(), decay * (root * t).sin() / root)
    } else {
        let (slow, fast) = ((-(rate - root) * t).exp(), (-(rate + root) * t).exp());
        (0.5 * (slow + fast), 0.5 * (slow - fast) / root)
    }
}

/// The start with given coefficients of friction; the period is that of the extremes.
pub fn with(problem: &Problem, half: f64, coefficients: [f64; 3]) -> Option<Vector> {
    let damped = PI / half;
    let omega = damped.hypot(coefficients[0]);
    let mut first = Vector::from([omega, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    LAWS.iter().zip(coefficients).for_each(|(&i, c)| first[i] = c);
    let mut start = state(problem, omega, coefficients[0], 3.0 * half)?.0;
    // Once more with the decay that the amplitude found goes with.
    let amplitude = start[4].hypot(start[5] / omega);
    let rate = effective_rate(&first, amplitude).min(omega);
    start = state(problem, omega, rate, 3.0 * half)?.0;
    LAWS.iter().zip(coefficients).for_each(|(&i, c)| start[i] = c);
    Some(start)
}

/// Starts for strongly damped motions, which turn too seldom to tell a period: the best of a grid
/// of linear oscillators over frequency and damping, the rest of each in closed form.
pub fn grid(problem: &Problem) -> Vec<Vector> {
    const RATIOS: [f64; 9] = [0.02, 0.06, 0.12, 0.25, 0.45, 0.7, 1.0, 1.6, 3.0];
    let stride = problem.len().div_ceil(200);
    let part = problem.part(problem.len(), stride);
    let span = part.times[part.len() - 1] - part.times[0];
    let mut best: Vec<(f64, Vector)> = RATIOS
        .iter()
        .filter_map(|ratio| {
            let each = (0..48).filter_map(|i| {
                let omega = 0.8 * 1.09f64.powi(i) / span;
                let (mut start, cost) = state(&part, omega, ratio * omega, span)?;
                start[LAWS[0]] = ratio * omega;
                Some((cost, start))
            });
            each.min_by(|a, b| a.0.total_cmp(&b.0))
        })
        .collect();
    best.sort_by(|a, b| a.0.total_cmp(&b.0));
    best.truncate(3);
    best.into_iter().map(|(_, start)| start).collect()
}
