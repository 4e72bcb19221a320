//! The chain without Newton friction: every swing at once, in closed form.

use crate::chain::Start;
use crate::double::{Double, PI};
use crate::oscillator::Reduced;
use crate::sticking::Sticking;
use crate::swing::linear::Propagator;

/// Beyond so many swings the time of one is lost in double-double.
pub(crate) const MOST_SWINGS: u64 = 1 << 53;

/// The swings from one start on: at most one from a state in motion, then all others from rest.
///
/// From rest at distance a from the centre, Coulomb friction and damping lead to
/// a' = r (a − f) − f at the next turning point, with r = e^(−q), q = πζ/√(1 − ζ²): an affine map, of which
/// any number of repetitions is in closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LinearChain {
    reduced: Reduced,
    sticking: Sticking,
    propagator: Propagator,
    /// Bound on the error of a turning point, m.
    error: f64,
    first: Start,
    /// First start from rest, `first` itself or the next; none if the velocity never vanishes.
    rest_start: Option<Start>,
    /// What a swing from rest repeats, where the linear part swings.
    repeat: Option<Repeat>,
    last: Last,
}

/// A swing from rest of a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Repeat {
    duration: Double,
    /// q = ζ·duration.
    decrement: Double,
    /// f (1 + r): taken off with every swing.
    loss: Double,
    /// 1 − r.
    fall: f64,
    /// √r.
    half_ratio: f64,
}

/// The turning point at which a chain ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Last {
    /// The mass sticks at the turning point of this index.
    At(u64),
    /// It never rests.
    Never,
    /// Not before [`MOST_SWINGS`].
    Beyond,
}

impl LinearChain {
    /// The chain from `first`; `error` bounds the error that its state brings along, m.
    pub fn new(reduced: &Reduced, sticking: &Sticking, first: Start, error: f64) -> Self {
        let discriminant = reduced.discriminant();
        let repeat = (discriminant.hi() > 0.0).then(|| {
            let duration = PI / discriminant.sqrt();
            let decrement = duration * reduced.zeta;
            let fall = -(-decrement.hi()).exp_m1();
            let half_ratio = (-0.5 * decrement.hi()).exp();
            Repeat { duration, decrement, loss: reduced.offset * (2.0 - fall), fall, half_ratio }
        });
        let mut chain = LinearChain {
            reduced: *reduced,
            sticking: *sticking,
            propagator: Propagator::new(reduced.zeta.into(), discriminant.into()),
            error,
            first,
            rest_start: None,
            repeat,
            last: Last::Never,
        };
        chain.rest_start = chain.first_from_rest();
        chain.last = chain.find_last();
        chain
    }

    pub fn propagator(&self) -> &Propagator {
        &self.propagator
    }

    pub fn first(&self) -> Start {
        self.first
    }

    pub fn last(&self) -> Last {
        self.last
    }

    /// Until when, s, one formula holds for all swings: until the rest, if no dry friction moves their centres, else
    /// not at all.
    pub fn formula_until(&self) -> f64 {
        match self.last {
            _ if self.reduced.offset.hi() > 0.0 => 0.0,
            Last::At(index) => self.start(index).time(&self.reduced),
            Last::Never | Last::Beyond => f64::INFINITY,
        }
    }

    /// Duration of a swing from rest, ω0 t.
    pub fn repeat_duration(&self) -> Option<f64> {
        self.repeat.map(|repeat| repeat.duration.into())
    }

    /// Duration of a swing from rest, ω0 t, and the factor e^(−q/2) of its first half.
    pub fn wave(&self) -> Option<(f64, f64)> {
        self.repeat.map(|repeat| (repeat.duration.into(), repeat.half_ratio))
    }

    /// Factor e^(−q) between the ends of a swing from rest, measured from its own centre; zero where it
    /// does not end.
    pub fn ratio(&self) -> Double {
        self.repeat.map_or(0.0.into(), |repeat| (-repeat.decrement).exp())
    }

