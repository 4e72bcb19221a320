//! A swing with Newton friction as a Taylor series, the series that §4 of the article suggests.
//!
//! The swing is written as y = L + z: L solves the linear part and is known in closed form, z is
//! what quadratic drag adds: z″ + 2ζ z′ + z = κ y′², z = z′ = 0 at the start. The right-hand side is
//! quadratic, so the coefficients follow from a Cauchy product. Rounding of the series reaches the
//! motion only through z, which is small where the drag is weak: that is what keeps
//! millions of swings accurate.

use twofloat::TwoFloat;

use crate::swing::End;
use crate::swing::linear::Propagator;
use crate::swing::piece::{DEGREE, Piece, horner};

/// The constants of all swings of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Taylor {
    pub propagator: Propagator,
    /// Duration π/√(1 − ζ²) of a linear swing from rest, where there is one.
    pub half_period: Option<TwoFloat>,
    /// Factor r = e^(−ζ half_period) between turning amplitudes of the linear swing.
    pub ratio: TwoFloat,
    pub kappa: f64,
    /// Below this, κ times a squared length is lost in rounding.
    pub negligible: f64,
}

/// The linear part L of one swing, known in closed form from its start and, if it starts from rest, from
/// its end too: near the end that form keeps the small velocity accurate.
struct LinearPart<'a> {
    taylor: &'a Taylor,
    y0: f64,
    w0: f64,
    /// Time and place of the end of L.
    end: Option<(TwoFloat, TwoFloat)>,
}

impl<'a> LinearPart<'a> {
    fn new(taylor: &'a Taylor, y0: TwoFloat, w0: f64) -> Self {
        let from_rest = taylor.half_period.filter(|_| w0 == 0.0);
        let end = from_rest.map(|half_period| (half_period, -(taylor.ratio * y0)));
        Self { taylor, y0: y0.into(), w0, end }
    }

    fn state(&self, tau: f64) -> (f64, f64) {
        self.taylor.propagator.state(tau, self.y0, self.w0)
    }

