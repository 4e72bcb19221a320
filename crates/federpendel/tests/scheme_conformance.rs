//! What every method is held to. A new one is added to `scheme::SCHEMES` and so to all of this.

use federpendel::lens::{self, Course};
use federpendel::scheme::{DryFriction, SCHEMES, Scheme, Setting, named};
use federpendel::{
    Coulomb, Error, Friction, Motion, Newton, NormalForce, Oscillator, State, Stokes,
};

/// The mix whose bits are set: 1 Stokes, 2 Coulomb, 4 Newton.
fn friction(bits: u8) -> Friction {
    Friction {
        stokes: (bits & 1 > 0).then(|| Stokes::new(0.05).unwrap()),
        coulomb: (bits & 2 > 0)
            .then(|| Coulomb::new(0.02, 0.03, NormalForce::Weight(9.81)).unwrap()),
        newton: (bits & 4 > 0).then(|| Newton::new(0.235).unwrap()),
    }
}

fn motion(bits: u8, x0: f64, v0: f64) -> Motion {
    let oscillator = Oscillator::new(0.5, 20.0, friction(bits)).unwrap();
    Motion::new(oscillator, State::new(x0, v0).unwrap()).unwrap()
}

fn course(scheme: &Scheme, motion: &Motion) -> Course {
    Course::new(scheme, &Setting::of(motion)).unwrap()
}

const RELEASES: [(f64, f64); 4] = [(0.1, 0.0), (-0.07, 0.5), (0.0, -0.6), (0.05, 0.4)];

#[test]
fn names_are_unique_and_are_found() {
    for scheme in &SCHEMES {
        assert_eq!(named(scheme.name).unwrap().order, scheme.order);
        assert_eq!(SCHEMES.iter().filter(|other| other.name == scheme.name).count(), 1);
    }
    assert!(named("rk5").is_none());
}

#[test]
fn every_method_comes_near_the_exact_motion_of_every_mix() {
    for bits in 0..8 {
        for (x0, v0) in RELEASES {
            let motion = motion(bits, x0, v0);
            for scheme in &SCHEMES {
                let errors = lens::errors(&motion, &mut course(scheme, &motion), 2.0).unwrap();
                let allowed = 0.012 * motion.amplitude();
                assert!(errors.largest < allowed, "{} {bits} {x0} {v0}: {errors:?}", scheme.name);
            }
        }
    }
}

#[test]
fn mirror_images_have_mirror_images() {
    for bits in 0..8 {
        for (x0, v0) in RELEASES {
            for scheme in &SCHEMES {
                let run = |side: f64| {
                    let motion = motion(bits, side * x0, side * v0);
                    course(scheme, &motion).at(1.7).unwrap()
                };
                let (one, other) = (run(1.0), run(-1.0));
                assert_eq!((one.position, one.velocity), (-other.position, -other.velocity));
            }
        }
    }
}

#[test]
fn friction_takes_energy() {
    for bits in 1..8 {
        let motion = motion(bits, 0.1, 0.0);
        for scheme in &SCHEMES {
            let mut course = course(scheme, &motion);
            let state = course.at(3.0).unwrap();
            let left = motion.oscillator().energy(state) / motion.initial_energy();
            let exact = motion.oscillator().energy(motion.at(3.0).unwrap().state());
            assert!(left < 1.0, "{} {bits}: {left}", scheme.name);
            assert!(
                (left - exact / motion.initial_energy()).abs() < 0.01,
                "{} {bits}",
                scheme.name
            );
        }
    }
}

#[test]
fn states_within_a_step_join_those_at_its_ends() {
    for bits in [0, 2, 7] {
        let motion = motion(bits, 0.1, 0.0);
        for scheme in &SCHEMES {
            let mut course = course(scheme, &motion);
            for _ in 0..600 {
                let (from, before) = course.now();
                course.step().unwrap();
                let (to, after) = course.now();
                if to.is_infinite() {
                    break; // A method that chooses its steps rests in one.
                }
                let (early, late) = (from + 1e-9 * (to - from), to - 1e-9 * (to - from));
                for (time, expected) in [(early, before), (late, after)] {
                    let found = course.at(time).unwrap();
                    let off = (found.position - expected.position).abs();
                    assert!(off < 1e-8 + 1e-6 * (to - from), "{} {off}", scheme.name);
                }
            }
        }
    }
}

/// What is stuck stays stuck; what has no static friction of its own never is.
#[test]
fn who_sticks_and_who_creeps() {
    let sticks = |scheme: &Scheme, bits: u8| {
        let motion = motion(bits, 0.1, 0.0);
        lens::ending(&motion, scheme, &Setting::of(&motion)).unwrap().expect("it rests")
    };
    for scheme in SCHEMES.iter().filter(|scheme| !scheme.adaptive) {
        for bits in [2, 3, 6, 7] {
            let ending = sticks(scheme, bits);
            let expected = matches!(scheme.dry, DryFriction::Located | DryFriction::Inclusion);
            assert_eq!(ending.sticks, expected, "{} {bits}: {ending:?}", scheme.name);
            assert_eq!(ending.creep == Some(0.0), expected, "{} {ending:?}", scheme.name);
        }
    }
    assert!(sticks(named("dopri5-located").unwrap(), 7).sticks);
}

