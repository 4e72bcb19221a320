//! One swing under strong Stokes friction together with Newton friction: stiff, so implicit.
//!
//! In dimensionless time τ = ω0 t, with ζ = γ/ω0 and the mass moving in the negative direction,
//!
//! ```text
//! y' = w        w' = −y − 2ζ w + κ w²
//! ```
//!
//! A disturbance of w dies within 1/(2ζ), the motion itself takes 2ζ: an explicit series would
//! need of the order of ζ² steps. Here each step takes w as a polynomial of degree S, y as its exact
//! integral, and asks the equation for w' at all nodes but the first, which holds the initial value.
//! The last node is the end of the step, so a fast transient that a long step does not resolve is
//! damped to nothing (the method is stiffly accurate). Steps are chosen so that the coefficients of
//! both polynomials fall to rounding; as the transient dies they grow from about 1/ζ to about ζ.

use crate::double::Double;
use crate::swing::collocation::{
    Matrix, NODES, Nodal, POSITION_TERMS, STAGES, TABLES, Vector, antiderivative, dot, eliminate,
};
use crate::swing::piece::{DEGREE, Piece, derivative, polynomial};
use crate::swing::{End, NotFollowed};

const _: () = assert!(POSITION_TERMS <= DEGREE + 1);

/// Coefficients below this part of the amplitude count as rounding: 2^-51.
const ROUNDING: f64 = 4.440892098500626e-16;
/// The nonlinear term is left out once its effect is below this part of the amplitude: 2^-57.
const NEGLIGIBLE: f64 = 6.938893903907228e-18;
/// Steps tried before giving up; of 40,000 random swings in range none needed more than 35.
const STEP_LIMIT: usize = 400;
/// Newton iterations of one step; more than about 8 mean that the step is too long.
const ITERATION_LIMIT: usize = 12;

/// The constants of all swings of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stiff {
    /// ζ > 1; measured from 3 to 1e4, at larger ones only the balance of energy is.
    pub zeta: f64,
    /// κ ≥ 0, 1/m; measured for κ·`amplitude` up to 1e3, up to 1e5 by the balance of energy.
    pub kappa: f64,
    /// Amplitude of the whole motion, m, that errors are measured by.
    pub amplitude: f64,
}

impl Stiff {
    /// Follows the swing from (y0, w0), w0 < 0 or w0 = 0 ≤ y0, to its reversal, or until only the
    /// linear equation is left, and leaves its pieces in `pieces`, if given. With very weak Newton
    /// friction (κ·amplitude below about 1e-16 ζ) the linear rest may still come to a reversal;
    /// else it creeps to y = 0. If it is all linear there are no pieces.
    ///
    /// # Errors
    /// [`NotFollowed`] for a start in the other direction, for values that are not finite, and if
    /// the steps come to no end.
    pub fn solve(
        &self,
        y0: f64,
        w0: f64,
        mut pieces: Option<&mut Vec<Piece>>,
    ) -> Result<End, NotFollowed> {
        if let Some(pieces) = pieces.as_deref_mut() {
            pieces.clear();
        }
        let values = [self.zeta, self.kappa, self.amplitude, y0, w0];
        let starts = w0 < 0.0 || w0 == 0.0 && y0 >= 0.0;
        if !(starts && values.iter().all(|value| value.is_finite())) {
            return Err(NotFollowed);
        }
        let (mut tau, mut y, mut w) = (0.0, y0, w0);
        let mut length = self.first_step(y, w);
        for _ in 0..STEP_LIMIT {
            if self.is_linear(y, w) {
                return Ok(End::Linear { tau, y, w });
            }
            let end = tau + length;
            if end <= tau {
                break;
            }
            // The length that the rounded times really have.
            let step = match Step::new(self, y, w, end - tau) {
                Some(step) if step.excess <= 1.0 => step,
                failed => {
                    length *= failed.map_or(0.25, |step| step.shorter());
                    continue;
                }
            };
            if let Some(pieces) = pieces.as_deref_mut() {
                pieces.push(step.piece(tau));
            }
            if let Some((after, y)) = step.reversal() {
                return Ok(End::Reversal { tau: Double::sum(tau, after), y: y.into() });
            }
            (tau, y, w) = (end, step.y[STAGES], step.w[STAGES]);
            length = step.length * step.growth;
        }
        Err(NotFollowed)
    }

