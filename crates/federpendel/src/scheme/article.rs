//! The article's difference scheme: (51) with the start (54), (59) with (60), (85) with (86).
//!
//! On the grid t_i = i Δt the quotients (48) q_i = (x_i − x_{i−1})/Δt and (49) turn the equation of
//! motion into
//!
//! x_{i+1} = 2x_i − x_{i−1} − Δt² (C/m x_i + D/m q_i + sign(q_i) μF_N/m + sign(q_i) ½ρc_wA/m q_i²),
//!
//! started by x_1 = x_0 + v_0 Δt − Δt²/2 (…) with the same bracket at x_0, v_0. Every law that acts
//! adds its term, so that the article's three cases extend to any mix. sign(0) = 0, as printed.
//!
//! What the article does not say: the backward quotient makes the scheme first order in Δt, second
//! order only without friction; it has a stability limit; and having no static friction it never
//! comes to rest but chatters and creeps back to x = 0. The static coefficient has no effect here.

mod integration;
mod stability;
mod terms;
mod walk;

pub use self::integration::SCHEME;
pub use self::walk::Walk;

use self::terms::{Pair, Terms};
use crate::article::direction;
use crate::error::{Error, Result};
use crate::friction::Mix;
use crate::motion::Sample;
use crate::oscillator::{Oscillator, State};
use crate::parameter;

/// Most steps that [`Scheme::sample`] takes, some minutes of work.
pub const MAX_STEPS: u64 = 10_000_000_000;

/// Most steps that [`Scheme::run`] keeps, 0.8 GB.
pub const MAX_STORED: u64 = 100_000_000;

/// Steps between two looks at whether the numbers are still finite.
const CHUNK: usize = 1 << 14;

/// A time within this many roundings of a step counts as on the grid.
const GRID_TOLERANCE: f64 = 8.0 * f64::EPSILON;

/// The scheme for one oscillator, release and time step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scheme {
    release: State,
    mix: Mix,
    terms: Terms,
    first: f64,
}

/// One step of the scheme.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Number i of the step; 0 is the release.
    pub index: u64,
    /// Time i Δt, s.
    pub time: f64,
    /// Position x_i, m.
    pub position: f64,
    /// Backward quotient (48) (x_i − x_{i−1})/Δt, m/s, which lags by Δt/2; at the release v0.
    pub velocity: f64,
    /// The acceleration that the scheme gives this step, m/s²: minus its bracket.
    pub acceleration: f64,
}

/// The scheme at given times.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    /// One sample for each time, in the order of the times.
    pub samples: Vec<Sample>,
    /// Whether a time lies between two steps, so that its sample is interpolated.
    pub interpolated: bool,
}

impl Scheme {
    /// The time step that is taken when none is given: a thousandth of the period, s.
    ///
    /// Where Stokes friction makes the period longer than two undamped ones, or there is none, it
    /// is a thousandth of the undamped period 2π/ω0: a period that grows beyond bounds near
    /// critical damping is no measure for a step. Above γ ≈ 160 ω0 the scheme diverges with it.
    pub fn default_time_step(oscillator: &Oscillator) -> f64 {
        let undamped = 2.0 * std::f64::consts::PI / oscillator.angular_frequency();
        let period = oscillator.period().filter(|&period| period <= 2.0 * undamped);
        period.unwrap_or(undamped) / 1000.0
    }

    /// The scheme for this oscillator and release with the time step Δt > 0, s.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a time step or a release out of range, [`Error::Derived`] where Δt²
    /// overflows or underflows, [`Error::Diverged`] if the first step is not finite.
    ///
    /// ```
    /// use federpendel::scheme::article::Scheme;
    /// use federpendel::{Oscillator, State, Stokes};
    ///
    /// let oscillator = Oscillator::new(2.0, 8.0, Stokes::new(1.0)?)?;
    /// let scheme = Scheme::new(&oscillator, State::new(1.0, 0.0)?, 0.5)?;
    /// // (54): 1 − ⅛·4; (51): 2·½ − 1 − ¼(½·(−1) + 4·½)
    /// assert_eq!(scheme.run(2)?, [1.0, 0.5, -0.375]);
    /// # Ok::<(), federpendel::Error>(())
    /// ```
    pub fn new(oscillator: &Oscillator, release: State, time_step: f64) -> Result<Self> {
        parameter::TIME_STEP.check(time_step)?;
        let release = State::new(release.position, release.velocity)?;
        let terms = Terms::new(oscillator, time_step);
        let State { position, velocity } = release;
        let bracket = terms.bracket_of_any_mix(position, velocity);
        let first = position + velocity * time_step - 0.5 * terms.step_squared * bracket;
        if !(terms.step_squared.is_normal() && terms.per_step.is_normal()) {
            let (quantity, value, of) = ("dt^2", terms.step_squared, &["dt"]);
            return Err(Error::Derived { quantity, value, of });
        }
        if !first.is_finite() {
            return Err(Error::Diverged { time_step, time: time_step });
        }
        Ok(Self { release, mix: oscillator.friction().mix(), terms, first })
    }

