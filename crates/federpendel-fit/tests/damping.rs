//! Engineers' figures held against the energy that the exact motion loses, and against its amplitudes.

use std::f64::consts::PI;

use federpendel::{Coulomb, Friction, Mix, Motion, Newton, NormalForce, Oscillator, State, Stokes};
use federpendel_fit::{Damping, Laws, Options, Quantity, Recording, damping, fit};

mod synthetic;
use synthetic::Random;

/// A motion of unit mass and ω0 = 6, released at 1 m: γ, a_c and κ.
fn motion(damping_rate: f64, coulomb: f64, newton: f64) -> Motion {
    let friction = Friction {
        stokes: Some(Stokes::new(2.0 * damping_rate).unwrap()),
        coulomb: Some(Coulomb::new(coulomb, coulomb, NormalForce::Given(1.0)).unwrap()),
        newton: Some(Newton::new(newton).unwrap()),
    };
    let oscillator = Oscillator::new(1.0, 36.0, friction).unwrap();
    Motion::new(oscillator, State::new(1.0, 0.0).unwrap()).unwrap()
}

fn recording(motion: &Motion, noise: f64, seed: u64) -> Recording {
    let mut random = Random(seed);
    let times: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
    let samples = motion.samples(&times).unwrap();
    let values = samples.iter().map(|sample| sample.position + noise * random.normal()).collect();
    Recording { times, values, quantity: Quantity::Position, unit: "m".into() }
}

fn figures(motion: &Motion, noise: f64, seed: u64) -> Damping {
    let report = fit(&recording(motion, noise, seed), &Options::default()).expect("fits");
    damping(&report).expect("a verdict has its model")
}

#[test]
fn the_equivalent_ratio_takes_as_much_energy_as_the_motion() {
    let cases = [(0.02, 0.0, 0.0), (0.0, 0.03, 0.0), (0.0, 0.0, 0.006), (0.01, 0.01, 0.003)];
    for (rate, coulomb, newton) in cases {
        let motion = motion(rate, coulomb, newton);
        let found = figures(&motion, 1e-4, 4).equivalent;
        assert_eq!(found.len(), 5);
        assert!((found[0].amplitude - 1.0).abs() < 0.01, "{found:?}");
        let turns: Vec<f64> = motion.turning_points().take(60).map(|p| p.position.abs()).collect();
        for one in found {
            // ½ω0²A² before and after each cycle: ζ_eq at its mean amplitude, between the cycles around it.
            let loss = turns.windows(3).min_by(|a, b| {
                let off = |w: &[f64]| (w[1] - one.amplitude).abs();
                off(a).total_cmp(&off(b))
            });
            let [before, middle, after] = loss.and_then(|w| <[f64; 3]>::try_from(w).ok()).unwrap();
            let exact = (before.powi(2) - after.powi(2)) / (4.0 * PI * middle.powi(2));
            // The amplitude asked for lies at most half a swing from the middle.
            let near = (1.5 * (middle / one.amplitude - 1.0).abs()).max(0.005);
            let ratio = one.damping_ratio / exact - 1.0;
            assert!(ratio.abs() < near, "{one:?}: {exact}, {:?}", (rate, coulomb, newton));
        }
    }
}

#[test]
fn stokes_friction_alone_has_a_decrement_and_a_quality_factor() {
    let motion = motion(0.3, 0.0, 0.0);
    let found = figures(&motion, 1e-3, 5);
    let turns: Vec<f64> = motion.turning_points().take(4).map(|p| p.position.abs()).collect();
    let near = |estimate: Option<federpendel_fit::Estimate>, truth: f64| {
        let estimate = estimate.expect("Stokes friction acts alone");
        let (value, stderr) = estimate.value.zip(estimate.stderr).unwrap();
        assert!((value - truth).abs() < 3.0 * stderr, "{value} ± {stderr}, not {truth}");
        assert!(stderr < 0.02 * truth, "{value} ± {stderr}");
        let (low, high) = estimate.interval95;
        assert!(low.unwrap() < value && value < high.unwrap(), "{estimate:?}");
    };
    near(found.logarithmic_decrement, (turns[0] / turns[2]).ln());
    near(found.quality_factor, 6.0 / (2.0 * 0.3));
    near(found.damping_ratio, 0.05);
    near(Some(found.natural_frequency), 6.0 / (2.0 * PI));
}

#[test]
fn their_errors_are_the_spread_of_many_recordings() {
    let motion = motion(0.02, 0.05, 0.0);
    // Without the choice of another mix, which no standard error knows of.
    let laws = Mix { stokes: true, coulomb: true, newton: false };
    let options = Options { laws: Laws::Exactly(laws), ..Options::default() };
    let fitted = |seed| fit(&recording(&motion, 3e-3, seed), &options).expect("fits");
    let all: Vec<Damping> = (100..160).filter_map(|seed| damping(&fitted(seed))).collect();
    for i in [0, 2, 4] {
        let values: Vec<f64> = all.iter().map(|one| one.equivalent[i].damping_ratio).collect();
        let mean = values.iter().sum::<f64>() / 60.0;
        let spread = (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 59.0).sqrt();
        let stated = all.iter().filter_map(|one| one.equivalent[i].stderr).sum::<f64>() / 60.0;
        // The spread of 60 is known to a tenth.
        assert!((stated / spread - 1.0).abs() < 0.35, "{i}: {stated}, not {spread}");
    }
}

#[test]
fn what_depends_on_the_amplitude_is_no_single_number() {
    let mixed = figures(&motion(0.02, 0.05, 0.0), 1e-3, 6);
    assert!(mixed.damping_ratio.is_some());
    assert!(mixed.logarithmic_decrement.is_none() && mixed.quality_factor.is_none());
    let dry = figures(&motion(0.0, 0.05, 0.0), 1e-3, 6);
    assert!(dry.damping_ratio.is_none());
    let ratios: Vec<f64> = dry.equivalent.iter().map(|one| one.damping_ratio).collect();
    assert!(ratios.windows(2).all(|pair| pair[1] > pair[0]), "{ratios:?}");
    // Without friction nothing is lost, beyond critical damping nothing swings.
    assert!(figures(&motion(0.0, 0.0, 0.0), 1e-3, 7).equivalent.is_empty());
    let creeping = figures(&motion(9.0, 0.0, 0.0), 1e-3, 8);
    assert!(creeping.equivalent.is_empty() && creeping.logarithmic_decrement.is_none());
}
