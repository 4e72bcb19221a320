//! One run of samples on one swing.

use pulp::{Simd, WithSimd};

use crate::chain::cursor::Cursor;
use crate::double::Double;
use crate::oscillator::Reduced;
use crate::sampling::grid::{Carried, Grid};
use crate::sampling::lanes::{LANES, Lanes, each, exp, mul_add, polynomial, sin_cos};
use crate::sampling::times::{Clock, Times};

/// The samples `first`, `first` + 1, … as many as the buffers hold, all on the swing under the cursor.
pub(crate) struct Run<'a> {
    pub cursor: &'a Cursor<'a>,
    pub reduced: &'a Reduced,
    pub times: &'a Times<'a>,
    pub first: usize,
    pub positions: &'a mut [f64],
    pub velocities: &'a mut [f64],
}

impl WithSimd for Run<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        if S::IS_SCALAR { self.fill::<false>() } else { self.fill::<true>() }
    }
}

/// Duration of a swing, ω0 t, up to which it may be computed from its middle: nearer to critical damping
/// the growing exponential e^(ζ duration/2) would cost digits.
const LONGEST_WAVE: f64 = 4.0;

impl Run<'_> {
    #[inline(always)]
    fn fill<const FUSED: bool>(mut self) {
        let start = self.cursor.start();
        if start.rests() {
            self.positions.fill(start.x.into());
            self.velocities.fill(0.0);
            return;
        }
        match self.cursor.linear() {
            None => self.series::<FUSED>(),
            Some(chain) => match chain.repeat_duration() {
                Some(duration) if duration < LONGEST_WAVE => self.oscillation::<FUSED>(duration),
                _ => self.one_by_one(),
            },
        }
    }

    fn clock(&self, origin: Double) -> Clock {
        let pair = |number: Double| (number.hi(), number.lo());
        Clock { omega: pair(self.reduced.omega0), origin: pair(origin) }
    }

    /// Strong damping.
    fn one_by_one(&mut self) {
        let side = -self.cursor.start().direction;
        let (offset, omega) = (self.reduced.offset.hi(), self.reduced.omega0.hi());
        for (i, (x, v)) in self.positions.iter_mut().zip(self.velocities.iter_mut()).enumerate() {
            let tau = self.cursor.tau(self.times.time(self.first + i));
            let (y, w) = self.cursor.framed_at(tau);
            (*x, *v) = (side * (y + offset), side * w * omega);
        }
    }

    /// A linear swing of `duration` or less.
    #[inline(always)]
    fn oscillation<const FUSED: bool>(&mut self, duration: f64) {
        let start = *self.cursor.start();
        let (y0, w0) = start.framed(self.reduced.offset);
        let clock = self.clock(start.tau + 0.5 * duration);
        let oscillation = Oscillation::new(y0.into(), w0, self.reduced.zeta.hi(), duration);
        match self.times {
            Times::Any(_) => self.store::<FUSED>(&clock, &oscillation),
            Times::Even(grid) => self.carry::<FUSED>(&clock, &oscillation, grid),
        }
    }

    /// On an even grid most states are carried on from one before.
    #[inline(always)]
    fn carry<const FUSED: bool>(&mut self, clock: &Clock, oscillation: &Oscillation, grid: &Grid) {
        let frame = self.frame();
        let mut from = Carried { y: [0.0; LANES], w: [0.0; LANES], lag: [0.0; LANES] };
        let xs = self.positions.chunks_mut(LANES);
        for (block, (xs, vs)) in xs.zip(self.velocities.chunks_mut(LANES)).enumerate() {
            let (times, lag) = grid.lanes::<FUSED>(self.first + block * LANES);
            let (y, w) = match grid.transfer(block) {
                Some(transfer) => grid.carry::<FUSED>(&from, transfer, &lag),
                None => {
                    let (y, w) = oscillation.state::<FUSED>(&clock.read::<FUSED>(&times));
                    from = Carried { y, w, lag };
                    (y, w)
                }
            };
            let (x, v) = frame.outside::<FUSED>((y, w));
            put(xs, &x);
            put(vs, &v);
        }
    }

    fn frame(&self) -> Frame {
        let side = -self.cursor.start().direction;
        Frame {
            side,
            offset: side * self.reduced.offset.hi(),
            omega: side * self.reduced.omega0.hi(),
        }
    }

    /// A swing in pieces: those samples on each piece in turn.
    #[inline(always)]
    fn series<const FUSED: bool>(self) {
        let Run { cursor, reduced, times, first, mut positions, mut velocities } = self;
        let start = cursor.start().tau;
        let clock_time = |tau: f64| f64::from((start + tau) * reduced.time_unit);
        let mut at = first;
        while !positions.is_empty() {
            let (piece, end) = cursor.piece_at(cursor.tau(times.time(at)));
            let (from, until) = (clock_time(piece.start), clock_time(end));
            let count = (times.run_end(at, from, until) - at).clamp(1, positions.len());
            let (xs, vs);
            (xs, positions) = positions.split_at_mut(count);
            (vs, velocities) = velocities.split_at_mut(count);
            let mut run = Run { cursor, reduced, times, first: at, positions: xs, velocities: vs };
            let degree = piece.degree(end);
            let (position, velocity) = (&piece.position[..=degree], &piece.velocity[..=degree]);
            let clock = run.clock(start + piece.center);
            let scale = piece.inverse_scale;
            run.store::<FUSED>(&clock, &Polynomials { scale, position, velocity });
            at += count;
        }
    }

    /// Stores the states that `state` gives at the times of the clock.
    #[inline(always)]
    fn store<const FUSED: bool>(&mut self, clock: &Clock, stretch: &impl Stretch) {
        let frame = self.frame();
        let xs = self.positions.chunks_mut(LANES);
        for (block, (xs, vs)) in xs.zip(self.velocities.chunks_mut(LANES)).enumerate() {
            let times = self.times.lanes::<FUSED>(self.first + block * LANES);
            let state = stretch.state::<FUSED>(&clock.read::<FUSED>(&times));
            let (x, v) = frame.outside::<FUSED>(state);
            put(xs, &x);
            put(vs, &v);
        }
    }
}

