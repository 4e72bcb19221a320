//! The linear part of a swing in closed form, through every regime of damping.
//!
//! Time is τ = ω0 t, velocity w = y′ is in metres, and the swing runs in the negative direction
//! about its own centre y = 0: y″ + 2ζ y′ + y = 0.

/// The closed-form solution operator of y″ + 2ζ y′ + y = 0 (article eq. 46 and the two cases after it,
/// as one formula that stays stable through critical damping).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Propagator {
    zeta: f64,
    /// √|1 − ζ²|, from a discriminant that is accurate however near to critical.
    root: f64,
    underdamped: bool,
}

/// What takes (y0, w0) to (y, w) after some time:
/// y = `yy` y0 + `yw` w0 and w = `ww` w0 − `yw` y0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Transfer {
    pub yy: f64,
    pub yw: f64,
    pub ww: f64,
}

impl Transfer {
    /// From cos φ and sin φ/√(1 − ζ²) of the phase φ = √(1 − ζ²) τ, their hyperbolic kin beyond critical damping,
    /// and `decay` e^(−ζτ).
    #[inline(always)]
    pub fn new(zeta: f64, cos: f64, sinc: f64, decay: f64) -> Self {
        Transfer {
            yy: decay * (cos + zeta * sinc),
            yw: decay * sinc,
            ww: decay * (cos - zeta * sinc),
        }
    }

    #[inline(always)]
    pub fn apply(&self, (y0, w0): (f64, f64)) -> (f64, f64) {
        (self.yy * y0 + self.yw * w0, self.ww * w0 - self.yw * y0)
    }
}

impl Propagator {
    /// `discriminant` is 1 − ζ².
    pub fn new(zeta: f64, discriminant: f64) -> Self {
        Self { zeta, root: discriminant.abs().sqrt(), underdamped: discriminant > 0.0 }
    }

    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// √(1 − ζ²) where the linear part swings.
    pub fn frequency(&self) -> Option<f64> {
        self.underdamped.then_some(self.root)
    }

    /// Rates of the slow and the fast exponential of strong damping, ζ ∓ √(ζ² − 1).
    fn rates(&self) -> (f64, f64) {
        let fast = self.zeta + self.root;
        (1.0 / fast, fast)
    }

    /// The transfer over a time `tau`; slightly negative times are allowed.
    pub fn transfer(&self, tau: f64) -> Transfer {
        let angle = self.root * tau;
        if !self.underdamped && angle > 1.0 {
            // Two decaying exponentials, so that cosh and sinh never overflow.
            let (slow, fast) = self.rates();
            let (e1, e2) = ((-slow * tau).exp(), (-fast * tau).exp());
            let scale = 0.5 / self.root;
            return Transfer {
                yy: (fast * e1 - slow * e2) * scale,
                yw: (e1 - e2) * scale,
                ww: (fast * e2 - slow * e1) * scale,
            };
        }
        let (cos, sin) = if self.underdamped {
            (angle.cos(), angle.sin())
        } else {
            (angle.cosh(), angle.sinh())
        };
        // sin(r τ)/r tends to τ where r vanishes, at critical damping.
        let sinc = if angle.abs() < 1e-8 { tau } else { sin / self.root };
        let decay = (-self.zeta * tau).exp();
        Transfer::new(self.zeta, cos, sinc, decay)
    }

    /// State after `tau` from (y0, w0).
    pub fn state(&self, tau: f64, y0: f64, w0: f64) -> (f64, f64) {
        self.transfer(tau).apply((y0, w0))
    }

    /// Time until the velocity w0 < 0 becomes zero; `None` if it never does.
    ///
    /// From w(τ) = 0: tan(r τ)/r = w0/(ζ w0 + y0), its branch in (0, π/r); overdamped,
    /// the ratio of the two exponentials.
    pub fn time_to_reversal(&self, y0: f64, w0: f64) -> Option<f64> {
        if self.underdamped {
            return Some((-w0 * self.root).atan2(-(self.zeta * w0 + y0)) / self.root);
        }
        let (slow, _) = self.rates();
        let lead = -slow * w0 - y0;
        if lead <= 0.0 {
            return None;
        }
        let ratio = -w0 / lead;
        let grown = 2.0 * self.root * ratio;
        // At critical damping itself the logarithm's argument and the root vanish together.
        Some(if grown == 0.0 { ratio } else { grown.ln_1p() / (2.0 * self.root) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two half steps must equal one whole step, in every regime and next to critical damping.
    #[test]
    fn transfers_compose() {
        for zeta in [0.0, 0.3, 1.0 - 1e-13, 1.0, 1.0 + 1e-13, 1.7, 1e4] {
            let propagator = Propagator::new(zeta, (1.0 - zeta) * (1.0 + zeta));
            for tau in [1e-6, 0.1, 1.3, 4.0] {
                let half = propagator.state(tau / 2.0, 0.7, -0.4);
                let twice = propagator.state(tau / 2.0, half.0, half.1);
                let whole = propagator.state(tau, 0.7, -0.4);
                assert!((twice.0 - whole.0).abs() < 4e-16, "{zeta} {tau}");
                assert!((twice.1 - whole.1).abs() < 4e-15, "{zeta} {tau}");
            }
        }
    }

    /// From y = 0 the reversal is at τ = artanh(r/ζ)/r; near critical damping 1/ζ + r²/(3ζ³) to
    /// fourth order in r = √(ζ² − 1), which needs no difference of nearly equal numbers.
    #[test]
    fn reversals_come_in_time_next_to_critical_damping() {
        for excess in [1e-30, 1e-20, 1e-18, 1e-16, 1e-14, 1e-12, 1e-10] {
            let zeta = 1.0 + 0.5 * excess;
            let found = Propagator::new(zeta, -excess).time_to_reversal(0.0, -0.7).unwrap();
            let expected = 1.0 / zeta + excess / 3.0;
            assert!((found / expected - 1.0).abs() < 4e-16, "{excess:e}: {found} {expected}");
        }
    }

    #[test]
    fn the_velocity_vanishes_at_the_reversal() {
        for zeta in [0.0, 0.3, 1.0 - 1e-13, 1.0, 1.0 + 1e-13, 1.7, 1e3] {
            let propagator = Propagator::new(zeta, (1.0 - zeta) * (1.0 + zeta));
            for y0 in [-1.0, 0.0, 1e-5] {
                let tau = propagator.time_to_reversal(y0, -1.0).unwrap();
                let (y, w) = propagator.state(tau, y0, -1.0);
                assert!(y < 0.0 && w.abs() < 1e-15, "{zeta} {y0}: {tau} {y} {w}");
            }
        }
        let overdamped = Propagator::new(2.0, -3.0);
        assert_eq!(overdamped.time_to_reversal(1.0, -1.0), None);
    }
}
