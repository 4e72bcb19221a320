//! Plans held to their promises: recordings as planned, made by `federpendel::Motion`, and fitted from a cold start.

#![allow(dead_code)] // Each user needs some of it.

use federpendel::{
    Coulomb, Friction, Mix, Motion, Newton, NormalForce, Oscillator, Result, State, Stokes,
};
use federpendel_fit::plan::{Law, Setup};
use federpendel_fit::{Intervals, Laws, Options, Quantity, Recording, Standing, fit};

use super::synthetic::Random;

/// An experiment of half a kilogram on 20 N/m with friction: D in kg/s, μ and μ_s under its weight, ½ρc_wA in kg/m.
pub struct Experiment {
    pub name: &'static str,
    pub friction: [f64; 4],
    pub quantity: Quantity,
    /// Standard deviation of a value, SI.
    pub noise: f64,
    /// Values per second.
    pub rate: f64,
    /// The largest amplitude, m.
    pub to: f64,
    /// The longest recording, s.
    pub longest: Option<f64>,
    /// Laws that are fitted besides those that act.
    pub also: Mix,
}

const NONE: Mix = Mix { stokes: false, coulomb: false, newton: false };
const ALL: Mix = Mix { stokes: true, coulomb: true, newton: true };

/// Experiments of all kinds: one law to three, all quantities, fitted with the laws that act or with all.
#[rustfmt::skip]
pub const EXPERIMENTS: [Experiment; 8] = [
    Experiment { name: "Stokes", friction: [0.006, 0.0, 0.0, 0.0], quantity: Quantity::Position, noise: 5e-3, rate: 20.0, to: 0.4, longest: Some(10.0), also: NONE },
    Experiment { name: "Coulomb", friction: [0.0, 0.004, 0.005, 0.0], quantity: Quantity::Position, noise: 2e-3, rate: 30.0, to: 0.1, longest: None, also: NONE },
    Experiment { name: "Coulomb, all fitted", friction: [0.0, 0.004, 0.004, 0.0], quantity: Quantity::Position, noise: 1e-3, rate: 50.0, to: 0.1, longest: None, also: ALL },
    Experiment { name: "Newton, all fitted", friction: [0.0, 0.0, 0.0, 0.2], quantity: Quantity::Position, noise: 2e-3, rate: 50.0, to: 0.3, longest: None, also: ALL },
    Experiment { name: "Stokes, Newton", friction: [0.03, 0.0, 0.0, 0.15], quantity: Quantity::Position, noise: 1e-3, rate: 50.0, to: 0.3, longest: None, also: NONE },
    Experiment { name: "all three", friction: [0.05, 0.002, 0.003, 0.235], quantity: Quantity::Position, noise: 1e-3, rate: 50.0, to: 0.3, longest: None, also: NONE },
    Experiment { name: "Stokes, Coulomb", friction: [0.05, 0.002, 0.002, 0.0], quantity: Quantity::Velocity, noise: 5e-3, rate: 50.0, to: 0.1, longest: None, also: NONE },
    Experiment { name: "Stokes, Newton", friction: [0.03, 0.0, 0.0, 0.15], quantity: Quantity::Acceleration, noise: 0.05, rate: 100.0, to: 0.3, longest: None, also: NONE },
];

impl Experiment {
    pub fn oscillator(&self) -> Result<Oscillator> {
        let [damping, kinetic, held, drag] = self.friction;
        let friction = Friction {
            stokes: Some(Stokes::new(damping)?),
            coulomb: Some(Coulomb::new(kinetic, held, NormalForce::Weight(9.81))?),
            newton: Some(Newton::new(drag)?),
        };
        Oscillator::new(0.5, 20.0, friction)
    }

    pub fn setup(&self) -> Result<Setup> {
        let &Experiment { quantity, noise, rate, to, longest, also, .. } = self;
        let oscillator = self.oscillator()?;
        Ok(Setup {
            oscillator,
            also,
            quantity,
            noise,
            rate,
            min_amplitude: None,
            max_amplitude: to,
            longest,
        })
    }
}

/// What fits of many recordings found of one law.
#[derive(Debug, Default)]
pub struct Found {
    /// The fitted coefficients.
    pub coefficients: Vec<f64>,
    /// How many verdicts named the law.
    pub named: usize,
    /// How many recordings there were.
    pub recordings: usize,
}

impl Found {
    pub fn mean(&self) -> f64 {
        self.coefficients.iter().sum::<f64>() / self.coefficients.len() as f64
    }

    /// Root mean square distance from the truth.
    pub fn spread(&self, truth: f64) -> f64 {
        let squares = self.coefficients.iter().map(|found| (found - truth).powi(2));
        (squares.sum::<f64>() / self.coefficients.len() as f64).sqrt()
    }

    pub fn share_named(&self) -> f64 {
        self.named as f64 / self.recordings as f64
    }
}

/// Fits `count` recordings of this length after releases from this amplitude.
pub fn record_and_fit(
    setup: &Setup,
    law: Law,
    (amplitude, duration): (f64, f64),
    count: usize,
    random: &mut Random,
) -> Result<Found> {
    let motion = Motion::new(setup.oscillator, State::new(amplitude, 0.0)?)?;
    let times: Vec<f64> =
        (0..).map(|i| f64::from(i) / setup.rate).take_while(|&time| time <= duration).collect();
    let exact: Vec<f64> = motion
        .samples(&times)?
        .into_iter()
        .map(|sample| match setup.quantity {
            Quantity::Position => sample.position,
            Quantity::Velocity => sample.velocity,
            Quantity::Acceleration => sample.acceleration,
        })
        .collect();
    let laws = setup.fitted();
    let options =
        Options { laws: Laws::Among(laws), intervals: Intervals::Covariance, ..Options::default() };
    let mut found = Found { recordings: count, ..Found::default() };
    for _ in 0..count {
        // Where the sensor has its zero is nobody's choice.
        let zero = random.between(-0.5, 0.5) * amplitude;
        let values = exact.iter().map(|x| zero + x + setup.noise * random.normal()).collect();
        let (times, unit) = (times.clone(), String::new());
        let recording = Recording { times, values, quantity: setup.quantity, unit };
        // A recording that cannot be fitted names no law.
        let Ok(report) = fit(&recording, &options) else { continue };
        found.named += usize::from(report.verdict.laws[law as usize] == Standing::Acts);
        let model = report.model(laws).and_then(|model| model.parameter(law.parameter()));
        found.coefficients.extend(model.and_then(|parameter| parameter.value));
    }
    Ok(found)
}
