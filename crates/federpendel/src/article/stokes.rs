//! Stokes friction alone: the article's section 2.

use super::{Complex, Derivatives, Equation, Formula, Shape, require};
use crate::error::{Error, Result};
use crate::friction::Mix;
use crate::oscillator::{Oscillator, Regime, State};

/// γ and ω of (41), also (47), 1/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DampedRates {
    /// Damping rate γ = D/(2m), 1/s.
    pub damping_rate: f64,
    /// Angular frequency of the damped oscillation ω = √(ω0² − D²/(4m²)), 1/s.
    pub angular_frequency: f64,
}

/// (36): the roots λ1, λ2 = −D/(2m) ± √(D²/(4m²) − ω0²) of the characteristic equation (35), 1/s;
/// below critical damping they are the conjugate pair (37), without friction (24).
///
/// The slow root of strong damping is evaluated as ω0²/λ2, where the printed sum would cancel.
///
/// ```
/// use federpendel::article::eq_36;
/// use federpendel::{Oscillator, Stokes};
///
/// let [slow, fast] = eq_36(&Oscillator::new(1.0, 6.0, Stokes::new(5.0)?)?)?;
/// assert!((slow.re - -2.0).abs() < 1e-15 && (fast.re - -3.0).abs() < 1e-15);
/// # Ok::<(), federpendel::Error>(())
/// ```
///
/// # Errors
/// [`Error::NotInArticle`] with Coulomb or Newton friction.
pub fn eq_36(oscillator: &Oscillator) -> Result<[Complex; 2]> {
    require_linear(oscillator)?;
    let gamma = oscillator.damping_rate();
    let root = root_of_discriminant(oscillator);
    Ok(if f64::from(oscillator.reduced().discriminant()) > 0.0 {
        [Complex::new(-gamma, root), Complex::new(-gamma, -root)]
    } else {
        let fast = -(gamma + root);
        let omega0 = oscillator.angular_frequency();
        [(omega0 * (omega0 / fast)).into(), fast.into()]
    })
}

/// (41), also (47): the damping rate γ and the frequency ω of the damped oscillation.
///
/// # Errors
/// [`Error::NotInArticle`] with Coulomb or Newton friction, [`Error::NoSuchSolution`] at and above
/// critical damping, where ω is not real.
pub fn eq_41(oscillator: &Oscillator) -> Result<DampedRates> {
    require_linear(oscillator)?;
    require_regime(oscillator, "41", &[Regime::Undamped, Regime::Underdamped])?;
    Ok(DampedRates {
        damping_rate: oscillator.damping_rate(),
        angular_frequency: root_of_discriminant(oscillator),
    })
}

/// (46): x = e^(−γt) (x0 cos ωt + ((v0 + γx0)/ω) sin ωt), m, below critical damping.
///
/// # Errors
/// As [`eq_41`], and [`Error::Parameter`] for a release that is not finite.
pub fn eq_46(oscillator: &Oscillator, release: State) -> Result<Formula> {
    require_linear(oscillator)?;
    require_regime(oscillator, "46", &[Regime::Undamped, Regime::Underdamped])?;
    let shape = Underdamped::new(oscillator, release)?;
    Ok(Formula { equation: Equation::Eq46, shape: Shape::Underdamped(shape) })
}

/// The overdamped solution among the remarks after (47): x = C1 e^(λ1t) + C2 e^(λ2t), m, with the
/// roots (36). The article leaves the constants open; the release gives C1 = (v0 − λ2x0)/(λ1 − λ2)
/// and C2 = x0 − C1.
///
/// # Errors
/// [`Error::NotInArticle`] with Coulomb or Newton friction, [`Error::NoSuchSolution`] at and below
/// critical damping, [`Error::Parameter`] for a release that is not finite.
pub fn overdamped(oscillator: &Oscillator, release: State) -> Result<Formula> {
    require_linear(oscillator)?;
    require_regime(oscillator, "overdamped", &[Regime::Overdamped])?;
    let shape = Aperiodic::new(oscillator, release)?;
    Ok(Formula { equation: Equation::Overdamped, shape: Shape::Aperiodic(shape) })
}