/// Released inside the band of static friction, and outside that of kinetic friction.
#[test]
fn a_release_inside_the_band_is_held() {
    let motion = motion(2, 0.006, 0.0);
    for name in ["verlet-located", "rk4-located", "dopri5-located", "moreau-jean"] {
        let state = course(named(name).unwrap(), &motion).at(5.0).unwrap();
        assert_eq!((state.position, state.velocity), (0.006, 0.0), "{name}");
    }
}

#[test]
fn located_reversals_end_where_the_exact_motion_ends() {
    let motion = motion(7, 0.1, 0.0);
    let federpendel::Outcome::Rests(rest) = motion.outcome() else { panic!("it rests") };
    for (name, within) in
        [("verlet-located", 1e-5), ("rk4-located", 1e-9), ("dopri5-located", 1e-5)]
    {
        let state = course(named(name).unwrap(), &motion).at(rest.time + 1.0).unwrap();
        assert!((state.position - rest.position).abs() < within, "{name}: {state:?} {rest:?}");
    }
}

/// What still swings does not creep.
#[test]
fn a_step_so_long_that_the_method_swings_on_is_no_creep() {
    let motion = motion(2, 0.1, 0.0);
    let setting = Setting::of(&motion).with_time_step(0.6).unwrap();
    let ending = lens::ending(&motion, named("moreau-jean").unwrap(), &setting).unwrap();
    let ending = ending.expect("it rests");
    assert!(!ending.sticks && ending.creep.is_none(), "{ending:?}");
}

/// A step from which the article's scheme, Euler, Verlet and Runge–Kutta all run away.
#[test]
fn what_diverges_says_so_and_when() {
    let oscillator = Oscillator::new(0.5, 20.0, Stokes::new(0.1).unwrap()).unwrap();
    let motion = Motion::new(oscillator, State::new(0.1, 0.0).unwrap()).unwrap();
    let setting = Setting::of(&motion).with_time_step(1.0).unwrap();
    for name in ["article-scheme", "symplectic-euler", "verlet", "rk4", "rk4-tanh"] {
        let mut course = Course::new(named(name).unwrap(), &setting).unwrap();
        let failed = course.at(1e4).unwrap_err();
        let Error::Diverged { time, .. } = failed else { panic!("{name}: {failed:?}") };
        assert!(time > 1.0 && time < 100.0, "{name}: {time}");
    }
}

#[test]
fn settings_are_checked_by_name() {
    let setting = Setting::of(&motion(0, 0.1, 0.0));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let name = |result: federpendel::Result<Setting>| match result {
            Err(Error::Parameter { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        assert_eq!(name(setting.with_time_step(bad)), "dt");
        assert_eq!(name(setting.with_tolerance(bad)), "tolerance");
        assert_eq!(name(setting.with_width(bad)), "width");
    }
}

/// Released on the edge of the band in round numbers: outside it by a rounding, and yet friction is as strong
/// as the spring there.
#[test]
fn the_edge_of_the_band_makes_no_endless_step() {
    for (mass, stiffness, kinetic, position) in [
        (0.05, 10.0, 0.47, 0.0230535),
        (0.01, 12.0, 0.003, 2.4525000000000003e-5),
        (0.1, 10.0, 0.47, 0.046107),
    ] {
        let dry = Coulomb::new(kinetic, kinetic, NormalForce::Weight(9.81)).unwrap();
        let oscillator = Oscillator::new(mass, stiffness, dry).unwrap();
        let motion = Motion::new(oscillator, State::new(position, 0.0).unwrap()).unwrap();
        for scheme in &SCHEMES {
            let state = course(scheme, &motion).at(2.0).unwrap();
            assert!(state.position.abs() <= 1.01 * position, "{}", scheme.name);
        }
    }
}

/// A step that holds more reversals than can be followed, and one with which the method runs away.
#[test]
fn steps_without_measure_are_refused() {
    let motion = motion(1, 0.1, 0.0);
    let at = |name: &str, time_step: f64| {
        let setting = Setting::of(&motion).with_time_step(time_step).unwrap();
        let failed = Course::new(named(name).unwrap(), &setting).unwrap().at(1e9).unwrap_err();
        matches!(failed, Error::StepLimit { .. } | Error::Diverged { .. })
    };
    let setting = Setting::of(&motion).with_time_step(1e-12).unwrap();
    let course = Course::new(named("rk4").unwrap(), &setting).unwrap();
    assert!(matches!(course.check(1.0), Err(Error::TooManySteps { .. })));
    assert!(at("rk4-located", 1e9) && at("verlet-located", 1e9) && at("rk4", 1.2));
}
