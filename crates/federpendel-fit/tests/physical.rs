//! Physical numbers of known motions, their uncertainties, and why some are not given.

use federpendel::{Coulomb, Friction, Mix, Motion, Newton, NormalForce, Oscillator, State, Stokes};
use federpendel_fit::physical::Absent;
use federpendel_fit::{
    Estimate, FitReport, Given, Measured, Normal, Options, Physical, Quantity, Recording, fit,
    physical,
};

mod synthetic;
use synthetic::Random;

/// A body of 0.24 kg on a spring of 0.03 kg, whose third moves with it.
const MASS: f64 = 0.24;
const SPRING: f64 = 0.03;
const MOVING: f64 = 0.25;
const STIFFNESS: f64 = 12.0;
const DAMPING: f64 = 0.02;
const KINETIC: f64 = 0.01;
const STATIC: f64 = 0.015;
const DRAG: f64 = 0.06;
const GRAVITY: f64 = 9.81;

fn exact(value: f64) -> Option<Measured> {
    Some(Measured { value, uncertainty: 0.0 })
}

fn about(value: f64, uncertainty: f64) -> Option<Measured> {
    Some(Measured { value, uncertainty })
}

/// A report on 15 s of the motion with all three laws, as the core computes it.
fn report(unit: &str, seed: u64) -> FitReport {
    let friction = Friction {
        stokes: Some(Stokes::new(DAMPING).unwrap()),
        coulomb: Some(Coulomb::new(KINETIC, STATIC, NormalForce::Given(MASS * GRAVITY)).unwrap()),
        newton: Some(Newton::new(DRAG).unwrap()),
    };
    let oscillator = Oscillator::new(MOVING, STIFFNESS, friction).unwrap();
    recorded(&Motion::new(oscillator, State::new(0.2, 0.0).unwrap()).unwrap(), unit, seed)
}

fn recorded(motion: &Motion, unit: &str, seed: u64) -> FitReport {
    let mut random = Random(seed);
    let times: Vec<f64> = (0..1500).map(|i| 0.01 * f64::from(i)).collect();
    let samples = motion.samples(&times).unwrap();
    let values = samples.iter().map(|sample| sample.position + 2e-4 * random.normal()).collect();
    let recording = Recording { times, values, quantity: Quantity::Position, unit: unit.into() };
    fit(&recording, &Options::default()).expect("fits")
}

fn of(report: &FitReport, given: Given) -> Physical {
    physical(report, &given, false).expect("something is given")
}

/// Whether an estimate lies within three of its standard errors of the truth.
fn assert_near(estimate: Result<Estimate, Absent>, truth: f64, what: &str) {
    let estimate = estimate.unwrap_or_else(|absent| panic!("{what}: {absent:?}"));
    let (value, stderr) = estimate.value.zip(estimate.stderr).expect(what);
    assert!((value - truth).abs() <= 3.0 * stderr, "{what}: {value} ± {stderr}, not {truth}");
    assert!(stderr < 0.2 * truth, "{what}: {value} ± {stderr}");
    let (low, high) = estimate.interval95;
    let (low, high) = low.zip(high).expect(what);
    assert!(low <= value && value <= high && high - low > 3.0 * stderr, "{what}: {low} {high}");
}

#[test]
fn what_was_put_in_comes_back() {
    let report = report("m", 1);
    assert_eq!(report.verdict.mix, Mix { stokes: true, coulomb: true, newton: true });
    let mass = about(MASS * 1.002, 0.0005);
    let stiffness = about(STIFFNESS * 0.999, 0.02);
    let level = Some(Normal::Weight(Measured { value: GRAVITY, uncertainty: 0.0 }));
    let pressed = Some(Normal::Force(Measured { value: MASS * GRAVITY, uncertainty: 0.05 }));
    let spring_mass = about(SPRING, 0.001);
    for (mass, stiffness) in [(mass, None), (None, stiffness), (mass, stiffness)] {
        for normal in [level, pressed] {
            let found = of(&report, Given { mass, stiffness, spring_mass, normal });
            let case = format!("{mass:?} {stiffness:?} {normal:?}");
            for (estimate, truth) in [
                (found.mass, MASS),
                (found.moving_mass, MOVING),
                (found.stiffness, STIFFNESS),
                (found.damping, DAMPING),
                (found.coulomb_force, KINETIC * MASS * GRAVITY),
                (found.newton_coefficient, DRAG),
                (found.kinetic, KINETIC),
            ] {
                assert_near(estimate, truth, &case);
            }
            let (low, high) = found.static_.expect(&case).interval95;
            assert!(low.expect(&case) < STATIC && STATIC < high.expect(&case), "{low:?} {high:?}");
            assert_eq!(found.agreement.is_some(), mass.and(stiffness).is_some());
        }
    }
}

