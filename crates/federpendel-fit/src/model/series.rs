//! A stretch of one swing as a Taylor series, with its derivatives.
//!
//! The frame is that of the core crate: time τ = ω0 t, velocity w = dy/dτ, and the mass moving in the negative direction about
//! the centre of its swing, y″ + 2ζ y′ − κ y′² + y = 0. A derivative z of y obeys the equation varied:
//! z″ + 2ζ z′ − 2κ y′ z′ + z = g, with g = −2y′ for the derivative with respect to ζ, y′² for κ, and 0 for y and w at the
//! start of the swing. All right-hand sides are at most quadratic: the coefficients follow from Cauchy products.

/// Degree of the series of y.
pub(super) const DEGREE: usize = 20;

/// The directions of the derivatives: y and w at the start of the swing, ζ, κ. Those of them that are asked for, `D`, are
/// all or none.
pub(super) const DIRECTIONS: usize = 4;
/// What stands on the right of the equation of each direction, times y′ …
const FORCE: [f64; DIRECTIONS] = [0.0, 0.0, -2.0, 0.0];
/// … and times y′².
const FORCE_SQUARED: [f64; DIRECTIONS] = [0.0, 0.0, 0.0, 1.0];

/// Longest reach of one series: two of them make up a light swing.
pub(super) const LONGEST: f64 = 1.65;
/// Truncation allowed, relative to the motion.
const TRUNCATION: f64 = 1e-13;
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
    pub fn new(law: Law, state: &State<D>, scale: f64) -> Self {
        let mut series = Series {
            y: [0.0; DEGREE + 1],
            w: [0.0; DEGREE],
            dy: [[0.0; D]; DEGREE + 1],
            dw: [[0.0; D]; DEGREE],
            reach: 0.0,
        };
        (series.y[0], series.w[0]) = (state.y, state.w);
        (series.dy[0], series.dw[0]) = (state.dy, state.dw);
        for n in 0..DEGREE - 1 {
            series.order(law, n);
        }
        series.y[DEGREE] = series.w[DEGREE - 1] / DEGREE as f64;
        series.dy[DEGREE] = series.dw[DEGREE - 1].map(|w| w / DEGREE as f64);
        series.reach = series.reach(state, scale);
        series
    }

    /// Goes on from order `n` to the next.
    #[inline(always)]
    fn order(&mut self, law: Law, n: usize) {
        let share = 1.0 / (n + 1) as f64;
        let (mut square, mut cross) = (0.0, [0.0; D]);
        for j in 0..=n {
            let w = self.w[j];
            square += w * self.w[n - j];
            for (sum, dw) in cross.iter_mut().zip(&self.dw[n - j]) {
                *sum += w * dw;
            }
        }
        self.y[n + 1] = share * self.w[n];
        self.w[n + 1] = share * (law.kappa * square - law.damping * self.w[n] - self.y[n]);
        for d in 0..D {
            let force = FORCE[d] * self.w[n] + FORCE_SQUARED[d] * square;
            let slope = 2.0 * law.kappa * cross[d] - law.damping * self.dw[n][d] - self.dy[n][d];
            self.dy[n + 1][d] = share * self.dw[n][d];
            self.dw[n + 1][d] = share * (slope + force);
        }
    }

    /// How far the series may be trusted, from the size of their last two coefficients of w.
    fn reach(&self, state: &State<D>, scale: f64) -> f64 {
        let size = state.size().max(SMALL * scale);
        // What the derivatives are large by: y0 and w0 act in proportion, κ with the square.
        let sizes = [size / scale, size / scale, size, size * scale];
        let within = |n: usize| {
            let mut largest = self.w[n].abs() / size;
            for (d, size) in sizes.iter().take(D).enumerate() {
                let now = state.dy[d].abs().max(state.dw[d].abs()).max(*size);
                largest = largest.max(0.1 * self.dw[n][d].abs() / now);
            }
            (TRUNCATION / largest).powf(1.0 / n as f64)
        };
        LONGEST.min(within(DEGREE - 1)).min(within(DEGREE - 2))
    }

    /// The state so long after the centre.
    #[inline(always)]
    pub fn state(&self, tau: f64) -> State<D> {
        State {
            y: polynomial(&self.y, tau),
            w: polynomial(&self.w, tau),
            dy: polynomials(&self.dy, tau),
            dw: polynomials(&self.dw, tau),
        }
    }

    /// When the velocity becomes zero, if it does within the reach.
    pub fn reversal(&self) -> Option<f64> {
        let (mut low, mut high) = (0.0, self.reach);
        let end = polynomial(&self.w, high);
        if end < 0.0 {
            return None;
        }
        // Newton's method kept inside a bracket.
        let mut tau = high;
        for _ in 0..100 {
            let (w, slope) = with_slope(&self.w, tau);
            if w >= 0.0 {
                high = tau
            } else {
                low = tau
            }
            let newton = tau - w / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - tau).abs() <= 1e-15 || next == low || next == high {
                return Some(next);
            }
            tau = next;
        }
        Some(tau)
    }
}

#[inline(always)]
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

#[inline(always)]
fn polynomials<const D: usize>(coefficients: &[[f64; D]], x: f64) -> [f64; D] {
    let mut sums = [0.0; D];
    for row in coefficients.iter().rev() {
        for (sum, c) in sums.iter_mut().zip(row) {
            *sum = *sum * x + c;
        }
    }
    sums
}

/// The polynomial and its derivative.
fn with_slope(coefficients: &[f64], x: f64) -> (f64, f64) {
    let (mut sum, mut slope) = (0.0, 0.0);
    for c in coefficients.iter().rev() {
        slope = slope * x + sum;
        sum = sum * x + c;
    }
    (sum, slope)
}
