//! Any parameters, any release, any time: refused, or a motion that is finite, keeps its energy bound and
//! ends at its last turning point. Motions of very many swings are left out for their time alone.
#![no_main]

use federpendel::{
    Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, Outcome, State, Stokes,
};
use libfuzzer_sys::arbitrary::{self, Arbitrary, Result, Unstructured};
use libfuzzer_sys::fuzz_target;

/// Most swings that an input may ask for.
const MOST_SWINGS: f64 = 1e4;

/// A number as measurements have it, or any `f64` at all.
#[derive(Debug)]
struct Number(f64);

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(source: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Number(match source.arbitrary::<u8>()? {
            kind @ 0..=223 => {
                let exponent = i32::from(kind % 14) - 9;
                f64::from(source.arbitrary::<i16>()?) * 10f64.powi(exponent)
            }
            224..=239 => 0.0,
            _ => source.arbitrary()?,
        }))
    }
}

#[derive(Debug, Arbitrary)]
struct Input {
    mass: Number,
    stiffness: Number,
    damping: Option<Number>,
    coulomb: Option<(Number, Number, Number, bool)>,
    newton: Option<Number>,
    release: (Number, Number),
    times: [Number; 4],
}

impl Input {
    fn motion(&self) -> federpendel::Result<Motion> {
        let coulomb = |(kinetic, above, force, weight): &(Number, Number, Number, bool)| {
            let force = if *weight { NormalForce::Weight } else { NormalForce::Given }(force.0.abs());
            Coulomb::new(kinetic.0.abs(), kinetic.0.abs() + above.0.abs(), force)
        };
        let friction = Friction {
            stokes: self.damping.as_ref().map(|damping| Stokes::new(damping.0.abs())).transpose()?,
            coulomb: self.coulomb.as_ref().map(coulomb).transpose()?,
            newton: self.newton.as_ref().map(|drag| Newton::new(drag.0.abs())).transpose()?,
        };
        let oscillator = Oscillator::new(self.mass.0.abs(), self.stiffness.0.abs(), friction)?;
        Motion::new(oscillator, State::new(self.release.0.0, self.release.1.0)?)
    }
}

/// Whether finding the end of `motion` follows no more than [`MOST_SWINGS`], estimated.
fn ends_soon(motion: &Motion) -> bool {
    let oscillator = motion.oscillator();
    let (f, band) = (oscillator.offset(), oscillator.sticking_offset());
    if !oscillator.friction().mix().newton || band == 0.0 {
        return true;
    }
    let (amplitude, zeta, kappa) =
        (motion.amplitude(), oscillator.damping_ratio(), oscillator.newton_rate());
    let dry = amplitude / f;
    let damped = (amplitude / band).ln().max(0.0) / zeta;
    dry.min(damped).min(1.0 / (kappa * band)) < MOST_SWINGS
}

fuzz_target!(|input: Input| {
    let Ok(motion) = input.motion() else { return };
    let omega0 = motion.oscillator().angular_frequency();
    // x² + (v/ω0)² never exceeds what the release brings in.
    let most = 1.4143 * motion.amplitude();
    for Number(time) in &input.times {
        let time = time.abs();
        if time * omega0 > MOST_SWINGS {
            continue;
        }
        let Ok(sample) = motion.at(time) else { continue };
        assert!(sample.position.abs() <= most, "{sample:?} of {motion:?}");
        assert!((sample.velocity / omega0).abs() <= most, "{sample:?} of {motion:?}");
        assert!(sample.acceleration.is_finite(), "{sample:?} of {motion:?}");
    }
    if !ends_soon(&motion) {
        return;
    }
    match motion.outcome() {
        Outcome::Rests(rest) => {
            assert!(rest.time >= 0.0 && rest.time.is_finite(), "{rest:?} of {motion:?}");
            assert!(rest.position.abs() <= most, "{rest:?} of {motion:?}");
            if (1..=MOST_SWINGS as u64).contains(&rest.swings) {
                let last = motion.turning_points().last().expect("it has turned");
                assert_eq!((last.time, last.position), (rest.time, rest.position), "{motion:?}");
            }
        }
        Outcome::Creeps { limit } => assert!(limit.abs() <= most, "{limit} of {motion:?}"),
        _ => {}
    }
});
