//! Inputs at the ends of the range of `f64`: refused by name, or computed; never NaN, never endless.

use federpendel::{
    Coulomb, Error, Friction, Motion, Newton, NormalForce, Oscillator, Outcome, State, Stokes,
};

/// Without a coefficient no force is too large, and what is too large is not called no number.
#[test]
fn what_does_not_act_is_not_in_the_way_and_nothing_is_called_nan() {
    let smooth = Coulomb::new(0.0, 0.0, NormalForce::Weight(1e305)).unwrap();
    assert!(motion(1.0, 1.0, smooth, 0.1).is_ok());
    let huge = Stokes::new(1e305).unwrap();
    for (mass, stiffness, friction) in [
        (1.0, 1e308, Friction::NONE),
        (1e-2, 1e301, Friction::NONE),
        (1e301, 1e-3, Friction::NONE),
        (3.0, 1e-302, Friction::NONE),
        (1.0, 1.0, huge.into()),
    ] {
        let Err(Error::Derived { value, of, .. }) = motion(mass, stiffness, friction, 0.1) else {
            panic!("{mass:e} {stiffness:e}");
        };
        assert!(!value.is_nan() && !of.is_empty(), "{value} {of:?}");
    }
}

fn refused(motion: federpendel::Result<Motion>) -> &'static str {
    match motion {
        Err(Error::Derived { quantity, .. }) => quantity,
        other => panic!("{other:?}"),
    }
}

fn motion(
    mass: f64,
    stiffness: f64,
    friction: impl Into<Friction>,
    position: f64,
) -> federpendel::Result<Motion> {
    Motion::new(Oscillator::new(mass, stiffness, friction)?, State::new(position, 0.0)?)
}

#[test]
fn a_release_whose_energy_underflows_is_refused() {
    let drag = Newton::new(4.3e-5).unwrap();
    assert_eq!(refused(motion(1.9e-7, 1.1e-5, drag, 1.06e-321)), "position");
    assert_eq!(refused(motion(1.0, 1.0, Friction::NONE, 1e-160)), "energy");
    assert!(motion(1.0, 1.0, Friction::NONE, 0.0).is_ok());
}

#[test]
fn damping_whose_square_overflows_is_refused() {
    let damping = Stokes::new(8.374235505809573e175).unwrap();
    assert_eq!(refused(motion(0.772, 1.4385e-5, damping, -0.1736)), "damping_ratio^2");
}

#[test]
fn the_strongest_damping_holds_the_mass_where_it_is() {
    let motion = motion(1.0, 1.0, Stokes::new(1e139).unwrap(), 0.5).unwrap();
    let sample = motion.at(1.0).unwrap();
    assert_eq!(sample.position, 0.5);
    assert!((sample.velocity / -0.5e-139 - 1.0).abs() < 1e-12, "{sample:?}");
}

/// Found by fuzzing: factors too large to be multiplied exactly whose product is ordinary.
#[test]
fn a_factor_out_of_range_is_refused_even_if_its_product_is_not() {
    let dry = Coulomb::new(2.56e-7, 1.42e305, NormalForce::Weight(1.2e-60)).unwrap();
    let stokes = Some(Stokes::new(10481.0).unwrap());
    let friction = Friction { stokes, coulomb: Some(dry), newton: None };
    assert_eq!(refused(motion(1e-8, 4.052e-6, friction, 0.0)), "static");
}

/// Found by fuzzing: damping brings the mass within rounding of the band 5e9 swings before the band itself.
#[test]
fn a_band_far_below_rounding_is_found_at_once() {
    let damped = Friction {
        stokes: Some(Stokes::new(3.88e-6).unwrap()),
        coulomb: Some(Coulomb::new(3.2e-4, 5.1e-4, NormalForce::Given(2.6e-231)).unwrap()),
        newton: None,
    };
    let oscillator = Oscillator::new(2.6948e-4, 1.7476e7, damped).unwrap();
    let motion = Motion::new(oscillator, State::new(4.1e-4, 2.6e-3).unwrap()).unwrap();
    let Outcome::Rests(rest) = motion.outcome() else { panic!("{:?}", motion.outcome()) };
    assert!(rest.tie && rest.position.abs() < 1e-14 * motion.amplitude(), "{rest:?}");
}