    /// ΣY and ΣY² over `count` swings from rest, the first from `start`, with Y the distance of each start
    /// from the centre of its swing.
    ///
    /// Y' = rY − 2f, so Y after n swings and both sums are polynomials in Y; those of 2n swings follow from
    /// those of n, and no term cancels on the way.
    pub fn sums(&self, start: &Start, count: u64) -> (Double, Double) {
        let (y, _) = start.framed(self.reduced.offset);
        let mut power = SwingSums::one(self.ratio(), self.reduced.offset);
        let mut total = SwingSums::none();
        let mut left = count;
        while left > 0 {
            if left & 1 == 1 {
                total = total.then(&power);
            }
            power = power.then(&power);
            left >>= 1;
        }
        total.at(y)
    }

    fn first_from_rest(&self) -> Option<Start> {
        if self.first.w == 0.0 {
            return Some(self.first);
        }
        let (y0, w0) = self.first.framed(self.reduced.offset);
        let duration = self.propagator.time_to_reversal(y0.into(), w0)?;
        let (y, _) = self.propagator.state(duration, y0.into(), w0);
        let offset = self.reduced.offset;
        Some(self.first.turn(duration.into(), y.into(), offset, &self.sticking, self.error))
    }

    /// Signed distance from the centre after `count` swings from rest at distance `a`: negative if
    /// the mass did not get past the centre.
    fn distance(&self, a: Double, count: u64) -> Double {
        let Some(Repeat { decrement, loss, fall, .. }) = self.repeat else { return a };
        let count = count as f64;
        if fall == 0.0 {
            return a - loss * count;
        }
        let exponent = decrement * count;
        // e^(−nq) with the low part of the exponent, and (1 − e^(−nq))/(1 − e^(−q)).
        let power = Double::from((-exponent.hi()).exp()) * (1.0 - exponent.lo());
        if loss.hi() == 0.0 {
            return power * a;
        }
        let geometric = -(-exponent.hi()).exp_m1() / fall;
        power * a - loss * geometric
    }

    /// The start of index `index`, which the chain must have.
    pub fn start(&self, index: u64) -> Start {
        let Some(rest_start) = self.rest_start.filter(|start| start.index <= index) else {
            return self.first;
        };
        let count = index - rest_start.index;
        let (Some(Repeat { duration, .. }), 1..) = (self.repeat, count) else { return rest_start };
        let side = if count.is_multiple_of(2) { 1.0 } else { -1.0 } * rest_start.x.hi().signum();
        let x = side * self.distance(rest_start.x.abs(), count);
        let direction = if self.last == Last::At(index) { 0.0 } else { -side };
        let (tau, error) = (rest_start.tau + duration * count as f64, self.error);
        Start { index, tau, x, w: 0.0, direction, error }
    }

    /// The start after `start`; `None` if that one lasts for ever.
    pub fn next(&self, start: &Start) -> Option<Start> {
        let turns = match self.rest_start {
            None => false,
            Some(rest_start) if start.index < rest_start.index => true,
            Some(_) => self.repeat.is_some(),
        };
        (turns && !start.rests() && start.index < MOST_SWINGS).then(|| self.start(start.index + 1))
    }

    /// Index of the swing that holds the time `time` (s), at which ω0 t is `tau`; `None` beyond
    /// [`MOST_SWINGS`].
    pub fn index_at(&self, time: f64, tau: Double) -> Option<u64> {
        let Some(rest_start) = self.rest_start else { return Some(self.first.index) };
        if time < rest_start.time(&self.reduced) {
            return Some(self.first.index);
        }
        let (Some(Repeat { duration, .. }), false) = (self.repeat, rest_start.rests()) else {
            return Some(rest_start.index);
        };
        if let Last::At(last) = self.last
            && self.start(last).time(&self.reduced) <= time
        {
            return Some(last);
        }
        // First without double-double, which overflows earlier and then is no number.
        let coarse = tau.hi() / duration.hi();
        if coarse.is_nan() || coarse >= MOST_SWINGS as f64 {
            return None;
        }
        let count = ((tau - rest_start.tau) / duration).hi().max(0.0);
        let mut index = rest_start.index + count as u64;
        // The times that are told are rounded; a swing starts at its rounded time.
        while self.start(index + 1).time(&self.reduced) <= time {
            index += 1;
        }
        while index > rest_start.index && self.start(index).time(&self.reduced) > time {
            index -= 1;
        }
        (index < MOST_SWINGS).then_some(index)
    }

