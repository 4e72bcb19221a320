//! A stretch of one swing as a Taylor series, with its derivatives.
//!
//! The frame is that of the core crate: time τ = ω0 t, velocity w = dy/dτ, and the mass moving in the negative direction about
//! the centre of its swing, y″ + 2ζ y′ − κ y′² + y = 0. A derivative z of y obeys the equation varied:
//! z″ + 2ζ z′ − 2κ y′ z′ + z = g, with g = −2y′ for the derivative with respect to ζ, y′² for κ, and 0 for y and w at the
//! start of the swing. All right-hand sides are at most quadratic: the coefficients follow from Cauchy products.

use pulp::Simd;

/// Degree of the series of y.
pub(super) const DEGREE: usize = 22;

/// The directions of the derivatives: y and w at the start of the swing, ζ, κ. Those of them that are asked for, `D`, are
/// all or none.
pub(super) const DIRECTIONS: usize = 4;
/// What stands on the right of the equation of each direction, times y′ …
const FORCE: [f64; DIRECTIONS] = [0.0, 0.0, -2.0, 0.0];
/// … and times y′².
const FORCE_SQUARED: [f64; DIRECTIONS] = [0.0, 0.0, 0.0, 1.0];

/// Longest reach of one series: two of them make up a light swing.
const LONGEST: f64 = 1.6;
/// Truncation allowed, relative to the motion.
const TRUNCATION: f64 = 1e-12;
/// Derivatives may be less accurate; that to κ would need one series more in each swing.
const COARSER: f64 = 0.001;
/// Below this part of the swing's size, errors of the state need not be smaller in proportion.
const SMALL: f64 = 1e-4;

/// The coefficients of the equation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law {
    /// 2ζ.
    pub damping: f64,
    /// κ, over a length.
    pub kappa: f64,
}

/// Where the swing is, and its derivatives.
#[derive(Debug, Clone, Copy)]
pub(super) struct State<const D: usize> {
    pub y: f64,
    pub w: f64,
    pub dy: [f64; D],
    pub dw: [f64; D],
}

impl<const D: usize> State<D> {
    /// At the start of a swing.
    pub fn start(y: f64, w: f64) -> Self {
        let unit = |i| std::array::from_fn(|d| if d == i { 1.0 } else { 0.0 });
        State { y, w, dy: unit(0), dw: unit(1) }
    }

    fn size(&self) -> f64 {
        self.y.abs().max(self.w.abs())
    }
}

/// The recurrence, order after order, with every loop inside it of a length known to the compiler.
#[cfg(not(target_family = "wasm"))]
macro_rules! orders {
    ($series:ident, $simd:ident, $law:ident: $($n:literal)*) => {
        $($series.order::<$simd>($law, $n);)*
    };
}

/// The same in a twentieth of the code, for browsers to load.
#[cfg(target_family = "wasm")]
macro_rules! orders {
    ($series:ident, $simd:ident, $law:ident: $($n:literal)*) => {
        for n in [$($n),*] {
            $series.order::<$simd>($law, n);
        }
    };
}

/// a·b + c, with one rounding where the machine does that in one instruction.
#[inline(always)]
fn mul_add<S: Simd>(a: f64, b: f64, c: f64) -> f64 {
    if S::IS_SCALAR { a * b + c } else { a.mul_add(b, c) }
}

/// The same with many b and c.
#[inline(always)]
fn muls_add<S: Simd, const D: usize>(a: f64, b: &[f64; D], mut c: [f64; D]) -> [f64; D] {
    for (c, b) in c.iter_mut().zip(b) {
        *c = mul_add::<S>(a, *b, *c);
    }
    c
}

/// Coefficients of y, w and their derivatives.
pub(super) struct Series<const D: usize> {
    pub y: [f64; DEGREE + 1],
    pub w: [f64; DEGREE],
    pub dy: [[f64; D]; DEGREE + 1],
    pub dw: [[f64; D]; DEGREE],
    /// Up to here the series are good.
    pub reach: f64,
}

impl<const D: usize> Series<D> {
    /// The series from `state` on, in a swing of size `scale`.
    #[inline(always)]
    pub fn new<S: Simd>(law: Law, state: &State<D>, scale: f64) -> Self {
        let mut series = Series {
            y: [0.0; DEGREE + 1],
            w: [0.0; DEGREE],
            dy: [[0.0; D]; DEGREE + 1],
            dw: [[0.0; D]; DEGREE],
            reach: 0.0,
        };
        (series.y[0], series.w[0]) = (state.y, state.w);
        (series.dy[0], series.dw[0]) = (state.dy, state.dw);
        orders!(series, S, law: 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20);
        series.y[DEGREE] = series.w[DEGREE - 1] / DEGREE as f64;
        series.dy[DEGREE] = series.dw[DEGREE - 1].map(|w| w / DEGREE as f64);
        series.reach = series.reach(state, scale);
        series
    }

