//! Every problem of `reference/`, whose answers another program found by other methods.

use std::fmt::Write;
use std::path::Path;

use federpendel::{
    Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, Outcome, State, Stokes,
};
use serde::Deserialize;

#[derive(Deserialize)]
struct Collection {
    mix: String,
    problems: Vec<Problem>,
}

#[derive(Deserialize)]
struct Problem {
    name: String,
    corner: String,
    oscillator: Given,
    release: Release,
    samples: Vec<Sample>,
    turning_points: Vec<Turning>,
    rest: Option<Rest>,
    limit: Option<String>,
}

#[derive(Deserialize)]
struct Given {
    mass: String,
    stiffness: String,
    gravity: Option<String>,
    normal_force: Option<String>,
    damping: Option<String>,
    kinetic: Option<String>,
    #[serde(rename = "static")]
    static_: Option<String>,
    newton_coefficient: Option<String>,
}

#[derive(Deserialize)]
struct Release {
    position: String,
    velocity: String,
}

#[derive(Deserialize)]
struct Sample {
    time: String,
    position: String,
    velocity: String,
    heat_stokes: Option<String>,
    heat_coulomb: Option<String>,
    heat_newton: Option<String>,
}

#[derive(Deserialize)]
struct Turning {
    index: usize,
    time: String,
    position: String,
}