#[test]
fn without_a_spring_mass_the_weight_needs_no_mass() {
    let oscillator = |mass: f64| {
        let friction = Coulomb::new(KINETIC, KINETIC, NormalForce::Weight(GRAVITY)).unwrap();
        Oscillator::new(mass, 48.0 * mass, friction).unwrap()
    };
    let level = Some(Normal::Weight(Measured { value: GRAVITY, uncertainty: 0.0 }));
    for mass in [0.1, 7.0] {
        let motion = Motion::new(oscillator(mass), State::new(0.05, 0.0).unwrap()).unwrap();
        let report = recorded(&motion, "m", 3);
        let found = of(&report, Given { normal: level, ..Given::default() });
        assert_near(found.kinetic, KINETIC, "kinetic");
        assert_eq!(found.coulomb_force, Err(Absent::Mass));
        assert_eq!(found.mass, Err(Absent::Mass));
        assert_eq!(found.damping, Err(Absent::Law));
        // A mass changes nothing, however badly it is known.
        let with =
            of(&report, Given { normal: level, mass: about(mass, 0.3 * mass), ..Given::default() });
        let (with, without) = (with.kinetic.unwrap(), found.kinetic.unwrap());
        let close = |a: Option<f64>, b: Option<f64>| (a.unwrap() / b.unwrap() - 1.0).abs() < 1e-12;
        assert!(close(with.value, without.value) && close(with.stderr, without.stderr));
        let spring_mass = about(0.01, 0.0);
        let found = of(&report, Given { normal: level, spring_mass, ..Given::default() });
        assert_eq!(found.kinetic, Err(Absent::Mass));
    }
}

#[test]
fn each_number_that_is_not_given_has_its_reason() {
    let metres = report("m", 5);
    assert!(physical(&metres, &Given::default(), false).is_none());
    let mass = exact(MASS);
    let found = of(&metres, Given { mass, ..Given::default() });
    assert!(found.coulomb_force.is_ok() && found.newton_coefficient.is_ok());
    assert_eq!(
        (found.kinetic, found.static_),
        (Err(Absent::NormalForce), Err(Absent::NormalForce))
    );

    let normal = Some(Normal::Weight(Measured { value: GRAVITY, uncertainty: 0.0 }));
    let given = Given { mass, normal, ..Given::default() };
    for unit in ["V", "px", ""] {
        let found = of(&report(unit, 5), given);
        let length = Err(Absent::Length);
        let lengths = [found.coulomb_force, found.newton_coefficient, found.kinetic, found.static_];
        assert_eq!(lengths, [length; 4], "{unit}");
        // Stiffness and damping are forces over lengths: the unit of length drops out.
        assert_near(found.stiffness, MASS * STIFFNESS / MOVING, unit);
        assert_near(found.damping, MASS * DAMPING / MOVING, unit);
    }
    let found = of(&report("rad", 5), given);
    let all = [found.mass, found.moving_mass, found.stiffness, found.damping, found.coulomb_force];
    assert_eq!(all, [Err(Absent::Angle); 5]);
    assert_eq!((found.kinetic, found.newton_coefficient), (Err(Absent::Angle), Err(Absent::Angle)));

    let named = physical(&report("", 5), &given, true).expect("something is given");
    assert_eq!((named.stiffness, named.agreement), (Err(Absent::Angle), None));

    // More than all that moves.
    let (stiffness, spring_mass) = (exact(STIFFNESS), exact(0.9));
    let found = of(&metres, Given { stiffness, spring_mass, normal, ..Given::default() });
    assert!(found.moving_mass.is_ok());
    assert_eq!((found.mass, found.kinetic), (Err(Absent::SpringMass), Err(Absent::SpringMass)));
}

#[test]
fn a_forgotten_spring_shows_where_mass_and_stiffness_are_given() {
    let report = report("m", 9);
    let (mass, stiffness) = (about(MASS, 0.0005), about(STIFFNESS, 0.02));
    let spring_mass = about(SPRING, 0.001);
    let deviation = |given| of(&report, given).agreement.expect("both are given").deviation;
    let with = deviation(Given { mass, stiffness, spring_mass, normal: None });
    let without = deviation(Given { mass, stiffness, ..Given::default() });
    assert!(with.abs() < 3.0, "{with}");
    assert!(without > 8.0, "{without}");
}