    /// State at a time `offset` from the end of L, its place to double-double where that is
    /// small; the time itself too.
    fn state_near_end(&self, tau: f64) -> (TwoFloat, TwoFloat, f64) {
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

/// Coefficients about one centre, of z and of y = L + z.
struct Expansion {
    y: [f64; DEGREE + 1],
    z: [f64; DEGREE + 1],
    /// Up to here, either way, the series is good to rounding.
    radius: f64,
}

/// Largest step: a linear swing would allow a little more at this degree.
const LONGEST: f64 = 2.0;
/// Truncation allowed, relative to the size of the state.
const TRUNCATION: f64 = 1e-18;
/// More steps than any swing with κ|y| below the limit of [`crate::Motion`] can need.
const MOST_STEPS: usize = 1 << 21;

impl Taylor {
    fn expand(&self, (l0, l1): (f64, f64), (z0, z1): (f64, f64)) -> Expansion {
        let damping = 2.0 * self.propagator.zeta();
        let (mut l, mut z) = ([0.0; DEGREE + 1], [0.0; DEGREE + 1]);
        // Coefficients of the velocity y′.
        let mut p = [0.0; DEGREE + 1];
        (l[0], l[1], z[0], z[1], p[0]) = (l0, l1, z0, z1, l1 + z1);
        for n in 0..DEGREE - 1 {
            let inverse = INVERSE[n];
            let k = (n + 1) as f64;
            l[n + 2] = -(damping * k * l[n + 1] + l[n]) * inverse;
            let square = self.kappa * cauchy_square(&p, n);
            z[n + 2] = (square - damping * k * z[n + 1] - z[n]) * inverse;
            p[n + 1] = (k + 1.0) * (l[n + 2] + z[n + 2]);
        }
        let y = std::array::from_fn(|n| l[n] + z[n]);
        Expansion { radius: radius(&y), y, z }
    }

    /// Follows the swing from (y0, w0) to its end and leaves its pieces in `pieces`, if given.
    pub fn solve(&self, y0: TwoFloat, w0: f64, mut pieces: Option<&mut Vec<Piece>>) -> End {
        let linear = LinearPart::new(self, y0, w0);
        let (mut tau, mut z) = (0.0, (0.0, 0.0));
        if let Some(pieces) = pieces.as_deref_mut() {
            pieces.clear();
        }
        for _ in 0..MOST_STEPS {
            let expansion = self.expand(linear.state(tau), z);
            keep(pieces.as_deref_mut(), tau, &expansion);
            let step = expansion.radius;
            let next = linear.state(tau + step);
            let next_z = (horner(&expansion.z, step), slope(&expansion.z, step));
            if next.1 + next_z.1 >= 0.0 {
                let root = reversal(&expansion.y, step);
                let z = (horner(&expansion.z, root), slope(&expansion.z, root));
                return self.end(&linear, tau + root, z, pieces);
            }
            (tau, z) = (tau + step, next_z);
            let (y, w) = (next.0 + z.0, next.1 + z.1);
            if self.half_period.is_none()
                && self.kappa * y.abs().max(w.abs()).powi(2) < self.negligible
            {
                return End::Linear { tau, y, w };
            }
        }
        unreachable!("a swing of more than {MOST_STEPS} steps: y0 = {y0:?}, w0 = {w0}, {self:?}")
    }

    /// The end of the swing, `tau` being the reversal up to rounding: one Newton step from the
    /// accurate state there.
    fn end(
        &self,
        linear: &LinearPart,
        tau: f64,
        z: (f64, f64),
        pieces: Option<&mut Vec<Piece>>,
    ) -> End {
        let (time, place, speed) = linear.state_near_end(tau);
        let y = place + z.0;
        let w = speed + z.1;
        if pieces.is_some() {
            keep(pieces, tau, &self.expand((place.into(), speed), z));
        }
        // y″ = −y where w vanishes.
        End::Reversal { tau: time + w / f64::from(y), y: y + 0.5 * w * w / f64::from(y) }
    }
}

/// 1/((n + 1)(n + 2)).
const INVERSE: [f64; DEGREE] = {
    let mut table = [0.0; DEGREE];
    let mut n = 0;
    while n < DEGREE {
        table[n] = 1.0 / ((n + 1) * (n + 2)) as f64;
        n += 1;
    }
    table
};

/// Coefficient n of the square of the series `p`.
#[inline]
fn cauchy_square(p: &[f64; DEGREE + 1], n: usize) -> f64 {
    let half = n.div_ceil(2);
    let twice =
        p[..half].iter().zip(p[n + 1 - half..=n].iter().rev()).fold(0.0, |s, (a, b)| s + a * b);
    let middle = if n.is_multiple_of(2) { p[n / 2] * p[n / 2] } else { 0.0 };
    2.0 * twice + middle
}

/// How far the series may be trusted, from the size of its last two coefficients.
fn radius(y: &[f64; DEGREE + 1]) -> f64 {
    let size = TRUNCATION * y[0].abs().max(y[1].abs());
    let reach = |n: usize| (size / (n as f64 * y[n].abs())).powf(1.0 / n as f64);
    reach(DEGREE).min(reach(DEGREE - 1)).min(LONGEST)
}

/// Derivative of the polynomial at `u`.
fn slope(coefficients: &[f64; DEGREE + 1], u: f64) -> f64 {
    (1..=DEGREE).rev().fold(0.0, |sum, n| sum * u + n as f64 * coefficients[n])
}

/// The time within `step` at which the velocity of the series rises through zero: Newton's method
/// kept inside a bracket.
fn reversal(y: &[f64; DEGREE + 1], step: f64) -> f64 {
    let velocity: [f64; DEGREE + 1] =
        std::array::from_fn(|n| if n < DEGREE { (n + 1) as f64 * y[n + 1] } else { 0.0 });
    let (mut low, mut high) = (0.0, step);
    let mut u = step;
    for _ in 0..100 {
        let w = horner(&velocity, u);
        if w >= 0.0 {
            high = u;
        } else {
            low = u;
        }
        let newton = u - w / slope(&velocity, u);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - u).abs() <= 1e-9 * u || next == low || next == high {
            // The step after this one is below rounding; the caller takes it.
            return next;
        }
        u = next;
    }
    u
}

/// Stores the expansion about `center`, valid from half way since the centre before it.
fn keep(pieces: Option<&mut Vec<Piece>>, center: f64, expansion: &Expansion) {
    let Some(pieces) = pieces else { return };
    let start = pieces.last().map_or(0.0, |last| 0.5 * (last.center + center));
    let velocity =
        std::array::from_fn(|n| if n < DEGREE { (n + 1) as f64 * expansion.y[n + 1] } else { 0.0 });
    pieces.push(Piece { start, center, inverse_scale: 1.0, position: expansion.y, velocity });
}