#[derive(Deserialize)]
struct Rest {
    time: String,
    position: String,
    swings: u64,
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

fn optional(text: &Option<String>) -> f64 {
    text.as_deref().map_or(0.0, number)
}

impl Problem {
    fn motion(&self) -> Motion {
        let given = &self.oscillator;
        let normal_force = match (&given.gravity, &given.normal_force) {
            (Some(gravity), _) => NormalForce::Weight(number(gravity)),
            (None, force) => NormalForce::Given(optional(force)),
        };
        let kinetic = optional(&given.kinetic);
        let static_ = given.static_.as_deref().map_or(kinetic, number);
        let friction = Friction {
            stokes: given.damping.as_deref().map(|text| Stokes::new(number(text)).unwrap()),
            coulomb: (static_ > 0.0).then(|| Coulomb::new(kinetic, static_, normal_force).unwrap()),
            newton: given
                .newton_coefficient
                .as_deref()
                .map(|text| Newton::new(number(text)).unwrap()),
        };
        let oscillator =
            Oscillator::new(number(&given.mass), number(&given.stiffness), friction).unwrap();
        let release = State::new(number(&self.release.position), number(&self.release.velocity));
        Motion::new(oscillator, release.unwrap()).unwrap()
    }
}

/// What was measured on one problem, all relative to the amplitude (times relative to 1/ω0, less two
/// ulp; heats to the initial energy).
#[derive(Default)]
struct Errors {
    position: f64,
    velocity: f64,
    /// Position error over the bound that the motion states.
    over_bound: f64,
    turning_time: f64,
    turning_position: f64,
    heat: f64,
    buffers: f64,
}

fn measure(problem: &Problem, motion: &Motion) -> Errors {
    let mut errors = Errors::default();
    let amplitude = motion.amplitude().max(f64::MIN_POSITIVE);
    let omega = motion.oscillator().angular_frequency();
    let times: Vec<f64> = problem.samples.iter().map(|sample| number(&sample.time)).collect();
    let ledger = motion.ledger(&times).unwrap();
    let (mut x, mut v) = (vec![0.0; times.len()], vec![0.0; times.len()]);
    motion.sample(&times, &mut x, &mut v).unwrap();
    for (i, sample) in problem.samples.iter().enumerate() {
        let state = motion.at(times[i]).unwrap();
        let dx = (state.position - number(&sample.position)).abs() / amplitude;
        let dv = (state.velocity - number(&sample.velocity)).abs() / (omega * amplitude);
        errors.position = errors.position.max(dx);
        errors.velocity = errors.velocity.max(dv);
        let bound = motion.error_bound(times[i]).unwrap() / amplitude;
        errors.over_bound = errors.over_bound.max(dx.max(dv) / bound);
        errors.buffers = errors.buffers.max((x[i] - state.position).abs() / amplitude);
        errors.buffers = errors.buffers.max((v[i] - state.velocity).abs() / (omega * amplitude));
        let energy = motion.initial_energy().max(f64::MIN_POSITIVE);
        let heat = ledger[i].heat;
        for (ours, theirs) in [
            (heat.stokes, &sample.heat_stokes),
            (heat.coulomb, &sample.heat_coulomb),
            (heat.newton, &sample.heat_newton),
        ] {
            errors.heat = errors.heat.max((ours - optional(theirs)).abs() / energy);
        }
    }
    let last = problem.turning_points.last().map_or(0, |point| point.index.min(300_000));
    let points: Vec<_> = motion.turning_points().take(last).collect();
    for expected in problem.turning_points.iter().filter(|point| point.index <= last) {
        let found = points[expected.index - 1];
        let time = number(&expected.time);
        let off = ((found.time - time).abs() - 2.0 * f64::EPSILON * time).max(0.0) * omega;
        errors.turning_time = errors.turning_time.max(off);
        let off = (found.position - number(&expected.position)).abs() / amplitude;
        errors.turning_position = errors.turning_position.max(off);
    }
    errors
}

/// Says what is wrong with the end of the motion, if anything.
fn wrong_end(mix: &str, problem: &Problem, motion: &Motion) -> Option<String> {
    let amplitude = motion.amplitude();
    let omega = motion.oscillator().angular_frequency();
    match (&problem.rest, &problem.limit, motion.outcome()) {
        (Some(rest), None, Outcome::Rests(found)) => {
            let time = number(&rest.time);
            let allowed = turning_time(mix, &problem.corner);
            let close = (found.time - time).abs() <= 2.0 * f64::EPSILON * time + allowed / omega
                && (found.position - number(&rest.position)).abs() <= 1e-13 * amplitude
                && found.swings == rest.swings;
            // Next to critical damping the swing from rest ends at −f + f·1e-30: on the edge, too.
            let edge = matches!(problem.corner.as_str(), "tie" | "near-critical");
            let tie = edge || !found.tie || found.swings == 0;
            (!close || !tie).then(|| format!("{found:?}"))
        }
        (None, Some(limit), Outcome::Creeps { limit: found }) => {
            ((found - number(limit)).abs() > 1e-15 * amplitude).then(|| format!("limit {found}"))
        }
        (None, None, Outcome::Swings | Outcome::Decays | Outcome::Unknown { .. }) => None,
        (_, _, outcome) => Some(format!("{outcome:?}")),
    }
}

/// (positions and velocities, heats): what this kind of problem is held to.
fn allowed(mix: &str, corner: &str) -> (f64, f64) {
    match (mix.contains("newton"), corner) {
        (false, _) => (1.8e-15, 1e-13),
        (true, "million-periods") => (1e-10, 1e-10),
        (true, _) => (1e-13, 1e-13),
    }
}

/// Error of a turning time beyond two ulp, in units of 1/ω0. Just below critical damping a swing from rest
/// ends only after the motion has died away by thirty orders; an error of the drag's part then
/// moves the end by 1/(1 − ζ²) ≈ 500 times as much.
fn turning_time(mix: &str, corner: &str) -> f64 {
    match (mix.contains("newton"), corner) {
        (true, "near-critical") => 1e-12,
        (true, "million-periods") => 1e-10,
        _ => 1e-13,
    }
}

#[test]
fn every_reference_problem_is_met() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reference");
    let mut table = String::new();
    let (mut count, mut failures) = (0, 0);
    for name in [
        "undamped",
        "stokes",
        "coulomb",
        "newton",
        "stokes-coulomb",
        "stokes-newton",
        "coulomb-newton",
        "stokes-coulomb-newton",
    ] {
        let text = std::fs::read_to_string(folder.join(name).with_extension("json")).unwrap();
        let collection: Collection = serde_json::from_str(&text).unwrap();
        assert_eq!(collection.mix, name);
        for problem in &collection.problems {
            let motion = problem.motion();
            let errors = measure(problem, &motion);
            let (state, heat) = allowed(name, &problem.corner);
            let end = wrong_end(name, problem, &motion);
            let bad = errors.position > state
                || errors.velocity > state
                || errors.turning_position > state
                || errors.turning_time > turning_time(name, &problem.corner)
                || errors.heat > heat
                || errors.over_bound > 1.0
                || errors.buffers > 2e-15
                || end.is_some();
            count += 1;
            failures += usize::from(bad);
            writeln!(
                table,
                "{} {:22} {:20} {:28} x {:.1e} v {:.1e} bound {:.2} turn t {:.1e} x {:.1e} heat {:.1e} buffers {:.1e} {}",
                if bad { "BAD" } else { "   " },
                name,
                problem.corner,
                problem.name,
                errors.position,
                errors.velocity,
                errors.over_bound,
                errors.turning_time,
                errors.turning_position,
                errors.heat,
                errors.buffers,
                end.unwrap_or_default(),
            )
            .unwrap();
        }
    }
    println!("{table}");
    assert!(count >= 200, "only {count} problems");
    assert_eq!(failures, 0, "problems missed, see the table");
}
