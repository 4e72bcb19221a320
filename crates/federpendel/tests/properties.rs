//! Properties that every motion has, whatever its mix, strengths and release.
//!
//! The cases are random but the same in every run; `PROPTEST_CASES=10000` tries more of them.

use federpendel::{
    Coulomb, Friction, Mode, Motion, Newton, NormalForce, Oscillator, Outcome, State, Stokes, Ties,
    TurningPoint, even_times,
};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// An experiment in numbers that scale: forces instead of coefficients where there is a choice.
#[derive(Debug, Clone, Copy)]
struct Experiment {
    mass: f64,
    stiffness: f64,
    damping: f64,
    kinetic: f64,
    static_: f64,
    force: f64,
    newton: f64,
    position: f64,
    velocity: f64,
}

impl Experiment {
    fn oscillator(&self) -> Oscillator {
        let force = NormalForce::Given(self.force);
        let friction = Friction {
            stokes: Some(Stokes::new(self.damping).unwrap()),
            coulomb: Some(Coulomb::new(self.kinetic, self.static_, force).unwrap()),
            newton: Some(Newton::new(self.newton).unwrap()),
        };
        Oscillator::new(self.mass, self.stiffness, friction).unwrap()
    }

    fn release(&self) -> State {
        State::new(self.position, self.velocity).unwrap()
    }

    fn motion(&self) -> Motion {
        Motion::new(self.oscillator(), self.release()).unwrap()
    }
}

/// Ten to a power between two.
fn scale(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|exponent| 10f64.powf(exponent))
}

/// Zero half of the time.
fn often_none(strength: impl Strategy<Value = f64>) -> impl Strategy<Value = f64> {
    (any::<bool>(), strength).prop_map(|(acts, strength)| if acts { strength } else { 0.0 })
}

/// A damping ratio next to the critical one, on either side.
fn nearly_critical() -> impl Strategy<Value = f64> {
    (any::<bool>(), scale(-17.0, -2.0))
        .prop_map(|(above, gap)| if above { 1.0 + gap } else { 1.0 - gap })
}

/// All mixes; damping ratio up to 10, offset up to the amplitude, κ times the amplitude up to 30; sometimes
/// a static coefficient without a kinetic one.
fn experiments() -> impl Strategy<Value = Experiment> {
    let shape = (scale(-2.0, 2.0), scale(-1.0, 3.0), scale(-3.0, 1.0));
    let strengths = (
        prop_oneof![4 => often_none(scale(-4.0, 1.0)), 1 => nearly_critical()],
        often_none(scale(-3.0, 0.0)),
        often_none(scale(-4.0, 1.5)),
        prop_oneof![Just(1.0), 1.0..2.0],
        prop::bool::weighted(0.9),
    );
    let release = prop_oneof![
        Just((1.0, 0.0)),
        Just((-1.0, 0.0)),
        Just((0.0, 1.0)),
        (-1.0..1.0, -1.0..1.0f64),
    ];
    (shape, strengths, release).prop_map(|(shape, strengths, (position, velocity))| {
        let (mass, stiffness, amplitude) = shape;
        let (zeta, offset, drag, excess, slides) = strengths;
        let omega0 = f64::sqrt(stiffness / mass);
        let holding = if offset > 0.0 { 0.3 * excess } else { 0.0 };
        let kinetic = if offset > 0.0 && slides { 0.3 } else { 0.0 };
        Experiment {
            mass,
            stiffness,
            damping: 2.0 * zeta * f64::sqrt(stiffness * mass),
            kinetic,
            static_: holding,
            force: offset * amplitude * stiffness / 0.3,
            newton: drag / amplitude * mass,
            position: position * amplitude,
            velocity: velocity * amplitude * omega0,
        }
    })
}

/// Times up to 30 periods, as parts of that span.
fn parts() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.0..1.0f64, 20)
}

fn span(motion: &Motion) -> f64 {
    30.0 * std::f64::consts::TAU / motion.oscillator().angular_frequency()
}

/// Asserts that two states agree to `tolerance` of the amplitude (of ω0 times it for velocities).
fn close(
    motion: &Motion,
    found: State,
    expected: State,
    tolerance: f64,
) -> Result<(), TestCaseError> {
    let amplitude = motion.amplitude();
    let omega0 = motion.oscillator().angular_frequency();
    let gap = (found.position - expected.position).abs() / amplitude;
    prop_assert!(gap <= tolerance, "{gap:e}: {found:?} is not {expected:?}");
    let gap = (found.velocity - expected.velocity).abs() / (amplitude * omega0);
    prop_assert!(gap <= tolerance, "velocity, {gap:e}: {found:?} is not {expected:?}");
    Ok(())
}

