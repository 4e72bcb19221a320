//! Section 4: Newton friction, and what the decay of the amplitude tells of the law.

use federpendel::first_integral::{next_amplitude, speed};
use federpendel::{Motion, Result, State};

use super::quotients::{order_of_scheme, residual_check, start_check};
use super::{Check, ROUNDING};
use crate::article::measure::{friction, range, residual, scheme, turning_points};
use crate::article::{Case, Laboratory};

/// A loss that is less than this share of the amplitude is too faint to be told from another.
const FAINT: f64 = 1e-6;

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.newton;
    let from_rest =
        Case::on(Motion::new(*case.oscillator(), State::new(case.motion.amplitude(), 0.0)?)?);
    Ok(vec![
        force(case)?,
        recursion(case)?,
        start(case)?,
        order_of_scheme(case, "scheme-order-newton", "48–49, 85", "p(85)"),
        only_numeric(&from_rest)?,
        series(&from_rest)?,
        neither(&from_rest),
    ])
}

/// The force of friction over v², at every speed that is not too small to divide by.
fn force(case: &Case) -> Result<Check> {
    let check = Check::new("drag-force", "81–83");
    let Some(law) = case.oscillator().friction().newton else { return Ok(check) };
    let states = friction(case)?;
    let fastest = states.iter().map(|(state, _)| state.velocity.abs()).fold(0.0, f64::max);
    let fast = states.iter().filter(|(state, _)| state.velocity.abs() > 0.1 * fastest);
    let (low, high) =
        range(fast.map(|(state, force)| -force / (state.velocity * state.velocity.abs())));
    if fastest == 0.0 {
        return Ok(check);
    }
    // Near the turning points it is a small difference of large forces.
    let scale =
        case.oscillator().stiffness() * case.motion.amplitude() / (0.01 * fastest * fastest);
    Ok(check
        .computed("min|F_R|/ẋ²", low, "kg/m")
        .computed("max|F_R|/ẋ²", high, "kg/m")
        .expected("½ρ c_w A", law.coefficient(), "kg/m")
        .equal(scale.min(1e3 * law.coefficient())))
}

/// Whether the positions of (85) satisfy (84).
fn recursion(case: &Case) -> Result<Check> {
    let (oscillator, scheme) = (case.oscillator(), scheme(case)?);
    let (h, kappa) = (scheme.time_step(), oscillator.newton_rate());
    let left = residual(case, &scheme, |before, now, after| {
        let quotient = (now - before) / h;
        [
            (after - 2.0 * now + before) / (h * h),
            oscillator.stiffness() / oscillator.mass() * now,
            kappa * quotient * quotient.abs(),
        ]
    });
    Ok(residual_check(Check::new("recursion-newton", "84–85"), left, case, h))
}

/// Whether the first step (86) satisfies (83) with (52).
fn start(case: &Case) -> Result<Check> {
    let oscillator = case.oscillator();
    start_check(Check::new("start-newton", "86"), case, |State { position, velocity }| {
        [
            oscillator.stiffness() / oscillator.mass() * position,
            oscillator.newton_rate() * velocity * velocity.abs(),
        ]
    })
}

/// “Only numerically”: turning points and speed in closed form, against the motion. If they agree, the claim fails.
fn only_numeric(case: &Case) -> Result<Check> {
    let check = Check::new("only-numeric", "83");
    let Some(points) = turning_points(&case.motion, 2) else { return Ok(check) };
    let (kappa, x0) = (case.oscillator().newton_rate(), case.release().position);
    let first = next_amplitude(kappa, x0)?;
    let second = next_amplitude(kappa, first)?;
    // Half-way in time through the first swing; from x0 > 0 it goes towards the centre.
    let sample = case.motion.at(0.5 * points[0].time)?;
    let omega0 = case.oscillator().angular_frequency();
    let fast = speed(kappa, x0, sample.position)?.unwrap_or(f64::NAN) * omega0;
    let check = check
        .computed("|x₁|, Lambert W", first, "m")
        .computed("|x₁|, (83)", points[0].position.abs(), "m")
        .computed("|x₂|, Lambert W", second, "m")
        .computed("|x₂|, (83)", points[1].position.abs(), "m")
        .computed("|ẋ(t₁/2)|, first integral", fast, "m/s")
        .computed("|ẋ(t₁/2)|, (83)", sample.velocity.abs(), "m/s")
        .expected("≠", f64::NAN, "1");
    let pair = |place: usize, scale: f64| {
        let [known, followed] = [0, 1].map(|side| check.computed[2 * place + side].value);
        (known - followed).abs() <= ROUNDING * scale
    };
    let closed_form = pair(0, x0) && pair(1, x0) && pair(2, x0 * omega0);
    Ok(check.judged(!closed_form))
}

/// “Possibly by a series”: the motion is one, and its turning points are those of the first integral.
fn series(case: &Case) -> Result<Check> {
    let check = Check::new("series-possible", "83");
    let (kappa, x0) = (case.oscillator().newton_rate(), case.release().position);
    let mut amplitude = x0;
    let mut away: f64 = 0.0;
    for point in case.motion.turning_points().take(20) {
        amplitude = next_amplitude(kappa, amplitude)?;
        away = away.max((point.position.abs() - amplitude).abs());
    }
    Ok(check.computed("max|Δ|x_n||, n ≤ 20", away, "m").expected("0", 0.0, "m").equal(x0))
}

/// Neither equal losses nor equal ratios from swing to swing.
fn neither(case: &Case) -> Check {
    let check = Check::new("neither-decay", "§4");
    let Some(points) = turning_points(&case.motion, 2) else { return check };
    let [a, b, c] = [case.release().position, points[0].position.abs(), points[1].position.abs()];
    let (losses, ratios) = ([a - b, b - c], [b / a, c / b]);
    if losses[0] <= FAINT * a {
        return check;
    }
    let differ = |pair: [f64; 2], scale: f64| (pair[0] - pair[1]).abs() > ROUNDING * scale;
    check
        .computed("|x₀| − |x₁|", losses[0], "m")
        .computed("|x₁| − |x₂|", losses[1], "m")
        .computed("|x₁|/|x₀|", ratios[0], "1")
        .computed("|x₂|/|x₁|", ratios[1], "1")
        .expected("≠", f64::NAN, "1")
        .judged(differ(losses, a) && differ(ratios, 1.0))
}
