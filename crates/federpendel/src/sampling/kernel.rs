//! One run of samples in one formula: on one swing, or on many where a formula goes on through turning points.

use std::hint::black_box;

use pulp::{Simd, WithSimd};

use crate::chain::Frame;
use crate::chain::cursor::Cursor;
use crate::double::Double;
use crate::oscillator::Reduced;
use crate::sampling::carry::Carry;
use crate::sampling::grid::Grid;
use crate::sampling::lanes::{
    ALL_TERMS, FEW_TERMS, FEW_TERMS_REACH, LANES, Lanes, each, exp, mul_add, polynomial, sin_cos,
};
use crate::sampling::steps::Steps;
use crate::sampling::times::{Clock, Times};
use crate::swing::piece::{DEGREE, Piece};

/// The samples `first`, `first` + 1, … as many as the buffers hold, from the swing under the cursor on.
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
            Some(chain) => match (self.times.carried(), chain.wave()) {
                (Some((grid, steps)), _) => self.carried::<FUSED>(grid, steps),
                (None, Some(wave)) if wave.0 < LONGEST_WAVE => self.oscillation::<FUSED>(wave),
                _ => self.one_by_one(),
            },
        }
    }

    /// A linear motion on an even grid, on this swing or from it on.
    #[inline(always)]
    fn carried<const FUSED: bool>(&mut self, grid: &Grid, steps: &Steps) {
        let tau = f64::from(grid.tau(self.first) - self.cursor.start().tau);
        self.store::<FUSED>(Carry::new(grid, steps, self.cursor.framed_at(tau)));
    }

    fn clock(&self, origin: Double) -> Clock {
        let pair = |number: Double| (number.hi(), number.lo());
        Clock { omega: pair(self.reduced.omega0), origin: pair(origin) }
    }

    /// Strong damping.
    fn one_by_one(&mut self) {
        let Frame { side, origin, .. } = self.cursor.frame();
        let omega = self.reduced.omega0.hi();
        for (i, (x, v)) in self.positions.iter_mut().zip(self.velocities.iter_mut()).enumerate() {
            let tau = self.cursor.tau(self.times.time(self.first + i));
            let (y, w) = self.cursor.framed_at(tau);
            (*x, *v) = (side * y + origin, side * w * omega);
        }
    }

    /// A linear swing of `duration` or less, in the first half of which damping takes off 1 − `decay`.
    #[inline(always)]
    fn oscillation<const FUSED: bool>(&mut self, (duration, decay): (f64, f64)) {
        let start = *self.cursor.start();
        let (y0, w0) = start.framed(self.reduced.offset);
        let clock = self.clock(start.tau + 0.5 * duration);
        let zeta = self.reduced.zeta.hi();
        let oscillation = Oscillation::new(y0.into(), w0, zeta, (duration, decay));
        let farthest = 0.5 * zeta * duration;
        if zeta == 0.0 {
            self.store::<FUSED>(Direct::new(&clock, &Damped::<0>(oscillation)));
        } else if farthest <= FEW_TERMS_REACH {
            self.store::<FUSED>(Direct::new(&clock, &Damped::<FEW_TERMS>(oscillation)));
        } else {
            self.store::<FUSED>(Direct::new(&clock, &Damped::<ALL_TERMS>(oscillation)));
        }
    }

    fn outside(&self) -> Outside {
        let Frame { side, origin, .. } = self.cursor.frame();
        Outside { side, origin, omega: side * self.reduced.omega0.hi() }
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
            let clock = run.clock(start + piece.center);
            // As many terms as this piece needs, in a few lengths that the compiler can unroll; for a browser one length,
            // each being code to send.
            let terms = if cfg!(target_family = "wasm") { DEGREE + 1 } else { piece.terms(end) };
            match terms {
                12 => run.store::<FUSED>(Direct::new(&clock, &Polynomials::<12>(piece))),
                16 => run.store::<FUSED>(Direct::new(&clock, &Polynomials::<16>(piece))),
                18 => run.store::<FUSED>(Direct::new(&clock, &Polynomials::<18>(piece))),
                20 => run.store::<FUSED>(Direct::new(&clock, &Polynomials::<20>(piece))),
                22 => run.store::<FUSED>(Direct::new(&clock, &Polynomials::<22>(piece))),
                _ => run.store::<FUSED>(Direct::new(&clock, &Polynomials::<{ DEGREE + 1 }>(piece))),
            }
            at += count;
        }
    }

    /// Stores the states from `source`, block after block.
    #[inline(always)]
    fn store<const FUSED: bool>(&mut self, mut source: impl Source) {
        let outside = self.outside();
        let (times, first) = (self.times, self.first);
        let (xs, last_xs) = self.positions.as_chunks_mut::<LANES>();
        let (vs, last_vs) = self.velocities.as_chunks_mut::<LANES>();
        let whole = xs.len();
        for (block, (xs, vs)) in xs.iter_mut().zip(vs).enumerate() {
            let state = source.block::<FUSED>(times, first + block * LANES, block);
            (*xs, *vs) = outside.apply::<FUSED>(state);
        }
        if !last_xs.is_empty() {
            let state = source.block::<FUSED>(times, first + whole * LANES, whole);
            let (x, v) = outside.apply::<FUSED>(state);
            last_xs.copy_from_slice(&x[..last_xs.len()]);
            last_vs.copy_from_slice(&v[..last_vs.len()]);
        }
    }
}

