//! A swing with Newton friction as a Taylor series, the series that §4 of the article suggests.
//!
//! The swing is written as y = L + z: L solves the linear part and is known in closed form, z is
//! what quadratic drag adds: z″ + 2ζ z′ + z = κ y′², z = z′ = 0 at the start. The right-hand side is
//! quadratic, so the coefficients follow from a Cauchy product. Rounding of the series reaches the
//! motion only through z, which is small where the drag is weak: that is what keeps
//! millions of swings accurate.

use pulp::{Simd, WithSimd};

use crate::double::{Double, PI};
use crate::oscillator::Reduced;
use crate::sampling::lanes::mul_add;
use crate::swing::linear::Propagator;
use crate::swing::piece::{DEGREE, Piece, derivative, polynomial};
use crate::swing::{End, NotFollowed};

/// The constants of all swings of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Taylor {
    pub propagator: Propagator,
    /// Duration π/√(1 − ζ²) of a linear swing from rest, where there is one.
    pub half_period: Option<Double>,
    /// Factor r = e^(−ζ half_period) between turning amplitudes of the linear swing.
    pub ratio: Double,
    pub kappa: f64,
    /// Longest reach of one series, and its powers of the two highest degrees.
    longest: f64,
    longest_powers: (f64, f64),
}

/// Where κ times the size of the motion is smaller, drag is lost in rounding.
pub(crate) const NEGLIGIBLE: f64 = 0.1 * f64::EPSILON;

/// Where κ times the place of release is larger, L would be no part of the motion but far off it.
const STRONG: f64 = 0.5;

/// The linear part L of one swing, known in closed form from its start and, if it starts from rest, from
/// its end too: near the end that form keeps the small velocity accurate.
struct LinearPart<'a> {
    taylor: &'a Taylor,
    y0: f64,
    w0: f64,
    /// Time and place of the end of L.
    end: Option<(Double, Double)>,
}

impl<'a> LinearPart<'a> {
    fn new(taylor: &'a Taylor, y0: Double, w0: f64) -> Self {
        let from_rest = taylor.half_period.filter(|_| w0 == 0.0);
        let end = from_rest.map(|half_period| (half_period, -(taylor.ratio * y0)));
        Self { taylor, y0: y0.into(), w0, end }
    }

    fn state(&self, tau: f64) -> (f64, f64) {
        self.taylor.propagator.state(tau, self.y0, self.w0)
    }

    /// State at a time `offset` from the end of L, its place to double-double where that is
    /// small; the time itself too.
    fn state_near_end(&self, tau: f64) -> (Double, Double, f64) {
        match self.end {
            Some((duration, place)) if tau > 0.5 * duration.hi() => {
                let offset = tau - duration.hi();
                let transfer = self.taylor.propagator.transfer(offset);
                let y = place + place.hi() * (transfer.yy - 1.0);
                (duration + offset, y, -transfer.yw * place.hi())
            }
            _ => {
                let (y, w) = self.state(tau);
                (tau.into(), y.into(), w)
            }
        }
    }
}

impl LinearPart<'_> {
    /// The end of the swing, `tau` being the reversal up to rounding: one Newton step from the
    /// accurate state there.
    fn end(&self, tau: f64, z: (f64, f64)) -> End {
        let (time, place, speed) = self.state_near_end(tau);
        let y = place + z.0;
        let w = speed + z.1;
        // y″ = −y where w vanishes.
        End::Reversal { tau: time + w / f64::from(y), y: y + 0.5 * w * w / f64::from(y) }
    }
}

/// Coefficients about one centre, of z, of y = L + z and of y′.
struct Expansion {
    y: [f64; DEGREE + 1],
    z: [f64; DEGREE + 1],
    p: [f64; DEGREE + 1],
    /// Up to here, either way, the series is good to rounding.
    radius: f64,
}

impl Expansion {
    /// (z, z′) so long after the centre.
    #[inline(always)]
    fn drag<const FUSED: bool>(&self, time: f64) -> (f64, f64) {
        let slope = derivative(&self.z);
        (polynomial::<FUSED>(&self.z, time), polynomial::<FUSED>(&slope, time))
    }
}

/// Longest reach of one series; a linear swing would allow a little more at this degree.
const LONGEST: f64 = 1.75;
/// Truncation allowed, relative to the size of the state.
const TRUNCATION: f64 = 3e-17;
/// The same with strong damping, where a reversal may come when the motion has nearly died away.
const TRUNCATION_DAMPED: f64 = 1e-18;
/// More steps than any swing with κ|y| below the limit of [`crate::Motion`] can need.
const MOST_STEPS: usize = 1 << 21;

/// The recurrence, order after order, with every loop inside it of a length known to the compiler.
#[cfg(not(target_family = "wasm"))]
macro_rules! orders {
    ($series:ident, $fused:ident: $($n:literal)*) => { $($series.order::<$fused>($n);)* };
}

