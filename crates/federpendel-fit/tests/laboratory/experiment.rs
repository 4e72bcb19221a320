//! What is released, and what records it.

use federpendel::{
    Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, Sample, State, Stokes,
};
use federpendel_fit::Quantity;

use crate::synthetic::Random;

/// An experiment in SI units; a law without a coefficient does not act.
pub struct Experiment {
    /// Name of the file and, after a `#`, of the run.
    pub name: &'static str,
    pub mass: f64,
    pub stiffness: f64,
    /// D, kg/s.
    pub damping: f64,
    /// μ_k and μ_s on a level table.
    pub kinetic: f64,
    pub held: f64,
    /// ½ρc_wA, kg/m.
    pub drag: f64,
    /// Position of the release.
    pub from: f64,
    /// When the mass is let go, and what the sensor shows where it would rest.
    pub release: f64,
    pub zero: f64,
    pub quantity: Quantity,
    /// Samples a second, their number, and the standard deviation of one.
    pub rate: f64,
    pub count: usize,
    pub noise: f64,
}

/// Gravity in the laboratory, m/s².
const GRAVITY: f64 = 9.81;

const LEVEL: Experiment = Experiment {
    name: "",
    mass: 0.25,
    stiffness: 12.0,
    damping: 0.0,
    kinetic: 0.0,
    held: 0.0,
    drag: 0.0,
    from: 0.1,
    release: 1.0,
    zero: 0.0,
    quantity: Quantity::Position,
    rate: 50.0,
    count: 1000,
    noise: 1e-3,
};

/// All of them, in the order of the files.
pub const EXPERIMENTS: [Experiment; 7] = [
    // A telephone hangs on a spring and swings in the air.
    Experiment {
        name: "phyphox.csv",
        damping: 0.05,
        drag: 0.02,
        from: 0.15,
        quantity: Quantity::Acceleration,
        rate: 100.0,
        count: 2000,
        noise: 0.03,
        zero: 0.02,
        ..LEVEL
    },
    // The same with a sheet of cardboard on it, exported by a German telephone.
    Experiment {
        name: "phyphox-deutsch.zip",
        drag: 0.35,
        from: 0.15,
        quantity: Quantity::Acceleration,
        rate: 100.0,
        count: 2000,
        noise: 0.03,
        zero: -0.01,
        ..LEVEL
    },
    // A block on a table, filmed, until it stops.
    Experiment {
        name: "tracker.txt",
        kinetic: 0.05,
        held: 0.07,
        rate: 30.0,
        count: 300,
        zero: 0.31,
        ..LEVEL
    },
    // A cart on a track in front of a motion detector.
    Experiment {
        name: "vernier.csv",
        mass: 0.5,
        stiffness: 8.0,
        damping: 0.04,
        kinetic: 0.004,
        held: 0.006,
        from: 0.2,
        rate: 25.0,
        count: 750,
        zero: 0.62,
        ..LEVEL
    },
    // A sphere in water, released twice.
    Experiment { name: "pasco.csv#Run #1", mass: 0.3, drag: 0.4, from: 0.12, zero: 0.4, ..LEVEL },
    Experiment {
        name: "pasco.csv#Run #2",
        mass: 0.3,
        drag: 0.4,
        from: 0.06,
        zero: 0.4,
        release: 1.5,
        ..LEVEL
    },
    // All three at once, the velocity recorded.
    Experiment {
        name: "federpendel-deutsch.csv",
        mass: 0.5,
        stiffness: 20.0,
        damping: 0.04,
        kinetic: 0.006,
        held: 0.006,
        drag: 0.3,
        from: 0.25,
        release: 0.0,
        quantity: Quantity::Velocity,
        count: 1500,
        noise: 4e-3,
        ..LEVEL
    },
];

impl Experiment {
    /// The file it goes to.
    pub fn file(&self) -> &'static str {
        self.name.split('#').next().unwrap_or_default()
    }

    /// What the sensor records: times (s) and values.
    pub fn record(&self, seed: u64) -> federpendel::Result<Vec<(f64, f64)>> {
        let motion = self.motion()?;
        let mut random = Random(seed);
        let mut row = |i: usize| {
            let time = i as f64 / self.rate;
            // Held by a hand until it is let go.
            let value = match time < self.release {
                true if self.quantity == Quantity::Position => self.from,
                true => 0.0,
                false => self.quantity_of(&motion.at(time - self.release)?),
            };
            Ok((time, self.zero + value + self.noise * random.normal()))
        };
        (0..self.count).map(&mut row).collect()
    }

    fn motion(&self) -> federpendel::Result<Motion> {
        let friction = Friction {
            stokes: Some(Stokes::new(self.damping)?),
            coulomb: Some(Coulomb::new(self.kinetic, self.held, NormalForce::Weight(GRAVITY))?),
            newton: Some(Newton::new(self.drag)?),
        };
        let oscillator = Oscillator::new(self.mass, self.stiffness, friction)?;
        Motion::new(oscillator, State::new(self.from, 0.0)?)
    }

    fn quantity_of(&self, sample: &Sample) -> f64 {
        match self.quantity {
            Quantity::Position => sample.position,
            Quantity::Velocity => sample.velocity,
            Quantity::Acceleration => sample.acceleration,
        }
    }

    /// The true coefficients in reduced units: ω₀, γ, a_c, κ.
    pub fn truth(&self) -> [f64; 4] {
        [
            (self.stiffness / self.mass).sqrt(),
            self.damping / (2.0 * self.mass),
            self.kinetic * GRAVITY,
            self.drag / self.mass,
        ]
    }
}