/// Where the states of a run come from.
pub(crate) trait Source {
    /// (y, w) of block `block` of the run, the times of which start at index `first`.
    fn block<const FUSED: bool>(
        &mut self,
        times: &Times,
        first: usize,
        block: usize,
    ) -> (Lanes, Lanes);
}

/// Every state computed by the formula of the stretch.
struct Direct<'a, S> {
    clock: &'a Clock,
    stretch: &'a S,
}

impl<'a, S: Stretch> Direct<'a, S> {
    fn new(clock: &'a Clock, stretch: &'a S) -> Self {
        Direct { clock, stretch }
    }
}

impl<S: Stretch> Source for Direct<'_, S> {
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    #[cfg_attr(target_family = "wasm", inline(never))]
    fn block<const FUSED: bool>(
        &mut self,
        times: &Times,
        first: usize,
        _: usize,
    ) -> (Lanes, Lanes) {
        self.stretch.state::<FUSED>(&self.clock.read::<FUSED>(&times.lanes::<FUSED>(first)))
    }
}

/// From the frame of the swing to position and velocity.
#[derive(Clone, Copy)]
struct Outside {
    side: f64,
    origin: f64,
    omega: f64,
}

impl Outside {
    #[inline(always)]
    fn apply<const FUSED: bool>(self, (y, w): (Lanes, Lanes)) -> (Lanes, Lanes) {
        (each(|i| mul_add::<FUSED>(self.side, y[i], self.origin)), each(|i| self.omega * w[i]))
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
#[derive(Clone, Copy)]
struct Oscillation {
    zeta: f64,
    root: f64,
    y0: f64,
    w0: f64,
    b: f64,
    d: f64,
}

impl Oscillation {
    fn new(y0: f64, w0: f64, zeta: f64, (duration, decay): (f64, f64)) -> Self {
        let root = std::f64::consts::PI / duration;
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

/// An oscillation whose decay takes so many terms of e^x.
struct Damped<const TERMS: usize>(Oscillation);

impl<const TERMS: usize> Stretch for Damped<TERMS> {
    #[inline(always)]
    fn state<const FUSED: bool>(&self, tau: &Lanes) -> (Lanes, Lanes) {
        let Oscillation { zeta, root, y0, w0, b, d } = self.0;
        let (sin, cos) = sin_cos::<FUSED>(&each(|i| root * tau[i]));
        let y = each(|i| mul_add::<FUSED>(b, cos[i], -y0 * sin[i]));
        let w = each(|i| mul_add::<FUSED>(-d, cos[i], -w0 * sin[i]));
        if TERMS == 0 {
            return (y, w);
        }
        // Through memory in between: in one piece with the sine, the compiler's search for vectors takes
        // this apart into single numbers, which doubles the time of a record.
        let decay = exp::<FUSED, TERMS>(&black_box(each(|i| -zeta * tau[i])));
        (each(|i| y[i] * decay[i]), each(|i| w[i] * decay[i]))
    }
}

/// A piece of a series, its polynomials cut to the terms needed.
struct Polynomials<'a, const TERMS: usize>(&'a Piece);

impl<const TERMS: usize> Stretch for Polynomials<'_, TERMS> {
    #[inline(always)]
    fn state<const FUSED: bool>(&self, tau: &Lanes) -> (Lanes, Lanes) {
        let Piece { inverse_scale, position, velocity, .. } = self.0;
        let u = each(|i| tau[i] * inverse_scale);
        (leading::<FUSED, TERMS>(position, &u), leading::<FUSED, TERMS>(velocity, &u))
    }
}

/// The polynomial of the first `TERMS` coefficients.
#[inline(always)]
fn leading<const FUSED: bool, const TERMS: usize>(
    coefficients: &[f64; DEGREE + 1],
    x: &Lanes,
) -> Lanes {
    match coefficients.first_chunk::<TERMS>() {
        Some(first) => polynomial::<FUSED, TERMS>(first, x),
        None => polynomial::<FUSED, _>(coefficients, x),
    }
}