/// Found by fuzzing: an offset 1e68 times the amplitude, in which the place of rest was lost.
#[test]
fn friction_far_stronger_than_the_throw_stops_it_near_its_release() {
    let dry = Coulomb::new(2.2439, 2.243902686, NormalForce::Weight(2.239)).unwrap();
    let oscillator = Oscillator::new(2.6183e122, 2.2873, dry).unwrap();
    let motion = Motion::new(oscillator, State::new(4.2e-8, 2.45e-7).unwrap()).unwrap();
    let Outcome::Rests(rest) = motion.outcome() else { panic!("{:?}", motion.outcome()) };
    // The spring is nothing here: v0²/(2μg) and v0/(μg).
    let deceleration = 2.2439 * 2.239;
    let way = 2.45e-7 * 2.45e-7 / (2.0 * deceleration);
    assert!((rest.position - 4.2e-8 - way).abs() < 1e-22, "{rest:?}");
    assert!((rest.time * deceleration / 2.45e-7 - 1.0).abs() < 1e-14, "{rest:?}");
}

/// Found by fuzzing: a throw whose braking overflows.
#[test]
fn an_acceleration_out_of_range_is_refused() {
    let oscillator = Oscillator::new(1.2e-255, 408_000.0, Stokes::new(1e-5).unwrap()).unwrap();
    let release = State::new(-1e-9, -3.7e255).unwrap();
    assert_eq!(refused(Motion::new(oscillator, release)), "acceleration");
    let oscillator = Oscillator::new(2.56e-7, 1.97e-236, Stokes::new(9.5e-6).unwrap()).unwrap();
    let release = State::new(-257.0, -1.2e134).unwrap();
    assert_eq!(refused(Motion::new(oscillator, release)), "acceleration/omega0^2");
    let dry = Coulomb::new(1.1e217, 1.1e217, NormalForce::Given(2.6e-5)).unwrap();
    let oscillator = Oscillator::new(1.5e-101, 2.6e-6, dry).unwrap();
    let release = State::new(9.6e-5, 2.8e-4).unwrap();
    assert_eq!(refused(Motion::new(oscillator, release)), "acceleration");
}

/// Found by fuzzing: a throw so slow that it turned before it began.
#[test]
fn no_swing_ends_before_it_begins() {
    let friction = Friction {
        stokes: None,
        coulomb: Some(Coulomb::new(2.8e-5, 38.55, NormalForce::Weight(3.97e-5)).unwrap()),
        newton: Some(Newton::new(1.26e-6).unwrap()),
    };
    let oscillator = Oscillator::new(245_860.0, 99_830.0, friction).unwrap();
    let motion = Motion::new(oscillator, State::new(9.983e-6, 4.7e-234).unwrap()).unwrap();
    let Outcome::Rests(rest) = motion.outcome() else { panic!("{:?}", motion.outcome()) };
    assert!(rest.time >= 0.0 && rest.position == 9.983e-6, "{rest:?}");
}

/// Found by fuzzing: a velocity that is no length any more once it is divided by ω0.
#[test]
fn a_velocity_that_underflows_in_the_units_of_the_motion_is_refused() {
    let dry = Coulomb::new(1.6e-4, 110.0, NormalForce::Given(253_800.0)).unwrap();
    let oscillator = Oscillator::new(1.14e-259, 260.3, dry).unwrap();
    let release = State::new(-3.9e-8, 1.1e-259).unwrap();
    assert_eq!(refused(Motion::new(oscillator, release)), "velocity/angular_frequency");
}

/// Found by fuzzing: lengths whose products overflow in the series of drag.
#[test]
fn an_amplitude_too_large_for_the_series_of_drag_is_refused() {
    let drag = Newton::new(8e-125).unwrap();
    let oscillator = Oscillator::new(1e-5, 1.07e-255, drag).unwrap();
    let release = State::new(7.71e7, 0.000771).unwrap();
    assert_eq!(refused(Motion::new(oscillator, release)), "amplitude^3");
}