    /// The time step Δt, s.
    pub fn time_step(&self) -> f64 {
        self.terms.time_step
    }

    /// The steps one by one, the release first; endless, or until it diverges, which is the last
    /// item as an [`Error::Diverged`].
    ///
    /// ```
    /// # use federpendel::{Friction, Oscillator, State, scheme::article::Scheme};
    /// let oscillator = Oscillator::new(1.0, 1.0, Friction::NONE)?;
    /// let scheme = Scheme::new(&oscillator, State::new(1.0, 0.0)?, 0.1)?;
    /// let step = scheme.steps().nth(10).expect("endless")?;
    /// assert_eq!(step.time, 1.0);
    /// assert!((step.position - 1f64.cos()).abs() < 1e-3);
    /// # Ok::<(), federpendel::Error>(())
    /// ```
    pub fn steps(&self) -> impl Iterator<Item = Result<Step>> + use<> {
        let scheme = *self;
        let mut index = 0;
        let mut pair = Pair { previous: f64::NAN, current: scheme.release.position };
        let mut diverged = false;
        std::iter::from_fn(move || {
            if diverged {
                return None;
            }
            let step = scheme.step(index, pair);
            diverged = step.is_err();
            pair = if index == 0 { scheme.start() } else { scheme.next(pair) };
            index += 1;
            Some(step)
        })
    }

    /// The positions x_0, x_1, … x_n, m, with n = `steps`.
    ///
    /// # Errors
    /// [`Error::TooManySteps`] above [`MAX_STORED`], [`Error::Diverged`] if it does.
    pub fn run(&self, steps: u64) -> Result<Vec<f64>> {
        self.check_steps(steps as f64 * self.time_step(), steps as f64, MAX_STORED)?;
        let mut positions = vec![0.0; steps as usize + 1];
        self.fill(&mut positions)?;
        Ok(positions)
    }

    /// Fills a buffer with the positions x_0, x_1, …, m: the scheme at full speed.
    ///
    /// # Errors
    /// [`Error::Diverged`] if it does; the buffer then holds nothing of use.
    pub fn fill(&self, positions: &mut [f64]) -> Result<()> {
        let mut index = 1;
        let mut pair = self.start();
        for (slot, position) in positions.iter_mut().zip([pair.previous, pair.current]) {
            *slot = position;
        }
        for chunk in positions.get_mut(2..).unwrap_or_default().chunks_mut(CHUNK) {
            let before = pair;
            let steps = chunk.len() as u64;
            pair = self.march(pair, chunk.iter_mut(), |slot, position| *slot = position);
            self.check_finite(index, before, pair)?;
            index += steps;
        }
        Ok(())
    }

