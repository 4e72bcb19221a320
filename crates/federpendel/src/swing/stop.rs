//! A throw that dry friction ends in its first swing, with an offset larger than all the mass can reach.
//!
//! The centre of that swing lies so far off that distances from it would lose the digits of the motion. So
//! this follows the distance d from the start, in the direction of motion, with u = d′:
//!
//! u′ = −b − d − 2ζu − κu², d = 0, u = u0 at the start, b > 0 the pull of spring and friction there,
//!
//! as a Taylor series in the time over h, 1/h being the fastest rate at which u can change: then all
//! coefficients are about as large as u0, whatever the units are.

use crate::swing::NotFollowed;
use crate::swing::piece::{DEGREE, Piece, polynomial};

/// The constants of the swing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stop {
    pub zeta: f64,
    pub kappa: f64,
    /// Pull at the start, m.
    pub pull: f64,
}

/// How it ends: after a time, ω0 t, so far (m) from its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stopped {
    pub tau: f64,
    pub distance: f64,
}

/// Truncation allowed, relative to the velocity.
const TRUNCATION: f64 = 1e-17;
/// Pieces that no swing needs: each takes the velocity down by a good part.
const MOST_PIECES: usize = 10_000;

impl Stop {
    /// Follows the swing from `speed`, m; leaves its pieces, in which the position is −d.
    ///
    /// # Errors
    /// [`NotFollowed`] if it comes to no end.
    pub fn solve(&self, speed: f64, pieces: &mut Vec<Piece>) -> Result<Stopped, NotFollowed> {
        let (mut tau, mut distance, mut speed) = (0.0, 0.0, speed);
        for _ in 0..MOST_PIECES {
            let pull = self.pull + distance;
            let scale = 1.0 / (pull / speed + 2.0 * self.zeta + self.kappa * speed + 1.0);
            let (d, u) = self.expand(distance, speed, scale);
            let reach = reach(&u);
            pieces.push(Piece {
                start: tau,
                center: tau,
                inverse_scale: 1.0 / scale,
                position: d.map(|c| -c),
                velocity: u.map(|c| -c),
            });
            let ends = polynomial::<false>(&u, reach) <= 0.0;
            let step = if ends { root(&u, reach) } else { reach };
            tau += scale * step;
            distance = polynomial::<false>(&d, step);
            if ends {
                return Ok(Stopped { tau, distance });
            }
            speed = polynomial::<false>(&u, step);
        }
        Err(NotFollowed)
    }

    /// Coefficients of d and u in the time over `scale`.
    fn expand(
        &self,
        distance: f64,
        speed: f64,
        scale: f64,
    ) -> ([f64; DEGREE + 1], [f64; DEGREE + 1]) {
        let (mut d, mut u) = ([0.0; DEGREE + 1], [0.0; DEGREE + 1]);
        (d[0], u[0]) = (distance, speed);
        for n in 0..DEGREE {
            let square: f64 = (0..=n).map(|j| u[j] * u[n - j]).sum();
            let pull = if n == 0 { self.pull } else { 0.0 };
            let slope = -(pull + d[n] + 2.0 * self.zeta * u[n] + self.kappa * square);
            let share = scale / (n + 1) as f64;
            (d[n + 1], u[n + 1]) = (share * u[n], share * slope);
        }
        (d, u)
    }
}

/// How far the series of u may be trusted, from its last two coefficients; at most 2, where what is left of
/// the swing is nearly a parabola.
fn reach(u: &[f64; DEGREE + 1]) -> f64 {
    let within = |n: usize| (TRUNCATION * u[0] / u[n].abs()).powf(1.0 / n as f64);
    within(DEGREE).min(within(DEGREE - 1)).min(2.0)
}

/// Where u falls through zero before `high`.
fn root(u: &[f64; DEGREE + 1], mut high: f64) -> f64 {
    let mut low = 0.0;
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        if polynomial::<false>(u, middle) > 0.0 { low = middle } else { high = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stopped(zeta: f64, kappa: f64, pull: f64, speed: f64) -> Stopped {
        Stop { zeta, kappa, pull }.solve(speed, &mut Vec::new()).unwrap()
    }

    #[track_caller]
    fn assert_close(found: f64, expected: f64) {
        assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
    }

    /// Against the closed form without drag: d = −b(1 − cos τ) + u0 sin τ, which ends at tan τ = u0/b.
    #[test]
    fn a_spring_with_dry_friction_stops_where_the_closed_form_says() {
        for (pull, speed) in [(2.0, 1.0), (1e3, 1.0), (1e30, 1e-20)] {
            let Stopped { tau, distance } = stopped(0.0, 0.0, pull, speed);
            assert_close(tau, f64::atan2(speed, pull));
            // √(b² + u0²) − b without cancellation.
            assert_close(distance, speed / (pull.hypot(speed) / speed + pull / speed));
        }
    }

    /// Against the first integral where the spring is negligible: κd = ½ ln(1 + κu0²/b).
    #[test]
    fn strong_drag_stops_where_the_first_integral_says() {
        for (kappa, pull, speed) in [(1e3_f64, 1e9, 1e-3), (1e20, 1e9, 1e-5)] {
            let expected = 0.5 * (kappa * speed * speed / pull).ln_1p() / kappa;
            assert!((stopped(0.0, kappa, pull, speed).distance / expected - 1.0).abs() < 1e-9);
        }
    }

    /// Against the exponential where the spring is negligible: τ = ln(1 + 2ζu0/b)/(2ζ).
    #[test]
    fn strong_damping_stops_when_the_exponential_says() {
        let tau = stopped(1e4, 0.0, 1e8, 1e3).tau;
        assert!((tau / ((2e7f64 / 1e8).ln_1p() / 2e4) - 1.0).abs() < 1e-8);
    }
}
