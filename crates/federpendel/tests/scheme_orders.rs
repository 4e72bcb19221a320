//! What order each method declares, what it shows where the motion is smooth, and what friction leaves of it.

use federpendel::lens::{self, Ladder};
use federpendel::scheme::{DryFriction, SCHEMES, Scheme, Setting, named};
use federpendel::{Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, State, Stokes};

fn motion(friction: impl Into<Friction>) -> Motion {
    let oscillator = Oscillator::new(0.5, 20.0, friction).unwrap();
    Motion::new(oscillator, State::new(0.1, 0.0).unwrap()).unwrap()
}

fn dry(kinetic: f64) -> Coulomb {
    Coulomb::new(kinetic, kinetic, NormalForce::Weight(9.81)).unwrap()
}

fn ladder(motion: &Motion, scheme: &Scheme) -> Ladder {
    lens::ladder(motion, scheme, &Setting::of(motion), 12.0)
}

fn order(motion: &Motion, name: &str) -> f64 {
    let scheme = named(name).expect("a name of the list");
    ladder(motion, scheme).order().expect("errors above zero")
}

/// Methods without located reversals see the jump of the second derivative of v|v| at each reversal.
fn smooth_for(scheme: &Scheme, friction: &Friction) -> bool {
    friction.newton.is_none() || scheme.order <= 2 || scheme.dry == DryFriction::Located
}

#[test]
fn every_method_keeps_its_declared_order_on_smooth_motions() {
    let smooth: [Friction; 3] =
        [Friction::NONE, Stokes::new(0.2).unwrap().into(), Newton::new(0.235).unwrap().into()];
    for friction in smooth {
        let motion = motion(friction);
        for scheme in SCHEMES.iter().filter(|scheme| smooth_for(scheme, &friction)) {
            // The article's backward quotient costs an order wherever friction acts.
            let declared = match (scheme.name, friction == Friction::NONE) {
                ("article-scheme", true) => 2.0,
                _ => f64::from(scheme.order),
            };
            let found = order(&motion, scheme.name);
            assert!((found - declared).abs() <= 0.2, "{} {friction:?}: {found}", scheme.name);
        }
    }
}

/// With dry friction: reversals stepped over leave every method about first order, whatever it declares;
/// located ones give the order back.
#[test]
fn dry_friction_takes_the_order_unless_reversals_are_located() {
    let mixed = Friction {
        stokes: Some(Stokes::new(0.05).unwrap()),
        coulomb: Some(dry(0.005)),
        newton: Some(Newton::new(0.047).unwrap()),
    };
    for friction in [Friction::from(dry(0.02)), mixed] {
        let motion = motion(friction);
        for name in ["article-scheme", "symplectic-euler", "verlet", "rk4", "moreau-jean"] {
            let found = order(&motion, name);
            assert!((0.6..=1.5).contains(&found), "{name}: {found}");
        }
        for name in ["verlet-located", "rk4-located", "dopri5-located"] {
            let declared = f64::from(named(name).unwrap().order);
            let found = order(&motion, name);
            assert!((found - declared).abs() <= 0.2, "{name}: {found}");
        }
    }
}

/// Smooth friction is another equation: a shorter step does not bring it nearer to dry friction, a narrower
/// width does.
#[test]
fn smooth_friction_converges_with_its_width_not_with_the_step() {
    let motion = motion(dry(0.02));
    assert!(order(&motion, "rk4-tanh").abs() < 0.2);
    let error = |width: f64| {
        let setting = Setting::of(&motion).with_width(width).unwrap();
        let setting = setting.with_time_step(2e-5).unwrap();
        let mut course = lens::Course::new(named("rk4-tanh").unwrap(), &setting).unwrap();
        lens::errors(&motion, &mut course, 4.5).unwrap().largest
    };
    assert!(error(1e-3) < 0.3 * error(1e-2));
}

/// Where sign(v) changes with every step no step is short enough for a tolerance.
#[test]
fn a_tolerance_and_a_sign_do_not_go_together_at_rest() {
    let motion = motion(dry(0.02));
    let ladder = ladder(&motion, named("dopri5").unwrap());
    let failed = ladder.failed.as_ref().expect("a failure");
    let federpendel::Error::StepLimit { time, .. } = failed.error else { panic!("{failed:?}") };
    assert!(time > 4.967 && failed.tolerance.is_some(), "{failed:?}");
    assert_eq!(ladder.order(), None);
}