    /// The scheme at `times` ≥ 0 (s), in any order. Between two steps position, velocity and
    /// acceleration are interpolated linearly, and the result says so. On a step they are as in
    /// [`Step`].
    ///
    /// # Errors
    /// [`Error::Parameter`] for a time that is negative, NaN or infinite; [`Error::TooManySteps`] for
    /// one beyond [`MAX_STEPS`]; [`Error::Diverged`] if the scheme diverges until the last of them.
    ///
    /// ```
    /// # use federpendel::{Friction, Oscillator, State, scheme::article::Scheme};
    /// let oscillator = Oscillator::new(1.0, 1.0, Friction::NONE)?;
    /// let scheme = Scheme::new(&oscillator, State::new(1.0, 0.0)?, 0.1)?;
    /// assert!(!scheme.sample(&[0.0, 0.3, 7.0])?.interpolated);
    /// assert!(scheme.sample(&[0.25])?.interpolated);
    /// # Ok::<(), federpendel::Error>(())
    /// ```
    pub fn sample(&self, times: &[f64]) -> Result<Samples> {
        for &time in times {
            parameter::TIME.check(time)?;
            self.check_steps(time, time * self.terms.per_step, MAX_STEPS)?;
        }
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|&a, &b| times[a].total_cmp(&times[b]));
        let blank = self.step(0, self.start())?.sample(0.0);
        let mut samples = vec![blank; times.len()];
        let mut walk = self.walk();
        for place in order {
            samples[place] = walk.sample(times[place])?;
        }
        Ok(Samples { samples, interpolated: walk.interpolated() })
    }

    /// The step at or below a time, and how far beyond it the time lies, in steps.
    fn grid_place(&self, time: f64) -> (u64, f64) {
        let steps = time / self.time_step();
        let nearest = steps.round();
        if (steps - nearest).abs() <= GRID_TOLERANCE * nearest.max(1.0) {
            (nearest as u64, 0.0)
        } else {
            (steps as u64, steps.fract())
        }
    }

    fn check_steps(&self, time: f64, steps: f64, limit: u64) -> Result<()> {
        if steps <= limit as f64 {
            Ok(())
        } else {
            Err(Error::TooManySteps { time, time_step: self.time_step(), steps, limit })
        }
    }

    /// x_0 and x_1.
    fn start(&self) -> Pair {
        Pair { previous: self.release.position, current: self.first }
    }

    /// What the scheme says at step `index`, whose pair this is (any pair at the release).
    fn step(&self, index: u64, pair: Pair) -> Result<Step> {
        let State { position, velocity } = if index == 0 {
            self.release
        } else {
            let velocity = (pair.current - pair.previous) * self.terms.per_step;
            State { position: pair.current, velocity }
        };
        let acceleration = -self.terms.bracket_of_any_mix(position, velocity);
        let time = index as f64 * self.time_step();
        if position.is_finite() && velocity.is_finite() && acceleration.is_finite() {
            Ok(Step { index, time, position, velocity, acceleration })
        } else {
            Err(Error::Diverged { time_step: self.time_step(), time })
        }
    }

    /// Goes from step `index` with this pair to step `target`.
    fn follow(&self, mut index: u64, mut pair: Pair, target: u64) -> Result<Pair> {
        while index < target {
            let steps = (target - index).min(CHUNK as u64);
            let before = pair;
            pair = self.march(pair, 0..steps, |_, _| ());
            self.check_finite(index, before, pair)?;
            index += steps;
        }
        Ok(pair)
    }

    /// Whether the steps after step `index`, from the pair `before` to `after`, stayed finite; the
    /// error says when they first did not.
    fn check_finite(&self, mut index: u64, before: Pair, after: Pair) -> Result<()> {
        // Once a position is not finite, none that follows is: the last one tells.
        if after.current.is_finite() {
            return Ok(());
        }
        let mut pair = before;
        while pair.current.is_finite() {
            pair = self.next(pair);
            index += 1;
        }
        let time_step = self.time_step();
        Err(Error::Diverged { time_step, time: index as f64 * time_step })
    }

    /// One step on.
    fn next(&self, pair: Pair) -> Pair {
        self.march(pair, 0..1, |_, _| ())
    }

    /// One step for each of `slots`; each mix has a loop of its own that holds only its terms.
    fn march<Slot>(
        &self,
        pair: Pair,
        slots: impl Iterator<Item = Slot>,
        record: impl Fn(Slot, f64),
    ) -> Pair {
        macro_rules! loops {
            ($($stokes:literal $coulomb:literal $newton:literal),*) => {
                match self.mix {
                    $(Mix { stokes: $stokes, coulomb: $coulomb, newton: $newton } => {
                        self.terms.march::<$stokes, $coulomb, $newton, _>(pair, slots, record)
                    })*
                }
            };
        }
        loops!(
            false false false, true false false, false true false, false false true,
            true true false, true false true, false true true, true true true
        )
    }
}

impl Step {
    /// The point on the line from here to `next`; `fraction` runs from 0 to 1.
    fn towards(self, next: Step, fraction: f64) -> Step {
        let mix = |a: f64, b: f64| a + fraction * (b - a);
        Step {
            index: self.index,
            time: mix(self.time, next.time),
            position: mix(self.position, next.position),
            velocity: mix(self.velocity, next.velocity),
            acceleration: mix(self.acceleration, next.acceleration),
        }
    }

    /// The step as a sample at `time`, s.
    fn sample(self, time: f64) -> Sample {
        let Step { position, velocity, acceleration, .. } = self;
        Sample { time, position, velocity, acceleration, mode: direction(velocity, acceleration) }
    }
}
