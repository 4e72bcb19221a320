//! Coulomb experiments in round numbers that end a swing exactly on the edge of the sticking band.
//!
//! From rest |x_n| = |x0| − 2nμ_k m g/C, so C|x_n| against μ_s m g is a comparison of products of the
//! inputs: exact in whole numbers, both for the decimal inputs and for the binary ones that hold them.

use federpendel::{Coulomb, Motion, NormalForce, Oscillator, Outcome, Rest, State, Ties};
use num_bigint::BigInt;

/// An experiment that ends on the edge in decimals.
#[derive(Debug, Clone, Copy)]
struct Case {
    mass: f64,
    stiffness: f64,
    gravity: f64,
    kinetic: f64,
    static_: f64,
    position: f64,
    /// Number of swings in decimals.
    swings: u64,
}

/// Whole numbers of a decimal unit, as the `f64` that a user's decimal fraction becomes.
fn decimal(count: i128, unit: &str) -> f64 {
    format!("{count}{unit}").parse().expect("a decimal number")
}

/// x0 = (2Nμ_k + μ_s) m g/C for every combination in which that is a decimal fraction.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for mass in [100, 200, 250, 300, 500, 1000, 1500] {
        for stiffness in [80, 100, 125, 200, 400, 500] {
            for gravity in [981, 1000] {
                for (kinetic, static_) in [
                    (20, 20),
                    (20, 30),
                    (50, 50),
                    (70, 70),
                    (100, 100),
                    (100, 150),
                    (110, 130),
                    (300, 300),
                ] {
                    for swings in [1, 2, 3, 5, 7, 10, 23] {
                        let force = (2 * swings * kinetic + static_) * mass * gravity;
                        let nano = force * 10 * 1_000_000;
                        if nano % stiffness != 0 {
                            continue;
                        }
                        cases.push(Case {
                            mass: decimal(mass, "e-3"),
                            stiffness: decimal(stiffness, "e-1"),
                            gravity: decimal(gravity, "e-2"),
                            kinetic: decimal(kinetic, "e-3"),
                            static_: decimal(static_, "e-3"),
                            position: decimal(nano / stiffness, "e-14"),
                            swings: swings as u64,
                        });
                    }
                }
            }
        }
    }
    cases
}

impl Case {
    fn rest(&self, side: f64, ties: Ties) -> Rest {
        let law = Coulomb::new(self.kinetic, self.static_, NormalForce::Weight(self.gravity));
        let oscillator = Oscillator::new(self.mass, self.stiffness, law.unwrap()).unwrap();
        let release = State::new(side * self.position, 0.0).unwrap();
        match Motion::with_ties(oscillator, release, ties).unwrap().outcome() {
            Outcome::Rests(rest) => rest,
            other => panic!("{other:?} for {self:?}"),
        }
    }

    /// Number of swings if the binary inputs are taken as exact. A gap of less than 2⁻⁹⁶, which double-double
    /// cannot tell from none, comes up where the roundings of two inputs happen to cancel.
    fn binary_swings(&self) -> u64 {
        let pull = (binary(self.stiffness) * binary(self.position)) << BITS;
        let weight = binary(self.mass) * binary(self.gravity);
        let (kinetic, static_) = (&weight * binary(self.kinetic), &weight * binary(self.static_));
        let static_ = static_ + (&pull >> 96);
        (0..).find(|n| &pull - &kinetic * (2 * n) <= static_).expect("it falls with n")
    }
}

/// [`binary`] counts in units of 2 to the minus this.
const BITS: u32 = 80;

/// The exact value of a number of ordinary size.
fn binary(value: f64) -> BigInt {
    let bits = value.to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    let exponent = (bits >> 52) as i32 - 1075 + BITS as i32;
    assert!(exponent >= 0, "{value} is too small for {BITS} bits");
    BigInt::from(mantissa) << exponent
}

#[test]
fn decimal_experiments_on_the_edge_stick_there() {
    let cases = cases();
    assert!(cases.len() > 300, "{} cases", cases.len());
    for case in cases {
        for side in [1.0, -1.0] {
            let rest = case.rest(side, Ties::Stick);
            assert_eq!(rest.swings, case.swings, "{case:?} {rest:?}");
            assert!(rest.tie, "{case:?} {rest:?}");
            assert!(rest.margin.abs() < 1e-12, "{case:?} {rest:?}");
        }
    }
}

#[test]
fn the_strict_reading_is_that_of_the_binary_inputs() {
    let cases = cases();
    let mut changed = 0;
    for case in &cases {
        let swings = case.binary_swings();
        assert_eq!(case.rest(1.0, Ties::Strict).swings, swings, "{case:?}");
        changed += usize::from(swings != case.swings);
    }
    // What is left of a tie in binary is a matter of chance; half of the chances go on.
    let share = changed as f64 / cases.len() as f64;
    assert!((0.15..0.6).contains(&share), "{changed} of {} changed", cases.len());
}
