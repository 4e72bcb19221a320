//! The energy ledger: where the energy of the release is, and what each law turned into heat.

use crate::chain::cursor::Cursor;
use crate::chain::linear::LinearChain;
use crate::double::Double;
use crate::error::{Error, Result};
use crate::motion::Motion;
use crate::oscillator::State;
use crate::parameter;
use crate::quadrature::Quadrature;

/// Heat made by each law since the release, J. Each from its own work integral.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Heat {
    /// ∫ D v² dt.
    pub stokes: f64,
    /// ∫ μ F_N |v| dt.
    pub coulomb: f64,
    /// ∫ ½ρc_wA |v|³ dt.
    pub newton: f64,
}

impl Heat {
    /// Heat of all laws together, J.
    pub fn total(&self) -> f64 {
        self.stokes + self.coulomb + self.newton
    }
}

/// Where the energy is at one time, J.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ledger {
    /// Time, s.
    pub time: f64,
    /// Kinetic energy ½mv².
    pub kinetic: f64,
    /// Potential energy ½Cx².
    pub potential: f64,
    /// Heat of each law.
    pub heat: Heat,
}

impl Motion {
    /// Energy of the release, J.
    pub fn initial_energy(&self) -> f64 {
        self.oscillator().energy(self.release())
    }

    /// The ledger at each of `times` (s), which must not fall.
    ///
    /// # Errors
    /// As [`Motion::at`]; [`Error::Order`] if a time lies before the one ahead of it.
    pub fn ledger(&self, times: &[f64]) -> Result<Vec<Ledger>> {
        let mut account = Account::new(self);
        times.iter().map(|&time| account.at(time)).collect()
    }
}

/// Adds up the heat of each law along the motion.
///
/// Works in the frame of [`crate::swing`] and in units of the stiffness: a law's heat over C is
/// ∫2ζw²dτ, f·∫|w|dτ and κ∫|w|³dτ.
struct Account<'m> {
    motion: &'m Motion,
    cursor: Cursor<'m>,
    rule: Quadrature,
    /// Time up to which the work is known, s, and the same within the swing, ω0 t.
    time: f64,
    tau: f64,
    work: Work,
}

/// The three work integrals; in double-double, because there can be millions of swings.
#[derive(Debug, Clone, Copy, Default)]
struct Work {
    /// ∫ w² dτ, m².
    square: Double,
    /// ∫ |w| dτ, the path, m.
    path: Double,
    /// ∫ |w|³ dτ, m³.
    cube: Double,
}

impl<'m> Account<'m> {
    fn new(motion: &'m Motion) -> Self {
        let oscillator = motion.oscillator();
        let (zeta, drag) =
            (oscillator.damping_ratio(), oscillator.newton_rate() * motion.amplitude());
        let light = zeta < LIGHT && drag < LIGHT_DRAG;
        let rule = if light { NODES } else { NODES_MANY };
        Account {
            motion,
            cursor: motion.cursor(true),
            rule,
            time: 0.0,
            tau: 0.0,
            work: Work::default(),
        }
    }

    fn at(&mut self, time: f64) -> Result<Ledger> {
        parameter::TIME.check(time)?;
        if time < self.time {
            return Err(Error::Order { name: "times", value: time, before: self.time });
        }
        while self.cursor.until() <= time {
            self.finish_swing(time)?;
            self.skip_swings(time)?;
        }
        let tau = self.cursor.tau(time);
        self.add_until(tau);
        (self.time, self.tau) = (time, tau);
        let sample = self.motion.sample_on(&self.cursor, time);
        Ok(self.ledger(time, sample.state()))
    }

    fn ledger(&self, time: f64, state: State) -> Ledger {
        let oscillator = self.motion.oscillator();
        let reduced = oscillator.reduced();
        let stiffness = oscillator.stiffness();
        Ledger {
            time,
            kinetic: oscillator.kinetic_energy(state),
            potential: oscillator.potential_energy(state),
            heat: Heat {
                stokes: 2.0 * reduced.zeta.hi() * stiffness * f64::from(self.work.square),
                coulomb: reduced.offset.hi() * stiffness * f64::from(self.work.path),
                newton: reduced.kappa * stiffness * f64::from(self.work.cube),
            },
        }
    }

