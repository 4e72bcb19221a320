//! Section 2.1: Stokes friction, all three regimes.

use std::f64::consts::PI;

use federpendel::article::{Complex, critical, eq_36, eq_41, eq_46, overdamped};
use federpendel::{Friction, Motion, Oscillator, Outcome, Regime, Result, State, Stokes};

use super::measure::{
    deviation, formula_deviation, friction, half_period, largest, position, radian, range,
    turning_points,
};
use super::{Check, ROUNDING};
use crate::article::{Case, Laboratory};

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.stokes;
    let mut checks = vec![
        only_linear(laboratory)?,
        force(case)?,
        characteristic_equation(case)?,
        oscillates_below_critical(case)?,
    ];
    checks.extend(underdamped(case)?);
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

/// A mass with the same spring and another Stokes friction, γ = `ratio` ω0.
fn damped(case: &Case, ratio: f64) -> Result<Oscillator> {
    let (mass, stiffness) = (case.oscillator().mass(), case.oscillator().stiffness());
    let critical = 2.0 * (mass * stiffness).sqrt();
    Oscillator::new(mass, stiffness, Friction::from(Stokes::new(ratio * critical)?))
}

/// Turning points within twelve undamped periods, released from rest, below, at and above critical damping.
fn oscillates_below_critical(case: &Case) -> Result<Check> {
    let mut check = Check::new("oscillates-below-critical", "36–37");
    let duration = 24.0 * half_period(case);
    let mut agrees = true;
    for (ratio, symbol) in [(0.5, "n(γ = ω₀/2)"), (1.0, "n(γ = ω₀)"), (2.0, "n(γ = 2ω₀)")]
    {
        let motion = Motion::new(damped(case, ratio)?, State::new(case.motion.amplitude(), 0.0)?)?;
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

/// The solution below critical damping; at and above it nothing of this applies.
fn underdamped(case: &Case) -> Result<Vec<Check>> {
    let names = [
        ("conjugate-roots", "37"),
        ("complex-form", "38–40"),
        ("damped-constants", "42–45"),
        ("derivative", "43"),
        ("damped-solution", "40–41, 46–47"),
        ("frequency-lowered", "37"),
        ("exponential-decay", "46"),
    ];
    let blank = names.map(|(id, equation)| Check::new(id, equation));
    let oscillator = case.oscillator();
    if oscillator.regime() != Regime::Underdamped {
        return Ok(blank.to_vec());
    }
    let [roots, complex, constants, derivative, solution, lowered, exponential] = blank;
    let State { position: x0, velocity: v0 } = case.release();
    let amplitude = case.motion.amplitude();
    let (omega0, rates) = (oscillator.angular_frequency(), eq_41(oscillator)?);
    let (gamma, omega) = (rates.damping_rate, rates.angular_frequency);
    let formula = eq_46(oscillator, case.release())?;

    // C̃1 and its conjugate, by (45).
    let first = Complex::new(0.5 * x0, -0.5 * (v0 + gamma * x0) / omega);
    let second = Complex::new(first.re, -first.im);
    let eq_38 = |t: f64| {
        first * Complex::new(-gamma * t, omega * t).exp()
            + second * Complex::new(-gamma * t, -omega * t).exp()
    };
    let eq_39 = |t: f64| {
        let turn = |sign: f64| Complex::new(0.0, sign * omega * t).exp();
        (first * turn(1.0) + second * turn(-1.0)) * (-gamma * t).exp().into()
    };
    let off =
        |value: &dyn Fn(f64) -> f64| largest(case.duration, |t| value(t) - position(&formula, t));
    let complex = complex
        .computed("max|Re (38) − (40)|", off(&|t| eq_38(t).re), "m")
        .computed("max|Re (39) − (40)|", off(&|t| eq_39(t).re), "m")
        .computed("max|Im (38)|", largest(case.duration, |t| eq_38(t).im), "m")
        .expected("0", 0.0, "m")
        .equal(amplitude * omega0 / omega);

    let [root, _] = eq_36(oscillator)?;
    let roots = roots
        .computed("Re λ₁", root.re, "1/s")
        .computed("Im λ₁", root.im, "1/s")
        .expected("−D/(2m)", -gamma, "1/s")
        .expected("√(ω₀² − D²/(4m²))", (omega0 * omega0 - gamma * gamma).sqrt(), "1/s")
        .equal(omega0);

    let start = formula.at(0.0)?;
    let constants = constants
        .computed("x(0)", start.position, "m")
        .computed("ẋ(0)", start.velocity, "m/s")
        .expected("x₀", x0, "m")
        .expected("v₀", v0, "m/s")
        .equal(amplitude.min(amplitude * omega0));

    // (43) against a difference quotient of (46), at a time at which neither is near zero.
    let (time, h) = (radian(case), 1e-5 * radian(case));
    let quotient = (position(&formula, time + h) - position(&formula, time - h)) / (2.0 * h);
    let derivative = derivative
        .computed("(43)", formula.at(time)?.velocity, "m/s")
        .expected("Δx/Δt", quotient, "m/s");
    let agrees = derivative.agrees(amplitude * omega0, 1e-7);
    let derivative = derivative.judged(agrees);

    let solution = solution
        .computed("max|Δx|", formula_deviation(&case.motion, case.duration, &formula)?, "m")
        .expected("0", 0.0, "m")
        .equal(amplitude);

    let (lowered, exponential) = match turning_points(&case.motion, 4) {
        None => (lowered, exponential),
        Some(points) => {
            let measured = PI / (points[1].time - points[0].time);
            let lowered = lowered
                .computed("π/(t₂ − t₁)", measured, "1/s")
                .expected("√(ω₀² − D²/(4m²))", omega, "1/s")
                .expected("< ω₀", omega0, "1/s");
            let agrees = lowered.agrees(omega, ROUNDING) && measured < omega0;
            let ratio = |n: usize| (points[n].position / points[n - 1].position).abs();
            // Next to critical damping a swing takes everything.
            let visible = points.iter().all(|point| point.position.abs() > f64::MIN_POSITIVE);
            let exponential = exponential
                .computed("|x₂|/|x₁|", ratio(1), "1")
                .computed("|x₃|/|x₂|", ratio(2), "1")
                .computed("|x₄|/|x₃|", ratio(3), "1")
                .expected("e^(−γπ/ω)", (-gamma * PI / omega).exp(), "1")
                .equal(1.0);
            let exponential =
                if visible { exponential } else { Check::new("exponential-decay", "46") };
            (lowered.judged(agrees), exponential)
        }
    };
    Ok(vec![roots, complex, constants, derivative, solution, lowered, exponential])
}

/// The remarks on the cases that the article does not pursue: γ = `ratio` ω0 at or above 1.
fn aperiodic(case: &Case, id: &'static str, ratio: f64) -> Result<Check> {
    let oscillator = damped(case, ratio)?;
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
