//! The heats are work integrals of their own; that they add up to the energy lost is a check.

use federpendel::{Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, State, Stokes};

fn oscillator(damping: f64, kinetic: f64, static_: f64, newton: f64) -> Oscillator {
    let friction = Friction {
        stokes: Some(Stokes::new(damping).unwrap()),
        coulomb: Some(Coulomb::new(kinetic, static_, NormalForce::Weight(9.81)).unwrap()),
        newton: Some(Newton::new(newton).unwrap()),
    };
    Oscillator::new(0.5, 20.0, friction).unwrap()
}

/// A throw whose velocity drag takes nearly all at once.
#[test]
fn energy_is_conserved_in_the_strongest_drag() {
    // Beyond 1e3 the velocity itself is known less well just after the throw.
    for (newton, within) in [(1e2, 1e-13), (1e3, 1e-13), (5e4, 1e-11)] {
        for (damping, position, velocity) in [(0.0, 1.0, 2.0), (0.0, 0.0, -2.0), (1.0, 0.4, -0.3)] {
            let friction = Friction {
                stokes: Some(Stokes::new(damping).unwrap()),
                newton: Some(Newton::new(newton).unwrap()),
                ..Friction::NONE
            };
            let oscillator = Oscillator::new(1.0, 1.0, friction).unwrap();
            let release = State::new(position, velocity).unwrap();
            let motion = Motion::new(oscillator, release).unwrap();
            let initial = motion.initial_energy();
            for entry in motion.ledger(&[1e-4, 0.1, 50.0, 5000.0]).unwrap() {
                let sum = entry.kinetic + entry.potential + entry.heat.total();
                let gap = (sum - initial).abs() / initial;
                assert!(gap < within, "{gap:e} at {} with {newton} {damping}", entry.time);
            }
        }
    }
}

#[test]
fn energy_is_conserved_for_every_mix_and_damping() {
    let times: Vec<f64> = (0..200).map(|i| 0.137 * f64::from(i)).chain([1e3, 1e4]).collect();
    for damping in [0.0, 1e-9, 0.05, 3.0, 6.324555320336759, 6.4, 15.0, 4e3] {
        for (kinetic, static_) in [(0.0, 0.0), (0.0, 0.01), (0.02, 0.03), (1e-5, 1e-5)] {
            for newton in [0.0, 1e-6, 0.235, 50.0] {
                if damping > 15.0 && newton > 0.0 {
                    continue;
                }
                for (position, velocity) in [(0.1, 0.0), (-0.1, 0.5), (0.0, -1.0), (0.05, 0.3)] {
                    let oscillator = oscillator(damping, kinetic, static_, newton);
                    let motion =
                        Motion::new(oscillator, State::new(position, velocity).unwrap()).unwrap();
                    let initial = motion.initial_energy();
                    for entry in motion.ledger(&times).unwrap() {
                        let sum = entry.kinetic + entry.potential + entry.heat.total();
                        let gap = (sum - initial).abs() / initial;
                        assert!(gap < 1e-13, "{gap:e} at {} of {motion:?}", entry.time);
                    }
                }
            }
        }
    }
}
