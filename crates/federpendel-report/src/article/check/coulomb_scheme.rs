//! Section 3.1: the equation with dry friction, and what the scheme makes of it.

use federpendel::scheme::article::Scheme;
use federpendel::{Motion, NormalForce, Outcome, Result, State, lens};

use super::quotients::{order_of_scheme, residual_check};
use super::{Check, ROUNDING};
use crate::article::measure::{
    article_scheme, friction, later, range, residual, scheme, turning_points,
};
use crate::article::{Case, Laboratory};

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.coulomb;
    Ok(vec![
        force(case)?,
        normal_force(case)?,
        opposes(&laboratory.thrown[0])?,
        no_static_friction(case)?,
        recursion(case)?,
        start(case)?,
        linear_decay(case),
        never_rests(case)?,
        order_of_scheme(case, "scheme-order-coulomb", "48–49, 59", "p(59)"),
    ])
}

/// The offset f and half the width of the sticking band, m.
fn offsets(case: &Case) -> (f64, f64) {
    (case.oscillator().offset(), case.oscillator().sticking_offset())
}

/// μ F_N/m, m/s²: dry friction over the mass.
fn friction_over_mass(case: &Case) -> f64 {
    let oscillator = case.oscillator();
    oscillator.offset() * oscillator.stiffness() / oscillator.mass()
}

/// The force of friction that the acceleration tells of, at every speed.
fn force(case: &Case) -> Result<Check> {
    let check = Check::new("friction-force", "55–57");
    let forces = friction(case)?;
    if forces.is_empty() {
        return Ok(check);
    }
    let (low, high) = range(forces.iter().map(|(_, force)| force.abs()));
    let law = friction_over_mass(case) * case.oscillator().mass();
    let scale = case.oscillator().stiffness() * case.motion.amplitude();
    Ok(check
        .computed("min|F_R|", low, "N")
        .computed("max|F_R|", high, "N")
        .expected("μ F_N", law, "N")
        .equal(scale))
}

/// The chain of (55): what presses the mass is its weight, as the force tells that its acceleration betrays. Where
/// something else presses, or nothing moves, it says nothing.
fn normal_force(case: &Case) -> Result<Check> {
    let check = Check::new("normal-force", "55");
    let oscillator = case.oscillator();
    let forces = friction(case)?;
    let law = oscillator.friction().coulomb;
    let gravity = law.and_then(|law| match law.normal_force() {
        NormalForce::Weight(gravity) => Some(law.kinetic() * oscillator.mass() * gravity),
        NormalForce::Given(_) => None,
    });
    let (Some(weight), Some((_, force))) = (gravity, forces.first()) else { return Ok(check) };
    Ok(check
        .computed("|F_R|", force.abs(), "N")
        .expected("μ m g", weight, "N")
        .equal(oscillator.stiffness() * case.motion.amplitude() + weight))
}

/// The power F_R v is negative wherever the mass moves.
fn opposes(case: &Case) -> Result<Check> {
    let check = Check::new("opposes-motion", "57");
    let powers = friction(case)?;
    if powers.is_empty() {
        return Ok(check);
    }
    let (_, most) = range(powers.iter().map(|(state, force)| force * state.velocity));
    Ok(check.computed("max F_R ẋ", most, "W").expected("< 0", 0.0, "W").judged(most < 0.0))
}

/// sign(0) = 0: a mass released at rest inside its sticking band.
fn no_static_friction(case: &Case) -> Result<Check> {
    let (_, band) = offsets(case);
    let release = State::new(0.8 * band * case.release().position.signum(), 0.0)?;
    let motion = Motion::new(*case.oscillator(), release)?;
    let (until, time_step) = (later(case), case.setting().time_step());
    let scheme = Scheme::new(case.oscillator(), release, time_step)?;
    let check = Check::new("static-friction", "57, 59").reading();
    let Ok(found) = scheme.walk().sample(until) else { return Ok(check) };
    Ok(check
        .computed_at(until, "x, (59)", found.position)
        .expected("x₀", motion.at(until)?.position, "m")
        .equal(band))
}

/// Whether the positions of (59) satisfy (58).
fn recursion(case: &Case) -> Result<Check> {
    let (oscillator, scheme) = (case.oscillator(), scheme(case)?);
    let (h, dry) = (scheme.time_step(), friction_over_mass(case));
    let left = residual(case, &scheme, |before, now, after| {
        let sign = if now == before { 0.0 } else { (now - before).signum() };
        [
            (after - 2.0 * now + before) / (h * h),
            oscillator.stiffness() / oscillator.mass() * now,
            sign * dry,
        ]
    });
    Ok(residual_check(Check::new("recursion-coulomb", "58–59"), left, case, h))
}

/// (60) from rest: sign(0) = 0 lets the first step go without friction.
fn start(case: &Case) -> Result<Check> {
    let check = Check::new("start-coulomb", "60");
    let scheme = scheme(case)?;
    let from = case.release().position;
    let exact = case.motion.at(scheme.time_step())?.position - from;
    if exact == 0.0 {
        return Ok(check);
    }
    let found = scheme.run(1)?[1] - from;
    // The step itself is of third order: its own error is far below what friction does.
    let check = check.computed("x₁ − x₀, (60)", found, "m").expected("x(Δt) − x₀", exact, "m");
    let agrees = check.agrees(exact, 0.1 * offsets(case).0 / from.abs());
    Ok(check.judged(agrees))
}

/// Every swing loses the same.
fn linear_decay(case: &Case) -> Check {
    let check = Check::new("linear-decay", "§3.1");
    let Some(points) = turning_points(&case.motion, 3) else { return check };
    let start = case.release().position;
    // With alternating signs, since the last place may lie on either side.
    let [x1, x2, x3] = [points[0], points[1], points[2]].map(|point| point.position);
    let places = [start, -x1, x2, -x3];
    let loss = |n: usize| (places[n] - places[n + 1]) * start.signum();
    check
        .computed("|x₀| − |x₁|", loss(0), "m")
        .computed("|x₁| − |x₂|", loss(1), "m")
        .computed("|x₂| − |x₃|", loss(2), "m")
        .expected("2f", 2.0 * offsets(case).0, "m")
        .equal(start)
}

/// The scheme after the rest: how far it has crept, and how fast.
fn never_rests(case: &Case) -> Result<Check> {
    let check = Check::new("scheme-rests", "59").reading();
    let Outcome::Rests(rest) = case.motion.outcome() else { return Ok(check) };
    let until = later(case);
    let ending = lens::ending(&case.motion, article_scheme(), &case.setting());
    let (Ok(Some(ending)), Ok(found)) = (ending, scheme(case)?.walk().sample(until)) else {
        return Ok(check);
    };
    let check =
        check.computed_at(until, "x, (59)", found.position).expected("x_N", rest.position, "m");
    let agrees = check.agrees(case.motion.amplitude(), ROUNDING) && ending.sticks;
    Ok(check.judged(agrees))
}