/// The standard deviation of what `formula` makes of draws.
fn spread(formula: impl Fn(&[f64]) -> f64, draws: &[Vec<f64>]) -> f64 {
    let values: Vec<f64> = draws.iter().map(|draw| formula(draw)).collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (values.len() - 1) as f64).sqrt()
}

/// Draws of ω0, γ, a_c and κ as the fit knows them, then of these.
fn draws(report: &FitReport, given: &[Measured], count: usize) -> Vec<Vec<f64>> {
    let model = report.best().expect("a verdict has its model");
    let stderr = |i: usize| model.parameters[i].stderr.expect("known");
    let covariance =
        nalgebra::Matrix4::from_fn(|i, j| model.correlations[i][j] * stderr(i) * stderr(j));
    let factor = covariance.cholesky().expect("a covariance").l();
    let mut random = Random(17);
    let mut draw = || {
        let fresh = factor * nalgebra::Vector4::from_fn(|_, _| random.normal());
        let fitted = (0..4).map(|i| model.parameters[i].value.expect("known") + fresh[i]);
        let mut all: Vec<f64> = fitted.collect();
        all.extend(given.iter().map(|given| given.value + given.uncertainty * random.normal()));
        all
    };
    (0..count).map(|_| draw()).collect()
}

#[test]
fn uncertainties_are_the_spread_of_draws() {
    let report = report("m", 21);
    let [mass, stiffness, spring, gravity] =
        [(0.24, 0.004), (12.0, 0.2), (0.03, 0.004), (9.81, 0.2)]
            .map(|(value, uncertainty)| Measured { value, uncertainty });
    let draws = draws(&report, &[mass, stiffness, spring, gravity], 40_000);
    let normal = Some(Normal::Weight(gravity));
    let spring_mass = Some(spring);
    let by_mass = of(&report, Given { mass: Some(mass), spring_mass, normal, stiffness: None });
    let by_spring =
        of(&report, Given { stiffness: Some(stiffness), spring_mass, normal, mass: None });
    // ω0, γ, a_c, κ, m, C, m_s, g.
    let moving = |x: &[f64]| x[4] + x[6] / 3.0;
    let from_stiffness = |x: &[f64]| x[5] / x[0].powi(2);
    let body = |x: &[f64]| x[5] / x[0].powi(2) - x[6] / 3.0;
    let cases: Vec<(&str, Result<Estimate, Absent>, f64)> = vec![
        ("moving mass", by_mass.moving_mass, spread(moving, &draws)),
        ("stiffness", by_mass.stiffness, spread(|x| moving(x) * x[0] * x[0], &draws)),
        ("damping", by_mass.damping, spread(|x| 2.0 * x[1] * moving(x), &draws)),
        ("force", by_mass.coulomb_force, spread(|x| x[2] * moving(x), &draws)),
        ("drag", by_mass.newton_coefficient, spread(|x| x[3] * moving(x), &draws)),
        ("kinetic", by_mass.kinetic, spread(|x| x[2] * moving(x) / (x[4] * x[7]), &draws)),
        ("mass", by_spring.mass, spread(body, &draws)),
        ("damping by C", by_spring.damping, spread(|x| 2.0 * x[1] * from_stiffness(x), &draws)),
        ("force by C", by_spring.coulomb_force, spread(|x| x[2] * from_stiffness(x), &draws)),
        (
            "kinetic by C",
            by_spring.kinetic,
            spread(|x| x[2] * from_stiffness(x) / (body(x) * x[7]), &draws),
        ),
    ];
    for (what, estimate, spread) in cases {
        let stderr = estimate.expect(what).stderr.expect(what);
        assert!((stderr / spread - 1.0).abs() < 0.02, "{what}: {stderr}, not {spread}");
    }
}

#[test]
fn an_exact_mass_scales_the_interval_of_the_fit() {
    let report = report("m", 2);
    let rate = report.best().and_then(|model| model.parameter("damping_rate")).unwrap();
    let (low, high) = rate.interval95;
    let found = of(&report, Given { mass: exact(0.5), ..Given::default() }).damping.unwrap();
    // 2M is one.
    let (found_low, found_high) = found.interval95;
    assert!((found_low.unwrap() - low.unwrap()).abs() < 1e-12);
    assert!((found_high.unwrap() - high.unwrap()).abs() < 1e-12);
}