    /// What errors are measured by in a step from (y, w): the amplitude of the motion; but of this
    /// state, if its kick may carry it through the centre to a reversal, since that comes when w has
    /// died away and y is much smaller: an error of w moves its time by as much over |y|.
    fn scale(&self, y: f64, w: f64) -> f64 {
        let may_reverse = y + w / self.zeta < 0.0;
        if may_reverse { y.abs().max(w.abs()).max(1e-9 * self.amplitude) } else { self.amplitude }
    }

    /// Whether from here on the term κw² matters to neither y nor w. The slow motion has
    /// |w| ≤ |y|/(2ζ); the term acts on w for a time 1/(2ζ), on y through w for a time of about ζ.
    fn is_linear(&self, y: f64, w: f64) -> bool {
        let drift = y / (2.0 * self.zeta);
        let effect = self.kappa * (drift * drift).max(w * w / (2.0 * self.zeta));
        effect <= NEGLIGIBLE * self.scale(y, w)
    }

    /// A step that the fast time scales allow: the rate of decay 2ζ + κ|w|, the rate √(κ|y|) at
    /// which drag stops the acceleration, and, moving outwards, the time until the reversal, so
    /// that one that comes early is found to relative precision.
    fn first_step(&self, y: f64, w: f64) -> f64 {
        let rate =
            2.0 * self.zeta + 2.0 * self.kappa * w.abs() + 2.0 * (self.kappa * y.abs()).sqrt();
        let length = 4.0 / rate;
        if y < 0.0 { length.min((2.0 * w / y).max(1e-100)) } else { length }
    }
}

/// One step: values at the nodes and Chebyshev coefficients.
struct Step {
    length: f64,
    y: Nodal,
    w: Nodal,
    position: [f64; POSITION_TERMS],
    velocity: Nodal,
    /// Size of the last coefficients over what is allowed.
    excess: f64,
    /// Factor by which the next step may be longer.
    growth: f64,
}

impl Step {
    /// The step from (y0, w0), or `None` if the iteration does not converge.
    fn new(stiff: &Stiff, y0: f64, w0: f64, length: f64) -> Option<Self> {
        let half = 0.5 * length;
        let (y, w) = collocate(stiff, y0, w0, half)?;
        let velocity = TABLES.coefficients(&w);
        let mut position = antiderivative(&velocity).map(|b| b * half);
        position[0] += y0;
        let allowed = ROUNDING * stiff.scale(y0, w0);
        let size = |k: usize| velocity[k].abs().max(position[k].abs());
        let excess = size(STAGES).max(size(STAGES - 1)) / allowed;
        // Coefficients that fall to rounding within `terms` terms fall like ρ^−k with
        // ρ = ε^(−1/terms), and ρ is about inverse to the length.
        let terms = (1..NODES).rev().find(|&k| size(k) > allowed).unwrap_or(0) + 1;
        let digits = -ROUNDING.ln();
        let growth = (digits / terms as f64 - digits / (STAGES - 1) as f64).exp();
        let growth = (0.8 * growth).clamp(0.5, 1e3);
        Some(Step { length, y, w, position, velocity, excess, growth })
    }

    /// Factor for a second try of a step whose coefficients did not fall to rounding.
    fn shorter(&self) -> f64 {
        (0.8 * self.excess.powf(-1.0 / STAGES as f64)).clamp(0.1, 0.7)
    }

    /// The polynomials of a step that starts at `start`.
    fn piece(&self, start: f64) -> Piece {
        Piece {
            start,
            center: start + 0.5 * self.length,
            inverse_scale: 2.0 / self.length,
            position: TABLES.monomials(&self.position),
            velocity: TABLES.monomials(&self.velocity),
        }
    }

    /// When the velocity changes its sign, since the start of the step, and where; if it does.
    fn reversal(&self) -> Option<(f64, f64)> {
        let after = (1..NODES).find(|&j| self.w[j] >= 0.0 && self.y[j] < 0.0)?;
        let (mut low, mut high) = (TABLES.node[after - 1], TABLES.node[after]);
        let Piece { position, velocity, .. } = self.piece(0.0);
        let slope = derivative(&velocity);
        // Newton's method on the polynomial, kept inside the bracket by bisection.
        let mut u = 0.5 * (low + high);
        for _ in 0..60 {
            let w = polynomial::<false>(&velocity, u);
            if w < 0.0 {
                low = u
            } else {
                high = u
            }
            let newton = u - w / polynomial::<false>(&slope, u);
            let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
            if (next - u).abs() <= 1e-17 {
                break;
            }
            u = next;
        }
        Some((0.5 * self.length * (1.0 + u), polynomial::<false>(&position, u)))
    }
}

