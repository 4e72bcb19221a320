//! Times at which nothing can overflow unseen.

use federpendel::{
    Coulomb, Error, Motion, Newton, NormalForce, Oscillator, Outcome, State, Stokes,
};

const LONG: [f64; 4] = [1e20, 1e200, 1e300, f64::MAX];

fn motion(friction: impl Into<federpendel::Friction>) -> Motion {
    let oscillator = Oscillator::new(0.5, 20.0, friction).unwrap();
    Motion::new(oscillator, State::new(0.1, 0.2).unwrap()).unwrap()
}

#[test]
fn what_rests_rests_for_ever() {
    let dry = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81)).unwrap();
    let motion = motion(dry);
    let Outcome::Rests(rest) = motion.outcome() else { panic!("{:?}", motion.outcome()) };
    for time in LONG {
        assert_eq!(motion.at(time).unwrap().position, rest.position, "{time}");
    }
}

#[test]
fn what_creeps_has_arrived() {
    let motion = motion(Stokes::new(50.0).unwrap());
    for time in LONG {
        let sample = motion.at(time).unwrap();
        assert_eq!((sample.position, sample.velocity), (0.0, 0.0), "{time}");
    }
}

#[test]
fn what_swings_for_ever_is_lost() {
    for motion in [motion(federpendel::Friction::NONE), motion(Stokes::new(0.1).unwrap())] {
        for time in LONG {
            let lost = motion.at(time).unwrap_err();
            assert!(matches!(lost, Error::TooManySwings { .. }), "{time}: {lost}");
        }
    }
}

#[test]
fn what_nothing_slows_keeps_its_amplitude() {
    assert_eq!(motion(federpendel::Friction::NONE).outcome(), Outcome::Swings);
    for motion in [motion(Stokes::new(0.1).unwrap()), motion(Newton::new(0.3).unwrap())] {
        assert_eq!(motion.outcome(), Outcome::Decays);
        let amplitude = |n| motion.turning_points().nth(n).unwrap().position.abs();
        assert!(amplitude(40) < 0.9 * amplitude(0));
    }
}

#[test]
fn drag_with_damping_ends_in_the_closed_form() {
    let friction = federpendel::Friction {
        stokes: Some(Stokes::new(50.0).unwrap()),
        coulomb: None,
        newton: Some(Newton::new(0.3).unwrap()),
    };
    for time in LONG {
        assert_eq!(motion(friction).at(time).unwrap().position, 0.0, "{time}");
    }
}

#[test]
fn who_cannot_wait_has_fewer_swings_followed() {
    let drag = |friction| motion(friction).with_most_swings(100);
    let motion = drag(federpendel::Friction {
        newton: Some(Newton::new(1e-9).unwrap()),
        ..federpendel::Friction::NONE
    });
    assert!(motion.at(49.0).is_ok());
    let Error::TooManySwings { swings: 100, reached, .. } = motion.at(1e6).unwrap_err() else {
        panic!("it is followed");
    };
    // The first of them is a partial one.
    let half = motion.oscillator().period().unwrap() / 2.0;
    assert!(reached > 99.0 * half && reached < 100.0 * half, "{reached}");
}