/// The critically damped solution among the remarks after (47): x = (C1 + C2 t) e^(λt), m, with
/// λ = −γ. The article leaves the constants open; the release gives C1 = x0, C2 = v0 + γx0.
///
/// Critical damping is rarely hit to the last bit: what [`Regime::Critical`] calls so is taken with
/// the roots that it has.
///
/// # Errors
/// As [`overdamped`], for the other regimes.
pub fn critical(oscillator: &Oscillator, release: State) -> Result<Formula> {
    require_linear(oscillator)?;
    require_regime(oscillator, "critical", &[Regime::Critical])?;
    let shape = if f64::from(oscillator.reduced().discriminant()) > 0.0 {
        Shape::Underdamped(Underdamped::new(oscillator, release)?)
    } else {
        Shape::Aperiodic(Aperiodic::new(oscillator, release)?)
    };
    Ok(Formula { equation: Equation::Critical, shape })
}

/// √|ω0² − γ²|, 1/s: the ω of (41), or the root in (36).
fn root_of_discriminant(oscillator: &Oscillator) -> f64 {
    let reduced = oscillator.reduced();
    (reduced.discriminant().abs().sqrt() * reduced.omega0).into()
}

fn require_linear(oscillator: &Oscillator) -> Result<()> {
    require(oscillator, |mix| mix == Mix { stokes: mix.stokes, ..Mix::default() })
}

fn require_regime(oscillator: &Oscillator, solution: &'static str, fits: &[Regime]) -> Result<()> {
    let regime = oscillator.regime();
    if fits.contains(&regime) { Ok(()) } else { Err(Error::NoSuchSolution { solution, regime }) }
}

/// x = e^(−γt) (C1 cos ωt + C2 sin ωt), (40); with γ = 0 it is (10).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Underdamped {
    gamma: f64,
    omega: f64,
    cosine: f64,
    sine: f64,
}

impl Underdamped {
    /// The constants (42), (45) of the release; (17), (19) without friction.
    pub(super) fn new(oscillator: &Oscillator, release: State) -> Result<Self> {
        let State { position, velocity } = State::new(release.position, release.velocity)?;
        let gamma = oscillator.damping_rate();
        let omega = root_of_discriminant(oscillator);
        Ok(Self { gamma, omega, cosine: position, sine: (velocity + gamma * position) / omega })
    }

    pub(super) fn at(&self, time: f64) -> Derivatives {
        let Self { gamma, omega, cosine, sine } = *self;
        let (sin, cos) = (omega * time).sin_cos();
        let decay = (-gamma * time).exp();
        let position = decay * (cosine * cos + sine * sin);
        // (43): the derivative of the bracket, and γ times the whole.
        let velocity = decay * omega * (sine * cos - cosine * sin) - gamma * position;
        let omega0_squared = omega * omega + gamma * gamma;
        let acceleration = -2.0 * gamma * velocity - omega0_squared * position;
        Derivatives { position, velocity, acceleration }
    }
}

/// x = x0 e^(λ1t) + (v0 − λ1x0) (e^(λ1t) − e^(λ2t))/(λ1 − λ2): the overdamped solution, arranged so
/// that it runs into the critically damped one, x0 e^(λt) + (v0 − λx0) t e^(λt), without cancelling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Aperiodic {
    slow: f64,
    fast: f64,
    /// λ1 − λ2 = 2√(γ² − ω0²), kept apart because the roots may lie close together.
    gap: f64,
    position: f64,
    excess: f64,
}

impl Aperiodic {
    fn new(oscillator: &Oscillator, release: State) -> Result<Self> {
        let State { position, velocity } = State::new(release.position, release.velocity)?;
        let [slow, fast] = eq_36(oscillator)?.map(|root| root.re);
        let gap = 2.0 * root_of_discriminant(oscillator);
        Ok(Self { slow, fast, gap, position, excess: velocity - slow * position })
    }

    pub(super) fn at(&self, time: f64) -> Derivatives {
        let Self { slow, fast, gap, position: start, excess } = *self;
        let (slow_decay, fast_decay) = ((slow * time).exp(), (fast * time).exp());
        // (1 − e^(−gt))/g, whose limit for a vanishing gap g is t.
        let quotient = if gap == 0.0 { time } else { -(-gap * time).exp_m1() / gap };
        let position = slow_decay * (start + excess * quotient);
        let velocity = slow * position + excess * fast_decay;
        let acceleration = slow * velocity + fast * excess * fast_decay;
        Derivatives { position, velocity, acceleration }
    }
}