/// The same in a fraction of the code, for browsers to load.
#[cfg(target_family = "wasm")]
macro_rules! orders {
    ($series:ident, $fused:ident: $($n:literal)*) => {
        for n in [$($n),*] {
            $series.order::<$fused>(n);
        }
    };
}

impl Taylor {
    pub fn new(reduced: &Reduced) -> Self {
        let discriminant = reduced.discriminant();
        let half_period = (discriminant.hi() > 0.0).then(|| PI / discriminant.sqrt());
        // Two series that reach a little more than half of it each make up a light swing.
        let half = half_period.map_or(LONGEST, |duration| 0.51 * duration.hi());
        let longest = if half < LONGEST { half } else { LONGEST };
        Taylor {
            propagator: Propagator::new(reduced.zeta.into(), discriminant.into()),
            half_period,
            ratio: half_period.map_or(0.0.into(), |duration| (-(duration * reduced.zeta)).exp()),
            kappa: reduced.kappa,
            longest,
            longest_powers: (longest.powi(DEGREE as i32), longest.powi(DEGREE as i32 - 1)),
        }
    }

    /// With p, q the coefficients of y′ and z′:
    /// (n + 1) qₙ₊₁ = κ Σ pⱼpₙ₋ⱼ − 2ζ qₙ − zₙ, and the same without the sum for L.
    #[inline(always)]
    fn expand<const FUSED: bool>(&self, (l0, l1): (f64, f64), (z0, z1): (f64, f64)) -> Expansion {
        let damping = 2.0 * self.propagator.zeta();
        let mut series = Recurrence {
            damping,
            kappa: self.kappa,
            newest: 2.0 * self.kappa * (l1 + z1),
            l: l1,
            l_slope: -mul_add::<FUSED>(damping, l1, l0),
            q: self.kappa * (l1 + z1) * (l1 + z1) - mul_add::<FUSED>(damping, z1, z0),
            y: [0.0; DEGREE + 1],
            z: [0.0; DEGREE + 1],
            p: [0.0; DEGREE + 1],
        };
        (series.y[0], series.z[0], series.p[0]) = (l0 + z0, z0, l1 + z1);
        (series.y[1], series.z[1], series.p[1]) = (l1 + z1, z1, series.l_slope + series.q);
        orders!(series, FUSED: 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23);
        let Recurrence { y, z, p, .. } = series;
        Expansion { radius: self.radius(&y, &z), y, z, p }
    }

    /// How far the series may be trusted, from the size of their last two coefficients. z has its own say:
    /// with strong damping a slow motion is the sum of an L and a z whose fast parts cancel in y.
    #[inline(always)]
    fn radius(&self, y: &[f64; DEGREE + 1], z: &[f64; DEGREE + 1]) -> f64 {
        let truncation = if self.propagator.zeta() > 0.5 { TRUNCATION_DAMPED } else { TRUNCATION };
        let size = truncation * y[0].abs().max(y[1].abs());
        let reach = |n: usize, farthest: f64| {
            let ratio = size / (n as f64 * y[n].abs().max(z[n].abs()));
            // Six digits of the root will do, unless the ratio is none in single precision.
            let rough = ratio as f32;
            if ratio >= farthest {
                self.longest
            } else if rough.is_normal() {
                f64::from(rough.powf(1.0 / n as f32))
            } else {
                ratio.powf(1.0 / n as f64)
            }
        };
        reach(DEGREE, self.longest_powers.0).min(reach(DEGREE - 1, self.longest_powers.1))
    }

    /// Follows the swing from (y0, w0) to its end and leaves its pieces in `pieces`, if given.
    ///
    /// # Errors
    /// [`NotFollowed`] if the steps come to no end.
    pub fn solve(
        &self,
        y0: Double,
        w0: f64,
        pieces: Option<&mut Vec<Piece>>,
    ) -> Result<End, NotFollowed> {
        crate::sampling::arch().dispatch(Solve { taylor: self, y0, w0, pieces })
    }

    #[inline(always)]
    fn follow<const FUSED: bool>(
        &self,
        y0: Double,
        w0: f64,
        mut pieces: Option<&mut Vec<Piece>>,
    ) -> Result<End, NotFollowed> {
        let weak = self.kappa * y0.hi().abs().max(-w0) < STRONG;
        let linear =
            LinearPart::new(self, if weak { y0 } else { 0.0.into() }, if weak { w0 } else { 0.0 });
        let (mut tau, mut l) = (0.0, (linear.y0, linear.w0));
        let mut z = if weak { (0.0, 0.0) } else { (y0.hi(), w0) };
        if let Some(pieces) = pieces.as_deref_mut() {
            pieces.clear();
        }
        for _ in 0..MOST_STEPS {
            let expansion = self.expand::<FUSED>(l, z);
            self.keep(pieces.as_deref_mut(), tau, &expansion);
            let reach = expansion.radius;
            if polynomial::<FUSED>(&expansion.p, reach) >= 0.0 {
                let guess = self.half_period.map_or(reach, |duration| duration.hi() - tau);
                let root = reversal::<FUSED>(&expansion.p, guess, reach);
                return Ok(linear.end(tau + root, expansion.drag::<FUSED>(root)));
            }
            let step = self.step(tau, reach);
            z = expansion.drag::<FUSED>(step);
            tau += step;
            l = linear.state(tau);
            let (y, w) = (l.0 + z.0, l.1 + z.1);
            let largest = y.abs().max(w.abs());
            // With light damping the chain decides that at the turning point.
            let damped = self.propagator.zeta() > 0.5;
            if damped && self.kappa * largest < NEGLIGIBLE {
                return Ok(End::Linear { tau, y, w });
            }
        }
        Err(NotFollowed)
    }