fn config() -> ProptestConfig {
    ProptestConfig { rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_mirrored_release_moves_in_mirror_image(experiment in experiments(), parts in parts()) {
        let motion = experiment.motion();
        let (position, velocity) = (-experiment.position, -experiment.velocity);
        let mirrored = Experiment { position, velocity, ..experiment }.motion();
        for part in parts {
            let time = part * span(&motion);
            let (here, there) = (motion.at(time).unwrap(), mirrored.at(time).unwrap());
            prop_assert_eq!(here.position, -there.position);
            prop_assert_eq!(here.velocity, -there.velocity);
            prop_assert_eq!(here.acceleration, -there.acceleration);
            prop_assert_eq!(here.mode as i8, -(there.mode as i8));
        }
        let here = motion.turning_points().map(|p| (p.time, p.position)).take(60);
        let there = mirrored.turning_points().map(|p| (p.time, -p.position)).take(60);
        prop_assert!(here.eq(there));
    }

    /// By a power of two, so that scaling rounds nothing.
    #[test]
    fn units_do_not_matter(
        experiment in experiments(),
        parts in parts(),
        mass in -20..20i32,
        length in -20..20i32,
        rate in -20..20i32,
    ) {
        let [mass, length, rate] = [mass, length, rate].map(|power| 2f64.powi(power));
        let scaled = Experiment {
            mass: experiment.mass * mass,
            stiffness: experiment.stiffness * mass * rate * rate,
            damping: experiment.damping * mass * rate,
            force: experiment.force * mass * length * rate * rate,
            newton: experiment.newton * mass / length,
            position: experiment.position * length,
            velocity: experiment.velocity * length * rate,
            ..experiment
        }.motion();
        let motion = experiment.motion();
        for part in parts {
            let time = part * span(&motion);
            let sample = scaled.at(time / rate).unwrap();
            let (position, velocity) = (sample.position / length, sample.velocity / length / rate);
            close(&motion, State { position, velocity }, motion.at(time).unwrap().state(), 2e-15)?;
        }
    }

    #[test]
    fn energy_turns_into_heat_and_nothing_else(experiment in experiments(), mut parts in parts()) {
        let motion = experiment.motion();
        parts.sort_by(f64::total_cmp);
        let times: Vec<f64> = parts.iter().map(|part| part * span(&motion)).collect();
        let mut before = federpendel::Heat::default();
        for entry in motion.ledger(&times).unwrap() {
            let sum = entry.kinetic + entry.potential + entry.heat.total();
            let gap = (sum / motion.initial_energy() - 1.0).abs();
            prop_assert!(gap <= 1e-13, "{gap:e} at {}", entry.time);
            let heat = entry.heat;
            prop_assert!(heat.stokes >= before.stokes, "Stokes heat falls at {}", entry.time);
            prop_assert!(heat.coulomb >= before.coulomb, "Coulomb heat falls at {}", entry.time);
            prop_assert!(heat.newton >= before.newton, "Newton heat falls at {}", entry.time);
            before = heat;
        }
    }

    #[test]
    fn amplitudes_fall(experiment in experiments()) {
        let motion = experiment.motion();
        // Static friction alone takes nothing.
        let Experiment { damping, kinetic, newton, .. } = experiment;
        let dissipates = damping > 0.0 || kinetic > 0.0 || newton > 0.0;
        // Near critical damping they soon fall below the smallest number.
        let seen = |point: &TurningPoint| point.position.abs() > f64::MIN_POSITIVE;
        let points: Vec<_> = motion.turning_points().take_while(seen).take(100).collect();
        for pair in points.windows(2) {
            let (before, after) = (pair[0].position.abs(), pair[1].position.abs());
            let rounding = 1e-15 * motion.amplitude();
            prop_assert!(pair[0].time < pair[1].time);
            if !dissipates {
                prop_assert!((before - after).abs() <= rounding, "{before} becomes {after}");
            } else {
                prop_assert!(after < before, "{before} becomes {after}");
            }
        }
    }

    #[test]
    fn the_velocity_changes_sign_at_turning_points_only(experiment in experiments()) {
        let motion = experiment.motion();
        let omega0 = motion.oscillator().angular_frequency();
        let mut from = 0.0;
        let mut mode = motion.at(0.0).unwrap().mode;
        let mut points = motion.turning_points();
        for _ in 0..60 {
            if mode == Mode::Stuck {
                break;
            }
            let next = points.next();
            let until = next.map_or(from + 10.0 / omega0, |point| point.time);
            for step in 1..8 {
                let sample = motion.at(from + (until - from) * f64::from(step) / 8.0).unwrap();
                prop_assert_eq!(sample.mode, mode, "between {} and {}", from, until);
                prop_assert!(sample.velocity * f64::from(mode as i8) >= 0.0, "{:?}", sample);
            }
            let Some(point) = next else { break };
            let sample = motion.at(point.time).unwrap();
            // The time of a turning point is told to half an ulp and a little.
            let rounding = 4.0 * f64::EPSILON * (1.0 + omega0 * point.time);
            let turning = State { position: point.position, velocity: 0.0 };
            close(&motion, sample.state(), turning, rounding)?;
            prop_assert_ne!(sample.mode, mode);
            (from, mode) = (until, sample.mode);
        }
    }

    #[test]
    fn records_agree_with_single_states(experiment in experiments(), mut parts in parts()) {
        let motion = experiment.motion();
        parts.sort_by(f64::total_cmp);
        let even = even_times(0.1 * span(&motion), 501).unwrap();
        let scattered: Vec<f64> = parts.iter().map(|part| part * span(&motion)).collect();
        let (mut x, mut v) = (vec![0.0; even.len()], vec![0.0; even.len()]);
        motion.sample_even(0.1 * span(&motion), &mut x, &mut v).unwrap();
        let record = |times: &[f64], x: &[f64], v: &[f64]| {
            for ((time, position), velocity) in times.iter().zip(x).zip(v) {
                let state = State { position: *position, velocity: *velocity };
                close(&motion, state, motion.at(*time).unwrap().state(), 4e-15)?;
            }
            Ok::<(), TestCaseError>(())
        };
        record(&even, &x, &v)?;
        for times in [even, scattered] {
            let (mut x, mut v) = (vec![0.0; times.len()], vec![0.0; times.len()]);
            motion.sample(&times, &mut x, &mut v).unwrap();
            record(&times, &x, &v)?;
        }
    }

    /// The state is all that the future depends on. Restarting rounds it, once.
    #[test]
    fn a_motion_goes_on_from_any_of_its_states(
        experiment in experiments(),
        start in 0.0..0.5f64,
        parts in parts(),
    ) {
        let motion = experiment.motion();
        if let Outcome::Rests(rest) = motion.outcome() {
            prop_assume!(rest.margin.abs() > 1e-9);
        }
        let start = start * span(&motion);
        let State { position, velocity } = motion.at(start).unwrap().state();
        let restarted = Experiment { position, velocity, ..experiment }.motion();
        for part in parts {
            let time = 0.5 * part * span(&motion);
            let state = restarted.at(time).unwrap().state();
            close(&motion, state, motion.at(start + time).unwrap().state(), 1e-13)?;
        }
    }

    #[test]
    fn rest_is_the_last_turning_point(experiment in experiments()) {
        let motion = experiment.motion();
        let Outcome::Rests(rest) = motion.outcome() else { return Ok(()) };
        let last = motion.turning_points().last();
        prop_assert_eq!(motion.turning_points().count() as u64, rest.swings);
        let (time, position) = last.map_or((0.0, experiment.position), |p| (p.time, p.position));
        prop_assert_eq!((time, position), (rest.time, rest.position));
        for later in [rest.time, 2.0 * rest.time + 1.0] {
            let sample = motion.at(later).unwrap();
            prop_assert_eq!((sample.position, sample.velocity), (rest.position, 0.0));
            prop_assert_eq!((sample.acceleration, sample.mode), (0.0, Mode::Stuck));
        }
        prop_assert!(rest.position.abs() <= motion.oscillator().sticking_offset() || rest.tie);
    }

    #[test]
    fn only_a_tie_is_read_in_two_ways(experiment in experiments()) {
        let motion = experiment.motion();
        let strict =
            Motion::with_ties(experiment.oscillator(), experiment.release(), Ties::Strict).unwrap();
        match (motion.outcome(), strict.outcome()) {
            (Outcome::Rests(rest), Outcome::Rests(strict)) if rest.tie => {
                prop_assert!(strict.swings >= rest.swings);
            }
            (outcome, strict) => prop_assert_eq!(outcome, strict),
        }
    }
}