/// Values (y, w) at the nodes of a step of length 2·`half` from (y0, w0), by Newton's iteration on
/// D w = half·(−y − 2ζ w + κ w²), y = y0 + half·B w.
fn collocate(stiff: &Stiff, y0: f64, w0: f64, half: f64) -> Option<(Nodal, Nodal)> {
    let Stiff { zeta, kappa, .. } = *stiff;
    let tables = &*TABLES;
    let position =
        |w: &Nodal| -> Nodal { std::array::from_fn(|i| y0 + half * dot(&tables.integral[i], w)) };
    // Creeping home, y and w fall together; otherwise the initial value is a good enough start.
    let rate = if y0 > 0.0 { half * w0 / y0 } else { 0.0 };
    let mut w: Nodal = std::array::from_fn(|i| w0 * (rate * (1.0 + tables.node[i])).exp());
    for _ in 0..ITERATION_LIMIT {
        let y = position(&w);
        let mut residual: Vector = [0.0; STAGES];
        let mut jacobian: Matrix = [[0.0; STAGES]; STAGES];
        for (i, (residual, row)) in residual.iter_mut().zip(&mut jacobian).enumerate() {
            let i = i + 1;
            let (derivative, integral) = (&tables.derivative[i], &tables.integral[i]);
            // The rows of D sum to zero: differences keep the rounding in proportion to the change.
            let slope: f64 = (0..NODES).map(|j| derivative[j] * (w[j] - w[i])).sum();
            *residual = half * (-y[i] - (2.0 * zeta - kappa * w[i]) * w[i]) - slope;
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = derivative[j + 1] + half * half * integral[j + 1];
            }
            row[i - 1] += 2.0 * half * (zeta - kappa * w[i]);
        }
        eliminate(&mut jacobian, &mut residual);
        let (mut change, mut largest) = (0.0_f64, w0.abs());
        for (w, correction) in w[1..].iter_mut().zip(&residual) {
            *w += correction;
            // NaN must not be lost here, as `max` would.
            change = if correction.abs() <= change { change } else { correction.abs() };
            largest = largest.max(w.abs());
        }
        if !change.is_finite() {
            return None;
        }
        // Convergence is quadratic: what is left is the square of this, below rounding.
        if change <= 1e-9 * largest {
            return Some((position(&w), w));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (y, w) at τ after the handover: the two exponentials of the linear equation.
    fn linear(zeta: f64, y: f64, w: f64, tau: f64) -> (f64, f64) {
        let root = (zeta * zeta - 1.0).sqrt();
        let (fast, slow) = (-zeta - root, -1.0 / (zeta + root));
        let (a, b) = ((w - slow * y) / (fast - slow), (fast * y - w) / (fast - slow));
        let (f, s) = ((fast * tau).exp(), (slow * tau).exp());
        (a * f + b * s, a * fast * f + b * slow * s)
    }

    fn solve(zeta: f64, kappa: f64, y0: f64, w0: f64) -> Result<(Vec<Piece>, End), NotFollowed> {
        let mut pieces = Vec::new();
        let stiff = Stiff { zeta, kappa, amplitude: y0.abs().max(w0.abs()) };
        let end = stiff.solve(y0, w0, Some(&mut pieces))?;
        Ok((pieces, end))
    }

    fn follow(zeta: f64, kappa: f64, y0: f64, w0: f64) -> (Vec<Piece>, End) {
        solve(zeta, kappa, y0, w0).unwrap()
    }

    fn state(zeta: f64, pieces: &[Piece], end: End, tau: f64) -> (f64, f64) {
        match end {
            End::Linear { tau: t, y, w } if tau >= t => linear(zeta, y, w, tau - t),
            _ => pieces.iter().rfind(|piece| piece.start <= tau).unwrap().state(tau),
        }
    }

    /// Where `stiff_swings.csv` comes from: `tests/data/stiff_swings.py`, 60 digits.
    #[test]
    fn agrees_with_high_precision_table() {
        let mut swings = std::collections::HashSet::new();
        for line in include_str!("../../tests/data/stiff_swings.csv").lines().skip(1) {
            let field: Vec<&str> = line.split(',').collect();
            let number = |i: usize| field[i].parse::<f64>().unwrap();
            let (zeta, y0, w0) = (number(0), number(2), number(3));
            let (tau, y, w) = (number(5), number(6), number(7));
            let (pieces, end) = follow(zeta, number(1), y0, w0);
            let amplitude = y0.abs().max(w0.abs());
            let (got_y, got_w) = state(zeta, &pieces, end, tau);
            assert!((got_y - y).abs() <= 1e-15 * amplitude, "{line}: y = {got_y:e}");
            assert!((got_w - w).abs() <= 1e-15 * amplitude, "{line}: w = {got_w:e}");
            if field[4] == "reversal" {
                let End::Reversal { tau: got, y: got_y } = end else { panic!("{line}: {end:?}") };
                let (got, got_y) = (f64::from(got), f64::from(got_y));
                assert!((got - tau).abs() <= 5e-15 * tau, "{line}: reversal at {got:e}");
                assert!((got_y - y).abs() <= 1e-15 * amplitude, "{line}: reversal in {got_y:e}");
            }
            swings.insert(field[..4].join(","));
        }
        assert_eq!(swings.len(), 30);
    }

    #[test]
    fn pieces_join_and_are_few() {
        for zeta in [1.5, 3.0, 7.0, 40.0, 300.0, 1e4, 1e6] {
            for drag in [1e-6, 1e-3, 0.3, 20.0, 1e3, 1e5] {
                for (y0, w0) in [(1.0, 0.0), (1.0, -1.0), (1e-3, -1.0), (-1.0, -1e-3), (0.0, -1.0)]
                {
                    let (pieces, end) = follow(zeta, drag, y0, w0);
                    let case = format!("{zeta} {drag} {y0} {w0}: {} pieces, {end:?}", pieces.len());
                    assert!(pieces.len() <= 60, "{case}");
                    let mut last = (y0, w0);
                    for (i, piece) in pieces.iter().enumerate() {
                        let (y, w) = piece.state(piece.start);
                        assert!(
                            (y - last.0).abs() <= 1e-15 && (w - last.1).abs() <= 1e-15,
                            "{case}"
                        );
                        last = pieces.get(i + 1).map_or(last, |next| piece.state(next.start));
                    }
                    if let End::Reversal { tau, y } = end {
                        let (tau, y) = (f64::from(tau), f64::from(y));
                        let (at_y, at_w) = pieces.last().unwrap().state(tau);
                        assert!(
                            y < 0.0 && at_w.abs() <= 1e-15 && (at_y - y).abs() <= 1e-15,
                            "{case}"
                        );
                    }
                }
            }
        }
    }

    /// A kick that leads almost exactly to the centre: whether it reverses is a matter of the last
    /// digit, but the swing is followed all the same.
    #[test]
    fn kick_onto_the_centre() {
        for zeta in [3.0, 100.0, 1e4] {
            let kick: f64 = -(zeta + f64::sqrt(zeta * zeta - 1.0));
            for n in -5..6 {
                for kappa in [1e-17, 1e-9, 1e-3, 1.0] {
                    let (pieces, _) = follow(zeta, kappa, 1.0, kick * (1.0 + f64::from(n) * 1e-16));
                    assert!(pieces.len() < 60);
                }
            }
        }
    }

    #[test]
    fn ends_for_any_parameters() {
        let values = [0.0, 1e-300, 1.0, 1e5, 1e300, f64::NAN];
        for zeta in values {
            for kappa in values {
                for y in values.into_iter().chain([-1e300, -1.0]) {
                    for w in [0.0, 1.0, -1e-300, -1.0, -1e300, f64::NEG_INFINITY] {
                        let result = solve(zeta, kappa, y, w);
                        let starts = w < 0.0 || w == 0.0 && y >= 0.0;
                        assert!(starts || result.is_err(), "{zeta} {kappa} {y} {w}");
                    }
                }
            }
        }
        assert_eq!(follow(3.0, 0.0, 1.0, -1.0).0.len(), 0);
        assert_eq!(
            follow(3.0, 1.0, 0.0, 0.0),
            (Vec::new(), End::Linear { tau: 0.0, y: 0.0, w: 0.0 })
        );
    }
}
