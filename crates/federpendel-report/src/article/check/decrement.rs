//! The closing remark on how amplitudes fall, made a measurement: loss per swing against amplitude, in which the
//! laws are intercept, slope and curvature.

use federpendel::{Motion, Result, State};

use super::Check;
use crate::article::measure::turning_points;
use crate::article::{Case, Laboratory};

/// How near the averaged law for small friction must come to a motion whose friction is not that small.
const AVERAGED: f64 = 0.1;

/// The averaged law is for swings that lose at most this part of their amplitude, and three of them tell a loss of at
/// least that part from rounding.
const SMALL: f64 = 0.2;
const FAINT: f64 = 1e-6;

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let check = Check::new("decrement-plot", "§4");
    let cases = [&laboratory.coulomb, &laboratory.stokes, &laboratory.newton];
    if cases.iter().any(|case| !(FAINT..=SMALL).contains(&loss_of_first_swing(case))) {
        return Ok(vec![check]);
    }
    let mut parabolas = Vec::new();
    for case in cases {
        match parabola(case)? {
            Some(parabola) => parabolas.push(parabola),
            None => return Ok(vec![check]),
        }
    }
    let [coulomb, stokes, newton] = cases.map(|case| case.oscillator());
    let check = check
        .computed("Coulomb: 2f", parabolas[0][0], "m")
        .computed("Stokes: πγ/ω₀", parabolas[1][1], "1")
        .computed("Newton: 4κ/3", parabolas[2][2], "1/m")
        .expected("2f", 2.0 * coulomb.offset(), "m")
        .expected("πγ/ω₀", std::f64::consts::PI * stokes.damping_ratio(), "1")
        .expected("4κ/3", 4.0 / 3.0 * newton.newton_rate(), "1/m");
    let agrees = (0..3).all(|index| {
        let expected = check.expected[index].value;
        (check.computed[index].value - expected).abs() <= AVERAGED * expected
    });
    Ok(vec![check.judged(agrees)])
}

/// Intercept (m), slope and curvature (1/m) of the parabola through the losses of the first three swings from rest,
/// over the mean amplitude of each.
fn parabola(case: &Case) -> Result<Option<[f64; 3]>> {
    let from = case.motion.amplitude();
    let motion = Motion::new(*case.oscillator(), State::new(from, 0.0)?)?;
    let Some(points) = turning_points(&motion, 3) else { return Ok(None) };
    let places = [from, -points[0].position, points[1].position, -points[2].position];
    let swings: Vec<_> =
        places.windows(2).map(|pair| (0.5 * (pair[0] + pair[1]), pair[0] - pair[1])).collect();
    let slope = |i: usize, j: usize| (swings[j].1 - swings[i].1) / (swings[j].0 - swings[i].0);
    // Newton's form of the parabola through three points.
    let curvature = (slope(1, 2) - slope(0, 1)) / (swings[2].0 - swings[0].0);
    let linear = slope(0, 1) - curvature * (swings[0].0 + swings[1].0);
    let intercept = swings[0].1 - linear * swings[0].0 - curvature * swings[0].0 * swings[0].0;
    Ok(Some([intercept, linear, curvature]))
}

/// What the averaged law says that the first swing loses of its amplitude.
fn loss_of_first_swing(case: &Case) -> f64 {
    let (oscillator, amplitude) = (case.oscillator(), case.motion.amplitude());
    2.0 * oscillator.offset() / amplitude
        + std::f64::consts::PI * oscillator.damping_ratio()
        + 4.0 / 3.0 * oscillator.newton_rate() * amplitude
}
