//! The energy ledger: where the energy of the release is, and what each law turned into heat.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;
use twofloat::TwoFloat;

use crate::chain::cursor::Cursor;
use crate::chain::linear::LinearChain;
use crate::error::{Error, Result};
use crate::motion::Motion;
use crate::oscillator::State;
use crate::parameter;

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
    rule: GaussLegendre,
    /// Time up to which the work is known, s, and the same within the swing, ω0 t.
    time: f64,
    tau: f64,
    work: Work,
}

/// The three work integrals; in double-double, because there can be millions of swings.
#[derive(Debug, Clone, Copy, Default)]
struct Work {
    /// ∫ w² dτ, m².
    square: TwoFloat,
    /// ∫ |w| dτ, the path, m.
    path: TwoFloat,
    /// ∫ |w|³ dτ, m³.
    cube: TwoFloat,
}

impl<'m> Account<'m> {
    fn new(motion: &'m Motion) -> Self {
        let rule = GaussLegendre::new(NODES);
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
            self.finish_swing();
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

    fn finish_swing(&mut self) {
        self.add_until(self.cursor.duration());
        self.cursor.advance();
        self.tau = 0.0;
    }

    /// In closed form any number of swings from rest is passed at once.
    fn skip_swings(&mut self, time: f64) -> Result<()> {
        let start = *self.cursor.start();
        let Some(chain) = self.cursor.linear().filter(|_| start.w == 0.0 && !start.rests()) else {
            return Ok(());
        };
        let (Some(duration), chain) = (chain.repeat_duration(), *chain) else { return Ok(()) };
        let mut last = start;
        self.cursor.seek(self.motion.chain(), time).map(|()| last = *self.cursor.start())?;
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
        let zeta = self.motion.oscillator().reduced().zeta.hi();
        let mut add = |from: f64, to: f64| {
            let half = 0.5 * (to - from);
            let (mut squares, mut cubes) = (0.0, 0.0);
            for (node, weight) in self.rule.iter() {
                let (_, w) = cursor.framed_at(from + half * (1.0 + node));
                let square = weight * half * w * w;
                squares += square;
                cubes += square * w.abs();
            }
            self.work.square += squares;
            self.work.cube += cubes;
        };
        match cursor.linear() {
            Some(_) => panels(self.tau, tau, zeta).for_each(|(from, to)| add(from, to)),
            None => {
                let starts = cursor.pieces().iter().map(|piece| piece.start).skip(1);
                let mut from = self.tau;
                for to in starts.chain([tau]) {
                    if to > from {
                        add(from, to.min(tau));
                        from = to.min(tau);
                    }
                }
            }
        }
    }
}

/// Nodes of the quadrature: exact for polynomials of degree 47, more than w² of any piece needs.
const NODES: NonZeroUsize = NonZeroUsize::new(24).unwrap();

/// Cuts a stretch of a linear swing into panels on which the quadrature is exact to rounding. With
/// damping they grow with the time since the swing began: what is fast has died away by then.
fn panels(from: f64, to: f64, zeta: f64) -> impl Iterator<Item = (f64, f64)> {
    let mut at = from;
    std::iter::from_fn(move || {
        let length = if zeta < 0.5 { 1.0 } else { (0.5 / zeta).max(0.5 * at) };
        let panel = (at, (at + length).min(to));
        at = panel.1;
        (panel.0 < to).then_some(panel)
    })
}