    /// Stores the expansion about `center`, valid from half way since the centre before it; but not so far back that
    /// friction, which runs backwards there, makes the rounding of its start grow.
    fn keep(&self, pieces: Option<&mut Vec<Piece>>, center: f64, expansion: &Expansion) {
        let Some(pieces) = pieces else { return };
        let growth = 2.0 * (self.propagator.zeta() + self.kappa * expansion.p[0].abs());
        let half_way = pieces.last().map_or(0.0, |last| 0.5 * (last.center + center));
        let start = half_way.max(center - 1.0 / growth);
        let (position, velocity) = (expansion.y, expansion.p);
        pieces.push(Piece { start, center, inverse_scale: 1.0, position, velocity });
    }

    /// The next step from `tau` if the series reaches `reach`: half of what is left of a light swing if the
    /// next series can reach its end from there, since that one serves the other half.
    fn step(&self, tau: f64, reach: f64) -> f64 {
        let left = self.half_period.map_or(f64::INFINITY, |duration| duration.hi() - tau);
        if left > reach && left < 1.9 * reach { 0.5 * left } else { reach }
    }
}

/// A call of [`Taylor::solve`], compiled for the instructions of the machine.
struct Solve<'a> {
    taylor: &'a Taylor,
    y0: Double,
    w0: f64,
    pieces: Option<&'a mut Vec<Piece>>,
}

impl WithSimd for Solve<'_> {
    type Output = Result<End, NotFollowed>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        let Solve { taylor, y0, w0, pieces } = self;
        if S::IS_SCALAR {
            taylor.follow::<false>(y0, w0, pieces)
        } else {
            taylor.follow::<true>(y0, w0, pieces)
        }
    }
}

/// The coefficients of a series so far: l and l_slope the newest of L and L′, q that of z′.
struct Recurrence {
    damping: f64,
    kappa: f64,
    /// 2κp₀. The newest coefficient enters the sum twice, with p₀: that term is added last, so that all
    /// others can be summed before it is known.
    newest: f64,
    l: f64,
    l_slope: f64,
    q: f64,
    y: [f64; DEGREE + 1],
    z: [f64; DEGREE + 1],
    p: [f64; DEGREE + 1],
}

impl Recurrence {
    /// Goes on from order `n` to the next.
    #[inline(always)]
    fn order<const FUSED: bool>(&mut self, n: usize) {
        let inverse = 1.0 / (n + 1) as f64;
        let z_next = self.q * inverse;
        let l_next = self.l_slope * inverse;
        self.z[n + 1] = z_next;
        self.y[n + 1] = l_next + z_next;
        // Half the sum of the others; the newest of them come last, so that it need not wait for them.
        let mut sum = if n.is_multiple_of(2) { 0.5 * self.p[n / 2] * self.p[n / 2] } else { 0.0 };
        for j in (1..n.div_ceil(2)).rev() {
            sum = mul_add::<FUSED>(self.p[j], self.p[n - j], sum);
        }
        let damped = mul_add::<FUSED>(self.damping, self.q, self.z[n]);
        let others = mul_add::<FUSED>(2.0 * self.kappa, sum, -damped);
        self.q = mul_add::<FUSED>(self.newest, self.p[n], others) * inverse;
        self.l_slope = -mul_add::<FUSED>(self.damping, self.l_slope, self.l) * inverse;
        self.l = l_next;
        self.p[n + 1] = self.l_slope + self.q;
    }
}

/// The time within `step` at which the velocity, a series `p`, rises through zero: Newton's method
/// from `guess`, kept inside a bracket.
#[inline(always)]
fn reversal<const FUSED: bool>(p: &[f64; DEGREE + 1], guess: f64, step: f64) -> f64 {
    let (mut low, mut high) = (0.0, step);
    let slope = derivative(p);
    let mut u = if guess > low && guess < high { guess } else { step };
    for _ in 0..100 {
        let w = polynomial::<FUSED>(p, u);
        if w >= 0.0 {
            high = u;
        } else {
            low = u;
        }
        let newton = u - w / polynomial::<FUSED>(&slope, u);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - u).abs() <= 3e-5 * u || next == low || next == high {
            // Each step squares the error; the one after this, below rounding, is taken by the caller.
            return next;
        }
        u = next;
    }
    u
}