    /// The first turning point that sticks.
    fn find_last(&self) -> Last {
        let Some(rest_start) = self.rest_start else { return Last::Never };
        if rest_start.rests() {
            return Last::At(rest_start.index);
        }
        let Some(Repeat { decrement, .. }) = self.repeat else { return Last::Never };
        let (a, f) = (rest_start.x.abs(), self.reduced.offset.hi());
        let band = self.reduced.sticking_offset.hi();
        if band == 0.0 || f == 0.0 && decrement.hi() == 0.0 {
            return Last::Never;
        }
        // Past the last turning point the formula goes on to negative distances.
        let over = |count: u64| {
            let distance = self.distance(a, count);
            let index = rest_start.index + count;
            distance.hi() < 0.0 || self.sticking.verdict(distance, index, self.error).sticks
        };
        let estimate = swings_until(a.hi(), band, f, decrement.hi());
        if estimate >= MOST_SWINGS as f64 {
            return Last::Beyond;
        }
        // Whatever lies within rounding of the band sticks, which can be long before the estimate: halve.
        let (mut before, mut count) = (0, (estimate as u64).max(1));
        while !over(count) {
            (before, count) = (count, 2 * count);
        }
        while count - before > 1 {
            let middle = before + (count - before) / 2;
            if over(middle) { count = middle } else { before = middle }
        }
        Last::At(rest_start.index + count)
    }
}

/// Number of swings, up to rounding, until the distance falls from `a` to `band`.
fn swings_until(a: f64, band: f64, offset: f64, decrement: f64) -> f64 {
    let without_damping = (a - band) / (2.0 * offset);
    // The map's fixed point lies at −f (1 + r)/(1 − r).
    let fixed = if offset == 0.0 { 0.0 } else { offset / (0.5 * decrement).tanh() };
    let damped = ((a - band) / (band + fixed)).ln_1p() / decrement;
    if damped.is_finite() { damped.ceil() } else { without_damping.ceil() }
}

/// For a number of swings: Y' = `a` Y − `b`, ΣY = `p` Y − `q`, ΣY² = `s` Y² − `t` Y + `u`.
/// In double-double, since the ratio is raised to a power as large as the number of swings.
#[derive(Debug, Clone, Copy)]
struct SwingSums {
    a: Double,
    b: Double,
    p: Double,
    q: Double,
    s: Double,
    t: Double,
    u: Double,
}

impl SwingSums {
    fn none() -> Self {
        let (zero, one) = (0.0.into(), 1.0.into());
        SwingSums { a: one, b: zero, p: zero, q: zero, s: zero, t: zero, u: zero }
    }

    fn one(ratio: Double, offset: Double) -> Self {
        let one = 1.0.into();
        SwingSums { a: ratio, b: 2.0 * offset, p: one, s: one, ..Self::none() }
    }

    /// These swings, then those of `next`.
    fn then(&self, next: &SwingSums) -> Self {
        SwingSums {
            a: self.a * next.a,
            b: next.a * self.b + next.b,
            p: self.p + next.p * self.a,
            q: self.q + next.p * self.b + next.q,
            s: self.s + next.s * self.a * self.a,
            t: self.t + 2.0 * next.s * self.a * self.b + next.t * self.a,
            u: self.u + next.s * self.b * self.b + next.t * self.b + next.u,
        }
    }

    fn at(&self, y: Double) -> (Double, Double) {
        (self.p * y - self.q, (self.s * y - self.t) * y + self.u)
    }
}
