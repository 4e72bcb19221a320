//! The series against the first integral, a second way to the turning points of Newton friction.

use federpendel::first_integral::{next_amplitude, speed};
use federpendel::{Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, State};

/// ω0 = 1, offset f, Newton rate κ, released at 1 m.
fn motion(offset: f64, kappa: f64) -> Motion {
    let friction = Friction {
        stokes: None,
        coulomb: Some(Coulomb::new(offset, offset, NormalForce::Given(1.0)).unwrap()),
        newton: Some(Newton::new(kappa).unwrap()),
    };
    let oscillator = Oscillator::new(1.0, 1.0, friction).unwrap();
    Motion::new(oscillator, State::new(1.0, 0.0).unwrap()).unwrap()
}

#[test]
fn turning_points_and_speeds_follow_the_first_integral() {
    for offset in [0.0, 1e-3, 0.02] {
        for kappa in [1e-6, 0.03, 0.3, 3.0, 100.0] {
            let motion = motion(offset, kappa);
            let mut distance = 1.0;
            let mut before = 0.0;
            for point in motion.turning_points().take(12) {
                let from = distance - offset;
                distance = next_amplitude(kappa, from).unwrap() - offset;
                let error = (point.position.abs() - distance.abs()).abs();
                assert!(error < 2e-15, "{offset} {kappa}: {point:?} {distance}");
                let middle = motion.at(0.5 * (before + point.time)).unwrap();
                let side = f64::from(middle.mode as i8);
                let y = -side * middle.position - offset;
                let exact = speed(kappa, from, y).unwrap().unwrap();
                assert!((exact - middle.velocity.abs()).abs() < 2e-14, "{offset} {kappa}");
                before = point.time;
            }
        }
    }
}

/// Found by fuzzing: between the turning points too, where strong drag draws the motion to a slow one and a series must
/// not be followed backwards.
#[test]
fn speeds_follow_the_first_integral_all_along_a_swing() {
    for kappa in [3.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 5e4] {
        let motion = motion(0.0, kappa);
        let end = motion.turning_points().next().expect("it turns").time;
        let times: Vec<f64> = (1..2000).map(|i| end * f64::from(i) / 2000.0).collect();
        for sample in motion.samples(&times).unwrap() {
            let exact = speed(kappa, 1.0, sample.position).unwrap().unwrap();
            // Squares: next to a turning point the speed itself hangs on the last digit of the position.
            let error = (exact * exact - sample.velocity * sample.velocity).abs();
            assert!(error < 1e-14, "{kappa} at {}: {error:e}", sample.time);
        }
    }
}