    /// Goes on from order `n` to the next.
    #[inline(always)]
    fn order<S: Simd>(&mut self, law: Law, n: usize) {
        let share = 1.0 / (n + 1) as f64;
        // Half the sum but the square in the middle, which has no partner.
        let mut half = if n.is_multiple_of(2) { 0.5 * self.w[n / 2] * self.w[n / 2] } else { 0.0 };
        for j in (0..n.div_ceil(2)).rev() {
            half = mul_add::<S>(self.w[j], self.w[n - j], half);
        }
        let square = 2.0 * half;
        let damped = mul_add::<S>(law.damping, self.w[n], self.y[n]);
        self.y[n + 1] = share * self.w[n];
        self.w[n + 1] = share * mul_add::<S>(law.kappa, square, -damped);
        let mut cross = [0.0; D];
        // Multiplied by κ: without it there is no need of them.
        if D > 0 && law.kappa > 0.0 {
            for j in (0..=n).rev() {
                cross = muls_add::<S, D>(self.w[j], &self.dw[n - j], cross);
            }
        }
        for d in 0..D {
            let force = FORCE[d] * self.w[n] + FORCE_SQUARED[d] * square;
            let damped = mul_add::<S>(law.damping, self.dw[n][d], self.dy[n][d]);
            let slope = mul_add::<S>(2.0 * law.kappa, cross[d], force - damped);
            self.dy[n + 1][d] = share * self.dw[n][d];
            self.dw[n + 1][d] = share * slope;
        }
    }

    /// How far the series may be trusted, from the size of their last two coefficients of w.
    #[inline(always)]
    fn reach(&self, state: &State<D>, scale: f64) -> f64 {
        let size = state.size().max(SMALL * scale);
        // What the derivatives are large by: y0 and w0 act in proportion, κ with the square.
        let sizes = [size / scale, size / scale, size, size * scale];
        let [highest, next] = [DEGREE - 1, DEGREE - 2].map(|n| {
            let mut largest = self.w[n].abs() / size;
            for (d, size) in sizes.iter().take(D).enumerate() {
                let now = state.dy[d].abs().max(state.dw[d].abs()).max(*size);
                largest = largest.max(COARSER * self.dw[n][d].abs() / now);
            }
            largest
        });
        // Mostly there is no need of roots.
        if highest * const { power(LONGEST, DEGREE - 1) } <= TRUNCATION
            && next * const { power(LONGEST, DEGREE - 2) } <= TRUNCATION
        {
            return LONGEST;
        }
        let within = |largest: f64, n: usize| (TRUNCATION / largest).powf(1.0 / n as f64);
        LONGEST.min(within(highest, DEGREE - 1)).min(within(next, DEGREE - 2))
    }

    /// The state so long after the centre.
    #[inline(always)]
    pub fn state<S: Simd>(&self, tau: f64) -> State<D> {
        State {
            y: polynomial::<S>(&self.y, tau),
            w: polynomial::<S>(&self.w, tau),
            dy: polynomials::<S, D>(&self.dy, tau),
            dw: polynomials::<S, D>(&self.dw, tau),
        }
    }

    /// When the velocity becomes zero, if it does within the reach; `guess` is about when that should be.
    #[inline(always)]
    pub fn reversal<S: Simd>(&self, guess: f64) -> Option<f64> {
        let (mut low, mut high) = (0.0, self.reach);
        if polynomial::<S>(&self.w, high) < 0.0 {
            return None;
        }
        // Newton's method kept inside a bracket.
        let mut tau = if guess > low && guess < high { guess } else { high };
        for _ in 0..100 {
            let (w, slope) = with_slope::<S>(&self.w, tau);
            if w >= 0.0 {
                high = tau;
            } else {
                low = tau;
            }
            let newton = tau - w / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            // Each step squares the error.
            if (newton - tau).abs() <= 1e-7 * tau || next == low || next == high {
                return Some(newton.max(0.0));
            }
            tau = next;
        }
        Some(tau)
    }
}

const fn power(x: f64, n: usize) -> f64 {
    if n == 0 { 1.0 } else { x * power(x, n - 1) }
}

#[inline(always)]
fn polynomial<S: Simd>(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| mul_add::<S>(sum, x, *c))
}

#[inline(always)]
fn polynomials<S: Simd, const D: usize>(coefficients: &[[f64; D]], x: f64) -> [f64; D] {
    let mut sums = [0.0; D];
    for row in coefficients.iter().rev() {
        sums = muls_add::<S, D>(x, &sums, *row);
    }
    sums
}

/// The polynomial and its derivative.
#[inline(always)]
fn with_slope<S: Simd>(coefficients: &[f64], x: f64) -> (f64, f64) {
    let (mut sum, mut slope) = (0.0, 0.0);
    for c in coefficients.iter().rev() {
        slope = mul_add::<S>(slope, x, sum);
        sum = mul_add::<S>(sum, x, *c);
    }
    (sum, slope)
}