    fn finish_swing(&mut self, time: f64) -> Result<()> {
        self.add_until(self.cursor.duration());
        self.tau = 0.0;
        self.cursor.advance_towards(time)
    }

    /// In closed form any number of swings from rest is passed at once.
    fn skip_swings(&mut self, time: f64) -> Result<()> {
        let start = *self.cursor.start();
        let Some(chain) = self.cursor.linear().filter(|_| start.w == 0.0 && !start.rests()) else {
            return Ok(());
        };
        let (Some(duration), chain) = (chain.repeat_duration(), *chain) else { return Ok(()) };
        self.cursor.seek(self.motion.chain(), time)?;
        let last = *self.cursor.start();
        let (first, second) = chain.sums(&start, last.index - start.index);
        let unit = self.integrals(&chain, duration);
        self.work.path += first * (1.0 + chain.ratio());
        self.work.square += second * unit;
        Ok(())
    }

    /// ∫ w² dτ over a swing from rest at y = 1.
    fn integrals(&self, chain: &LinearChain, duration: f64) -> f64 {
        let propagator = chain.propagator();
        let mut sum = 0.0;
        for (from, to) in panels(0.0, duration, propagator.zeta()) {
            sum += self.rule.integrate(from, to, |tau| propagator.transfer(tau).yw.powi(2));
        }
        sum
    }

    /// Adds the work from where the account stands up to `tau` in the same swing.
    fn add_until(&mut self, tau: f64) {
        if self.cursor.start().rests() || tau <= self.tau {
            return;
        }
        let cursor = &self.cursor;
        let (from, _) = cursor.framed_at(self.tau);
        let (to, _) = cursor.framed_at(tau);
        self.work.path += (from - to).abs();
        match cursor.linear() {
            Some(chain) => {
                let (y0, w0) = cursor.start().framed(self.motion.oscillator().reduced().offset);
                let (y0, propagator) = (f64::from(y0), *chain.propagator());
                for (from, to) in panels(self.tau, tau, propagator.zeta()) {
                    let velocity = |tau| propagator.state(tau, y0, w0).1;
                    self.work.add(self.rule, from, to, velocity);
                }
            }
            None => {
                let pieces = cursor.pieces();
                for (i, piece) in pieces.iter().enumerate() {
                    let end = pieces.get(i + 1).map_or(tau, |next| next.start.min(tau));
                    let from = piece.start.max(self.tau);
                    if from < end {
                        let velocity = |tau| piece.velocity_at(tau);
                        self.work.add(self.rule, from, end, velocity);
                    }
                }
            }
        }
    }
}

impl Work {
    /// Adds the integrals over a panel on which the quadrature is exact to rounding.
    fn add(&mut self, rule: Quadrature, from: f64, to: f64, velocity: impl Fn(f64) -> f64) {
        let half = 0.5 * (to - from);
        let (mut squares, mut cubes) = (0.0, 0.0);
        for (node, weight) in rule.nodes() {
            let w = velocity(from + half * (1.0 + node));
            let square = weight * w * w;
            squares += square;
            cubes += square * w.abs();
        }
        self.square += half * squares;
        self.cube += half * cubes;
    }
}

/// Damping ratio up to which a swing is like a half wave.
const LIGHT: f64 = 0.5;
/// κ times the amplitude up to which drag is like that.
const LIGHT_DRAG: f64 = 10.0;
/// Nodes for stretches of a wave not longer than π/2, and of half the radius of a Taylor series: with light
/// drag the cube of the velocity beyond degree 23 is below rounding there.
const NODES: Quadrature = Quadrature::FEW;
/// Nodes where exponentials die away within a panel, for the high polynomials of collocation, and where strong
/// drag takes most of the velocity within one piece of a series.
const NODES_MANY: Quadrature = Quadrature::MANY;

/// Cuts a stretch of a linear swing into panels on which the quadrature is exact to rounding. With
/// damping they grow with the time since the swing began: what is fast has died away by then.
fn panels(from: f64, to: f64, zeta: f64) -> impl Iterator<Item = (f64, f64)> {
    let mut at = from;
    std::iter::from_fn(move || {
        let length = if zeta < LIGHT { 1.0 } else { (0.5 / zeta).max(0.5 * at) };
        let panel = (at, (at + length).min(to));
        at = panel.1;
        (panel.0 < to).then_some(panel)
    })
}
