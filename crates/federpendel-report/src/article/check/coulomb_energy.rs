//! Section 3.2.1, equations (62) to (68): the energy argument and the rate of decay, side by side.

use std::f64::consts::PI;

use federpendel::article::{eq_67, eq_68};
use federpendel::{Coulomb, Friction, NormalForce, Oscillator, Result, State};

use super::Check;
use crate::article::measure::{half_period, turning_points};
use crate::article::{Case, Laboratory};

pub fn checks(laboratory: &Laboratory) -> Result<Vec<Check>> {
    let case = &laboratory.coulomb;
    let mut checks = Vec::new();
    checks.extend(first_swing(case)?);
    checks.push(period(case));
    checks.extend(sides_of_68(case)?);
    checks.push(dimension(case)?);
    Ok(checks)
}

/// The claims about the way from x0 to the next turning point x1, which counts on the other side.
fn first_swing(case: &Case) -> Result<Vec<Check>> {
    let names = [
        ("work-energy", "62–64"),
        ("energy-chain", "65–66"),
        ("loss", "67"),
        ("half-period", "§3.2.1"),
    ];
    let blank = names.map(|(id, equation)| Check::new(id, equation));
    let Some(points) = turning_points(&case.motion, 1) else { return Ok(blank.to_vec()) };
    let [work, chain, loss, half] = blank;
    let oscillator = case.oscillator();
    let (x0, turn) = (case.release().position.abs(), points[0]);
    let x1 = -turn.position * case.release().position.signum();
    let force = oscillator.offset() * oscillator.stiffness();
    let potential = |position: f64| oscillator.potential_energy(State { position, velocity: 0.0 });
    let heat = case.motion.ledger(&[turn.time])?[0].heat.coulomb;
    let energy = potential(x0);

    let work = work
        .computed("∫F_R dx", heat, "J")
        .computed("F_R x₀ + F_R x₁", force * x0 + force * x1, "J")
        .computed("½C x₀² − ½C x₁²", 0.5 * oscillator.stiffness() * (x0 * x0 - x1 * x1), "J")
        .expected("E(x₀) − E(x₁)", potential(x0) - potential(x1), "J")
        .equal(energy);
    let chain = chain
        .computed("F_R (x₀ + x₁)", force * (x0 + x1), "J")
        .computed("½C (x₀² − x₁²)", 0.5 * oscillator.stiffness() * (x0 * x0 - x1 * x1), "J")
        .computed(
            "½C (x₀ + x₁)(x₀ − x₁)",
            0.5 * oscillator.stiffness() * (x0 + x1) * (x0 - x1),
            "J",
        )
        .expected("∫F_R dx", heat, "J")
        .equal(energy);
    let loss = loss
        .computed("2μF_N/C", eq_67(oscillator)?, "m")
        .expected("|x₀| − |x₁|", x0 - x1, "m")
        .equal(x0);
    let half = half
        .computed("T/2 = π√(m/C)", half_period(case), "s")
        .expected("t₁", turn.time, "s")
        .equal(turn.time);
    Ok(vec![work, chain, loss, half])
}

/// ω0 = 2π/T = √(C/m), T = 2π√(m/C), with the period that the turning points have.
fn period(case: &Case) -> Check {
    let check = Check::new("period-chain", "§3.2.1");
    let Some(points) = turning_points(&case.motion, 2) else { return check };
    let oscillator = case.oscillator();
    let measured = 2.0 * (points[1].time - points[0].time);
    let formula = 2.0 * PI * (oscillator.mass() / oscillator.stiffness()).sqrt();
    check
        .computed("2π/√(C/m)", 2.0 * PI / (oscillator.stiffness() / oscillator.mass()).sqrt(), "s")
        .computed("2π√(m/C)", formula, "s")
        .expected("T = 2(t₂ − t₁)", measured, "s")
        .equal(measured)
}

/// (68) has three sides. The first is held to the motion, the others to the first.
fn sides_of_68(case: &Case) -> Result<Vec<Check>> {
    let sides = eq_68(case.oscillator())?;
    let left = Check::new("decay-left", "68").computed("Δx/(T/2)", sides.left, "m/s");
    let left = match turning_points(&case.motion, 1) {
        None => Check::new("decay-left", "68"),
        Some(points) => {
            let lost = case.release().position.abs()
                + points[0].position * case.release().position.signum();
            left.expected("(|x₀| − |x₁|)/t₁", lost / points[0].time, "m/s").equal(sides.left)
        }
    };
    let middle = Check::new("decay-middle", "68")
        .computed("(2μF_N/C)/(2π√(m/C))", sides.middle, "m/s")
        .expected("Δx/(T/2)", sides.left, "m/s")
        .equal(sides.left);
    let right = Check::new("decay-right", "68")
        .computed("(2μF_N/π)√(C/m)", sides.right, "N/s")
        .expected("Δx/(T/2)", sides.left, "m/s")
        .equal_by_chance(sides.left);
    Ok(vec![left, middle, right])
}

/// Grams in place of kilograms: a velocity in metres per second stays what it is.
fn dimension(case: &Case) -> Result<Check> {
    let grams = in_grams(case.oscillator())?;
    let (kilograms, grams) = (eq_68(case.oscillator())?, eq_68(&grams)?);
    Ok(Check::new("decay-dimension", "68")
        .computed("Δx/(T/2), kg → g", grams.left / kilograms.left, "1")
        .computed("(2μF_N/π)√(C/m), kg → g", grams.right / kilograms.right, "1")
        .expected("1", 1.0, "1")
        .equal(1.0))
}

/// The same oscillator with its numbers in grams: mass, stiffness and normal force are a thousand times as large.
fn in_grams(oscillator: &Oscillator) -> Result<Oscillator> {
    let mut friction = Friction::NONE;
    if let Some(law) = oscillator.friction().coulomb {
        let force = match law.normal_force() {
            NormalForce::Given(force) => NormalForce::Given(1e3 * force),
            weight => weight,
        };
        friction.coulomb = Some(Coulomb::new(law.kinetic(), law.static_coefficient(), force)?);
    }
    Oscillator::new(1e3 * oscillator.mass(), 1e3 * oscillator.stiffness(), friction)
}
