//! Records on even grids, on which most states are carried on from others, beside states that are computed one by one.

use federpendel::{
    Coulomb, Friction, Motion, NormalForce, Oscillator, Outcome, State, Stokes, even_times,
};

const X0: f64 = 0.1;

/// Unit mass and stiffness, so that ω0 = 1; `zeta` is the damping ratio, and the normal force is one too.
fn motion(zeta: f64, kinetic: f64, static_: f64, velocity: f64) -> Motion {
    let friction = Friction {
        stokes: Some(Stokes::new(2.0 * zeta).unwrap()),
        coulomb: Some(Coulomb::new(kinetic, static_, NormalForce::Given(1.0)).unwrap()),
        newton: None,
    };
    let oscillator = Oscillator::new(1.0, 1.0, friction).unwrap();
    Motion::new(oscillator, State::new(X0, velocity).unwrap()).unwrap()
}

/// The largest difference between the record and single states, over the amplitude.
fn difference(motion: &Motion, duration: f64, samples: usize) -> f64 {
    let (mut x, mut v) = (vec![0.0; samples], vec![0.0; samples]);
    motion.sample_even(duration, &mut x, &mut v).unwrap();
    let states = motion.samples(&even_times(duration, samples).unwrap()).unwrap();
    let differences = states
        .iter()
        .zip(x.iter().zip(v))
        .map(|(state, (x, v))| (state.position - x).abs().max((state.velocity - v).abs()));
    differences.fold(0.0, f64::max) / motion.amplitude()
}

/// Fine grids and grids with many swings between samples, of few samples and of many, up to nearly 10⁶ periods.
#[test]
fn agree_with_single_states() {
    for zeta in [0.0, 1e-8, 0.005, 0.3, 0.8, 1.0 - 1e-6, 1.0 - 1e-15, 1.0, 1.1] {
        for (kinetic, velocity) in [(0.0, 0.0), (0.0, -0.3), (1e-9, 0.2), (0.003, 0.0)] {
            let motion = motion(zeta, kinetic, kinetic, velocity);
            for duration in [0.1, 7.0, 130.0, 6.2e6] {
                for samples in [2, 9, 70, 5000] {
                    let difference = difference(&motion, duration, samples);
                    let case = format!("{zeta} {kinetic} {velocity} {duration} {samples}");
                    assert!(difference < 8.0 * f64::EPSILON, "{case}: {difference:e}");
                }
            }
        }
    }
}

/// A mass that only sticks: one formula up to the rest, and no further.
#[test]
fn end_where_static_friction_holds() {
    let motion = motion(0.01, 0.0, 0.02, 0.0);
    let Outcome::Rests(rest) = motion.outcome() else { panic!("{:?}", motion.outcome()) };
    for samples in [30, 3000] {
        assert!(difference(&motion, 2.0 * rest.time, samples) < 8.0 * f64::EPSILON, "{samples}");
    }
}
