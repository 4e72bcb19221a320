//! Section 2.1: Stokes friction, all three regimes.

use federpendel::article::{Complex, critical, eq_36, overdamped};
use federpendel::{Motion, Outcome, Regime, Result, State};

use super::{Check, ROUNDING};
use crate::article::measure::{deviation, formula_deviation, friction, half_period, range};
use crate::article::{Case, Laboratory};

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.stokes;
    let mut checks = vec![
        only_linear(laboratory)?,
        force(case)?,
        characteristic_equation(case)?,
        oscillates_below_critical(case)?,
    ];
    checks.extend(super::stokes_solution::checks(case)?);
    checks.push(aperiodic(case, "overdamped-solution", 2.0)?);
    checks.push(aperiodic(case, "critical-solution", 1.0)?);
    Ok(checks)
}

/// The introduction: of the three laws only this one leaves a linear equation, so that twice the release makes
/// twice the motion.
fn only_linear(laboratory: &Laboratory) -> Result<Check> {
    let mut check = Check::new("only-linear", "");
    let blank = check.clone();
    let mut departures = Vec::new();
    let laws = [
        ("Stokes: max|x(2x₀) − 2x(x₀)|/x₀", "0", &laboratory.stokes),
        ("Coulomb: max|…|/x₀", "> 0", &laboratory.coulomb),
        ("Newton: max|…|/x₀", "> 0", &laboratory.newton),
    ];
    for (name, expected, case) in laws {
        let State { position, velocity } = case.release();
        let Ok(doubled) =
            Motion::new(*case.oscillator(), State::new(2.0 * position, 2.0 * velocity)?)
        else {
            // Drag too strong to be followed.
            return Ok(blank);
        };
        if matches!(doubled.outcome(), Outcome::Rests(rest) if rest.time == 0.0) {
            // Dry friction holds it both times.
            return Ok(blank);
        }
        let until = 2.0 * half_period(case);
        let departure = deviation(&doubled, until, |time| {
            case.motion.at(time).map_or(f64::NAN, |sample| 2.0 * sample.position)
        })?;
        let share = departure / case.motion.amplitude();
        departures.push(share);
        check = check.computed(name, share, "1").expected(expected, 0.0, "1");
    }
    let linear = |departure: f64| departure <= ROUNDING;
    Ok(check.judged(linear(departures[0]) && !linear(departures[1]) && !linear(departures[2])))
}

/// The force of friction over the velocity, at every speed that is not too small to divide by.
fn force(case: &Case) -> Result<Check> {
    let states = friction(case)?;
    let fastest = states.iter().map(|(state, _)| state.velocity.abs()).fold(0.0, f64::max);
    let fast = states.iter().filter(|(state, _)| state.velocity.abs() > 0.1 * fastest);
    let (low, high) = range(fast.map(|(state, force)| -force / state.velocity));
    // Near the turning points it is a small difference of large forces.
    let scale = case.oscillator().stiffness() * case.motion.amplitude() / (0.1 * fastest);
    let damping = case.oscillator().friction().stokes.map_or(f64::NAN, |law| law.damping());
    Ok(Check::new("stokes-force", "29–30")
        .computed("min(−F_R/ẋ)", low, "kg/s")
        .computed("max(−F_R/ẋ)", high, "kg/s")
        .expected("D", damping, "kg/s")
        .equal(scale))
}

fn characteristic_equation(case: &Case) -> Result<Check> {
    let oscillator = case.oscillator();
    let omega0 = oscillator.angular_frequency();
    let damping = 2.0 * oscillator.damping_rate();
    let [first, second] = eq_36(oscillator)?;
    let left = |root: Complex| {
        let value = root * root + root * damping.into() + (omega0 * omega0).into();
        value.re.hypot(value.im)
    };
    Ok(Check::new("characteristic-roots", "31–36")
        .computed("|λ₁² + (D/m) λ₁ + ω₀²|", left(first), "1/s²")
        .computed("|λ₂² + (D/m) λ₂ + ω₀²|", left(second), "1/s²")
        .expected("0", 0.0, "1/s²")
        .equal((omega0 + damping) * (omega0 + damping)))
}

/// Turning points within twelve undamped periods, released from rest, below, at and above critical damping.
fn oscillates_below_critical(case: &Case) -> Result<Check> {
    let mut check = Check::new("oscillates-below-critical", "36–37");
    let duration = 24.0 * half_period(case);
    let mut agrees = true;
    for (ratio, symbol) in [(0.5, "n(γ = ω₀/2)"), (1.0, "n(γ = ω₀)"), (2.0, "n(γ = 2ω₀)")]
    {
        let motion = Motion::new(case.damped(ratio)?, State::new(case.motion.amplitude(), 0.0)?)?;
        let turns =
            motion.turning_points().take_while(|point| point.time <= duration).count() as f64;
        let expected =
            if ratio < 1.0 { (24.0 * (1.0 - ratio * ratio).sqrt()).floor() } else { 0.0 };
        agrees &= turns == expected;
        let formula = if ratio < 1.0 { "⌊12 T ω/π⌋" } else { "0" };
        check = check.computed(symbol, turns, "1").expected(formula, expected, "1");
    }
    Ok(check.judged(agrees))
}

/// The remarks on the cases that the article does not pursue: γ = `ratio` ω0 at or above 1.
fn aperiodic(case: &Case, id: &'static str, ratio: f64) -> Result<Check> {
    let oscillator = case.damped(ratio)?;
    let motion = Motion::new(oscillator, case.release())?;
    let formula = match oscillator.regime() {
        Regime::Critical => critical(&oscillator, case.release())?,
        _ => overdamped(&oscillator, case.release())?,
    };
    let until = motion.default_duration();
    Ok(Check::new(id, "§2.1")
        .computed("max|Δx|", formula_deviation(&motion, until, &formula)?, "m")
        .expected("0", 0.0, "m")
        .equal(motion.amplitude()))
}
