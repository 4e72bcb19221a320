//! Random recordings of known motions, made by `federpendel::Motion` and a generator of random numbers.

#![allow(dead_code)] // Each test needs some of it.

use std::f64::consts::PI;

use federpendel::{Mix, Result};
use federpendel_fit::{Parameters, Quantity, Recording};

/// xorshift64* (Vigna 2016).
pub struct Random(pub u64);

impl Random {
    /// Even between 0 and 1.
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Even between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Even in the logarithm.
    pub fn scale(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// Normal with variance 1 (Box & Muller).
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        radius * (2.0 * PI * self.unit()).cos()
    }
}

/// A recording and the motion in it.
pub struct Known {
    pub recording: Recording,
    /// The truth; `position0` and `velocity0` at `release`.
    pub truth: Parameters,
    pub static_acceleration: f64,
    pub mix: Mix,
    /// Index of the first value of the free motion.
    pub release: usize,
    /// Standard deviation of the noise.
    pub sigma: f64,
    /// What was added to the true values.
    pub noise: Vec<f64>,
    /// Number of turning points until rest, if it rests within the recording.
    pub rests: Option<u64>,
}

/// A random recording; `correlation` is that of neighbouring values of the noise.
pub fn known(random: &mut Random, correlation: f64) -> Result<Known> {
    known_of(random, correlation, None)
}

/// As [`known`], of so many samples.
pub fn known_of(random: &mut Random, correlation: f64, samples: Option<usize>) -> Result<Known> {
    let bits = (random.unit() * 8.0) as u8;
    let mix = Mix { stokes: bits & 1 > 0, coulomb: bits & 2 > 0, newton: bits & 4 > 0 };
    let swings = random.scale(5.0, 60.0).round();
    let drawn = random.scale(300.0, 5000.0) as usize;
    let samples = samples.unwrap_or(drawn);
    let (omega, amplitude) = (random.scale(0.5, 50.0), random.scale(0.01, 10.0));
    let half = PI / omega;
    let mut weights = [mix.stokes, mix.coulomb, mix.newton]
        .map(|acts| if acts { random.between(0.1, 1.0) } else { 0.0 });
    let sum = weights.iter().sum::<f64>().max(1e-9);
    weights.iter_mut().for_each(|w| *w /= sum);
    let loss = random.between(0.4, 2.5);
    let resting = mix.coulomb && random.chance(0.6);
    let dry = if resting { random.between(0.4, 1.0) } else { random.between(0.1, 0.45) };
    let phase = random.between(-PI, PI);
    let held = random.chance(0.3);
    let side = if random.chance(0.5) { amplitude } else { -amplitude };
    let mut truth = Parameters {
        angular_frequency: omega,
        damping_rate: weights[0] * loss * omega / (PI * swings),
        coulomb_acceleration: if mix.coulomb {
            (if resting { dry } else { dry * weights[1] }) * amplitude * omega * omega
                / (2.0 * swings)
        } else {
            0.0
        },
        newton_rate: weights[2] * loss * 1.5 * 0.75 / (amplitude * swings),
        position0: if held { side } else { amplitude * phase.cos() },
        velocity0: if held { 0.0 } else { -amplitude * omega * phase.sin() },
        equilibrium: 0.0,
    };
    let quantity = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration]
        [(random.unit() * 3.0) as usize];
    let scale = match quantity {
        Quantity::Position => amplitude,
        Quantity::Velocity => amplitude * omega,
        Quantity::Acceleration => amplitude * omega * omega,
    };
    truth.equilibrium = random.between(-2.0, 2.0) * scale;
    let factor = if random.chance(0.5) { 1.0 } else { random.between(1.0, 1.5) };
    let static_acceleration = factor * truth.coulomb_acceleration;
    let hold = if held { random.between(0.5, 3.0) * half } else { 0.0 };
    // Not whole swings, else the last value of some would lie right on a turning point.
    let duration = hold + (swings - random.between(0.1, 0.9)) * half;
    let clock = random.between(-10.0, 10.0) * half;
    let times: Vec<f64> =
        (0..samples).map(|i| clock + duration * i as f64 / (samples - 1) as f64).collect();
    let release_time = clock + hold;
    let motion = truth.motion(static_acceleration)?;
    let sigma = random.scale(0.001, 0.02) * scale;
    let (mut noise, mut before) = (Vec::new(), 0.0);
    for _ in 0..samples {
        let fresh = (1.0 - correlation * correlation).sqrt() * random.normal();
        before = correlation * before + fresh;
        noise.push(sigma * before);
    }
    let mut values = Vec::new();
    let since: Vec<f64> = times.iter().map(|time| (time - release_time).max(0.0)).collect();
    for ((&time, noise), sample) in times.iter().zip(&noise).zip(motion.samples(&since)?) {
        let waits = time < release_time;
        let value = match quantity {
            Quantity::Position => sample.position,
            _ if waits => 0.0,
            Quantity::Velocity => sample.velocity,
            Quantity::Acceleration => sample.acceleration,
        };
        values.push(truth.equilibrium + value + noise);
    }
    let release = times.partition_point(|&t| t < release_time);
    let end = times[samples - 1] - release_time;
    let mut turns = motion.turning_points();
    let within = turns.by_ref().take_while(|point| point.time < end).count() as u64;
    let rests = (mix.coulomb && motion.at(end)?.mode == federpendel::Mode::Stuck).then_some(within);
    // The truth as seen from the first free value.
    let first = motion.at((times[release] - release_time).max(0.0))?;
    (truth.position0, truth.velocity0) = (first.position, first.velocity);
    let recording = Recording { times, values, quantity, unit: String::new() };
    Ok(Known { recording, truth, static_acceleration, mix, release, sigma, noise, rests })
}