/// Copies as many lanes as there is room for; the whole register nearly always.
#[inline(always)]
fn put(to: &mut [f64], lanes: &Lanes) {
    match to.first_chunk_mut::<LANES>() {
        Some(whole) => *whole = *lanes,
        None => to.copy_from_slice(&lanes[..to.len()]),
    }
}

/// From the frame of the swing to position and velocity.
#[derive(Clone, Copy)]
struct Frame {
    side: f64,
    offset: f64,
    omega: f64,
}

impl Frame {
    #[inline(always)]
    fn outside<const FUSED: bool>(self, (y, w): (Lanes, Lanes)) -> (Lanes, Lanes) {
        (each(|i| mul_add::<FUSED>(self.side, y[i], self.offset)), each(|i| self.omega * w[i]))
    }
}

/// A stretch of a swing in one formula. A trait and not a closure, because only what is always inlined is
/// compiled for the vector instructions of the machine.
trait Stretch {
    /// (y, w) in the frame of the swing at times since the origin of the stretch.
    fn state<const FUSED: bool>(&self, tau: &Lanes) -> (Lanes, Lanes);
}

/// A linear swing from its middle: with φ = √(1 − ζ²) τ,
/// y = e^(−ζτ)(b cos φ − y0 sin φ) and w = −e^(−ζτ)(d cos φ + w0 sin φ), where e^(−ζ duration/2) is
/// in the coefficients; |φ| ≤ π/2 needs no reduction of the argument.
struct Oscillation {
    zeta: f64,
    root: f64,
    y0: f64,
    w0: f64,
    b: f64,
    d: f64,
}

impl Oscillation {
    fn new(y0: f64, w0: f64, zeta: f64, duration: f64) -> Self {
        let root = std::f64::consts::PI / duration;
        let decay = (-0.5 * zeta * duration).exp();
        Oscillation {
            zeta,
            root,
            y0: y0 * decay,
            w0: w0 * decay,
            b: (w0 + zeta * y0) / root * decay,
            d: (zeta * w0 + y0) / root * decay,
        }
    }
}

impl Stretch for Oscillation {
    #[inline(always)]
    fn state<const FUSED: bool>(&self, tau: &Lanes) -> (Lanes, Lanes) {
        let (sin, cos) = sin_cos::<FUSED>(&each(|i| self.root * tau[i]));
        let y = each(|i| mul_add::<FUSED>(self.b, cos[i], -self.y0 * sin[i]));
        let w = each(|i| mul_add::<FUSED>(-self.d, cos[i], -self.w0 * sin[i]));
        if self.zeta == 0.0 {
            return (y, w);
        }
        let decay = exp::<FUSED>(&each(|i| -self.zeta * tau[i]));
        (each(|i| y[i] * decay[i]), each(|i| w[i] * decay[i]))
    }
}

/// A piece of a series, its polynomials cut to the degree needed.
struct Polynomials<'a> {
    scale: f64,
    position: &'a [f64],
    velocity: &'a [f64],
}

impl Stretch for Polynomials<'_> {
    #[inline(always)]
    fn state<const FUSED: bool>(&self, tau: &Lanes) -> (Lanes, Lanes) {
        let u = each(|i| tau[i] * self.scale);
        (polynomial::<FUSED>(self.position, &u), polynomial::<FUSED>(self.velocity, &u))
    }
}
