//! Whether the oscillator fits at all: the residuals searched for what a wrong model leaves in
//! them.
//!
//! Not χ² against a stated σ: noise that is larger than stated, or that hangs together, is no fault
//! of the model. A wrong model leaves a pattern that goes with the motion: a phase that drifts, an
//! amplitude that goes astray, a shape. Each is a small linear model of the residuals beside the
//! parameters themselves; what it explains is judged by its significance against the noise that is
//! left and by its size against the motion.

use nalgebra::{DMatrix, DVector};

use crate::Quantity;
use crate::extremes::median;
use crate::least_squares::Minimum;
use crate::noise::{Excess, excess};
use crate::problem::{LAWS, Loss, OMEGA, Problem, Vector};

/// What is wrong with the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fault {
    /// The period is longer at large amplitudes, as that of a pendulum is.
    Softening,
    /// The period is shorter at large amplitudes.
    Hardening,
    /// The period drifts in another way.
    PeriodDrift,
    /// The losses of amplitude are not those of any mix of the laws.
    Losses,
    /// The zero of the sensor drifts.
    ZeroDrift,
    /// The swings have another shape: harmonics, as of a sensor that is not linear.
    Shape,
    /// What is left is far more than the noise of the sensor, and none of the other faults.
    Residual,
}

/// A pattern found in the residuals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finding {
    /// What it points to.
    pub fault: Fault,
    /// Its root mean square over that of the widest swing.
    pub size: f64,
    /// Its share of the sum of squares of the residuals.
    pub share: f64,
    /// χ² per degree of freedom, against the noise that is left.
    pub significance: f64,
    /// Softening and hardening: the relative change of the frequency from the smallest swings to the
    /// widest. Else the largest value of the pattern, over that of the motion.
    pub effect: f64,
    /// Whether it is so large that no mix of the laws describes the motion.
    pub grave: bool,
}

/// What the residuals say about the model.
#[derive(Debug, Clone, PartialEq)]
pub struct Adequacy {
    /// Whether the oscillator with the mix of the verdict describes the motion.
    pub adequate: bool,
    /// Patterns in the residuals, the largest first.
    pub findings: Vec<Finding>,
    /// Root mean square of the residuals over that of the widest swing.
    pub residual: f64,
}

/// A pattern counts from this χ² per degree of freedom on: beyond what noise does, its spectrum
/// being an estimate.
const SIGNIFICANT: f64 = 6.0;
/// A pattern with this share of the motion means that the model is wrong, not merely not perfect.
const GRAVE: f64 = 0.04;
/// And this share of the residuals: else noise hides the motion, not a wrong model.
const MAIN: f64 = 0.3;

/// Searches the residuals at `minimum`.
pub fn adequacy(problem: &mut Problem, minimum: &Minimum, free: &[bool; 7]) -> Option<Adequacy> {
    let patterns = Patterns::new(problem, minimum, free)?;
    let families = [
        (Fault::Softening, patterns.softening()),
        (Fault::PeriodDrift, patterns.along(&patterns.slope, 4)),
        (Fault::Losses, patterns.along(&patterns.swing, 5)),
        (Fault::ZeroDrift, patterns.along(&vec![1.0; patterns.swing.len()], 3)),
        (Fault::Shape, patterns.shape()),
    ];
    let everything: Vec<&Vec<f64>> = families.iter().flat_map(|(_, columns)| columns).collect();
    let left = patterns.explain(&everything)?.left;
    let step = patterns.span / (left.len() - 1) as f64;
    let omega = minimum.at[OMEGA];
    let excess = excess(&left, step, omega, omega);
    let used = everything.len() + 7;
    let unit = square(&left) / left.len().saturating_sub(used).max(1) as f64 * excess;
    let motion = patterns.widest();
    let mut findings = Vec::new();
    for (fault, columns) in &families {
        let found = patterns.explain(&columns.iter().collect::<Vec<_>>())?;
        let drop = (patterns.cost - square(&found.left)).max(0.0);
        let significance = drop / (unit * columns.len() as f64);
        let (size, share) = ((drop / motion).sqrt(), drop / patterns.cost);
        if significance.is_nan() || significance < SIGNIFICANT {
            continue;
        }
        let (fault, effect) = patterns.named(*fault, &found);
        let grave = size > GRAVE && share > MAIN;
        findings.push(Finding { fault, size, share, significance, effect, grave });
    }
    findings.extend(residual(problem, &patterns));
    findings.sort_by(|a, b| b.share.total_cmp(&a.share));
    // The others say more.
    findings.sort_by_key(|finding| finding.fault == Fault::Residual);
    prefer_amplitude(&mut findings);
    let adequate = !findings.iter().any(|finding| finding.grave);
    Some(Adequacy { adequate, findings, residual: (patterns.cost / motion).sqrt() })
}

/// Residuals of more than this share of the motion are too large
const LARGE: f64 = 0.05;
/// if they are so many times as large as the noise from value to value.
const BEYOND_NOISE: f64 = 5.0;

/// Residuals that are far larger than what the sensor adds from value to value, whatever their pattern. Where
/// sampling is coarse the motion is part of that, and nothing is found.
fn residual(problem: &Problem, patterns: &Patterns) -> Option<Finding> {
    let values = &problem.values;
    let rms = match problem.loss.0 {
        Loss::Squares => (patterns.cost / values.len() as f64).sqrt(),
        // What a robust loss leaves aside is no fault of the model.
        Loss::Huber | Loss::Tukey => {
            let mut sizes: Vec<f64> = patterns.residuals.iter().map(|r| r.abs()).collect();
            1.4826 * median(&mut sizes)?
        }
    };
    let size = rms / (patterns.widest() / values.len() as f64).sqrt();
    // Of white noise x₀ − 2x₁ + x₂ has the variance 6σ².
    let second = |w: &[f64]| (w[0] - 2.0 * w[1] + w[2]).abs();
    let mut seconds: Vec<f64> = values.windows(3).map(second).collect();
    let noise = 1.4826 * median(&mut seconds)? / 6f64.sqrt();
    let beyond = rms / noise.max(f64::MIN_POSITIVE);
    (size > LARGE && beyond > BEYOND_NOISE).then_some(Finding {
        fault: Fault::Residual,
        size,
        share: 1.0,
        significance: beyond * beyond,
        effect: size,
        grave: true,
    })
}

/// A drift of the period that goes with the amplitude is said once, as that.
fn prefer_amplitude(findings: &mut Vec<Finding>) {
    let drift = findings.iter().find(|f| f.fault == Fault::PeriodDrift).map(|f| f.share);
    let soft = |f: &Finding| matches!(f.fault, Fault::Softening | Fault::Hardening);
    let amplitude = findings.iter().find(|f| soft(f)).map(|f| f.share);
    if let (Some(drift), Some(amplitude)) = (drift, amplitude) {
        // One column that does half of what four do is the simpler reason.
        let amplitude_says_it = amplitude > 0.5 * drift;
        findings
            .retain(|f| if amplitude_says_it { f.fault != Fault::PeriodDrift } else { !soft(f) });
    }
}

/// The noise of the residuals at `minimum`, with that of a drifting period told apart.
pub fn noise(problem: &mut Problem, minimum: &Minimum, free: &[bool; 7]) -> Option<Excess> {
    let patterns = Patterns::new(problem, minimum, free)?;
    let mut columns = patterns.along(&patterns.slope, 4);
    columns.extend(patterns.softening());
    let left = patterns.explain(&columns.iter().collect::<Vec<_>>())?.left;
    let omega = minimum.at[OMEGA];
    Some(Excess::new(&patterns.residuals, &left, columns.len(), problem.step(), omega))
}

fn square(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum()
}

/// What patterns are made of.
struct Patterns {
    /// The motion, from its zero, and its derivative.
    swing: Vec<f64>,
    slope: Vec<f64>,
    /// Position and velocity over ω0: the square of the amplitude.
    amplitude2: Vec<f64>,
    /// Times from −1 to 1.
    unit_times: Vec<f64>,
    times: Vec<f64>,
    span: f64,
    residuals: Vec<f64>,
    cost: f64,
    base: Vec<Vec<f64>>,
}

/// Residuals with some patterns taken away.
struct Explained {
    weights: Vec<f64>,
    left: Vec<f64>,
}

impl Patterns {
    fn new(problem: &mut Problem, minimum: &Minimum, free: &[bool; 7]) -> Option<Self> {
        let (p, ending) = (&minimum.at, minimum.ending);
        let residuals = problem.residuals(p, ending)?;
        let mut bare: Vector = *p;
        bare[6] = 0.0;
        let x = problem.model(&bare, ending, Quantity::Position)?;
        let v = problem.model(&bare, ending, Quantity::Velocity)?;
        let a = problem.model(&bare, ending, Quantity::Acceleration)?;
        let (omega, rate) = (p[OMEGA], p[LAWS[0]]);
        let jerk = |(v, a): (&f64, &f64)| -omega * omega * v - 2.0 * rate * a;
        let amplitude2 =
            x.iter().zip(&v).map(|(x, v)| x * x + (v / omega).powi(2)).collect::<Vec<_>>();
        let (swing, slope) = match problem.quantity {
            Quantity::Position => (x, v),
            Quantity::Velocity => (v, a),
            Quantity::Acceleration => {
                let slope = v.iter().zip(&a).map(jerk).collect();
                (a, slope)
            }
        };
        let times = problem.times.clone();
        let span = times[times.len() - 1] - times[0];
        let unit_times = times.iter().map(|t| 2.0 * (t - times[0]) / span - 1.0).collect();
        let jacobian = problem.derivatives(p, ending)?;
        let base =
            (0..7).filter(|&i| free[i]).map(|i| jacobian.column(i).to_vec()).collect::<Vec<_>>();
        let cost = square(&residuals);
        Some(Self { swing, slope, amplitude2, unit_times, times, span, residuals, cost, base })
    }

    /// The sum of squares of as many values of a swing that stays as wide as the widest.
    fn widest(&self) -> f64 {
        let widest = self.swing.iter().fold(0.0f64, |widest, x| widest.max(x.abs()));
        0.5 * widest * widest * self.swing.len() as f64
    }

    /// `direction` times Legendre polynomials of time, from the first degree to `highest`.
    fn along(&self, direction: &[f64], highest: usize) -> Vec<Vec<f64>> {
        let column = |degree| {
            let pairs = self.unit_times.iter().zip(direction);
            pairs.map(|(&u, d)| legendre(degree, u) * d).collect()
        };
        (1..=highest).map(column).collect()
    }

    /// A phase that runs ahead in proportion to the square of the amplitude.
    fn softening(&self) -> Vec<Vec<f64>> {
        let widest = self.amplitude2.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let mut ahead = 0.0;
        let mut before = self.times[0];
        let parts = self.times.iter().zip(&self.amplitude2).zip(&self.slope);
        let column = parts.map(|((&time, a2), slope)| {
            ahead += (time - before) * a2 / widest;
            before = time;
            slope * ahead
        });
        vec![column.collect()]
    }

    /// The second and third powers of the motion.
    fn shape(&self) -> Vec<Vec<f64>> {
        let widest = self.swing.iter().fold(f64::MIN_POSITIVE, |w, x| w.max(x.abs()));
        [2, 3].map(|n| self.swing.iter().map(|x| x * (x / widest).powi(n - 1)).collect()).to_vec()
    }

    /// Least squares of the residuals on the derivatives of the fit and on `columns`.
    fn explain(&self, columns: &[&Vec<f64>]) -> Option<Explained> {
        let all: Vec<&Vec<f64>> = self.base.iter().chain(columns.iter().copied()).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let scale: Vec<f64> = all.iter().map(|c| dot(c, c).sqrt().max(f64::MIN_POSITIVE)).collect();
        let k = all.len();
        let mut matrix = DMatrix::zeros(k, k);
        for i in 0..k {
            for j in 0..=i {
                let product = dot(all[i], all[j]) / (scale[i] * scale[j]);
                (matrix[(i, j)], matrix[(j, i)]) = (product, product);
            }
            // What the derivatives say already is left to them.
            matrix[(i, i)] += 1e-9;
        }
        let right = DVector::from_fn(k, |i, _| dot(all[i], &self.residuals) / scale[i]);
        let solved = matrix.cholesky()?.solve(&right);
        let mut left = self.residuals.clone();
        for (column, weight) in all.iter().zip(solved.iter().zip(&scale).map(|(w, s)| w / s)) {
            left.iter_mut().zip(column.iter()).for_each(|(r, c)| *r -= weight * c);
        }
        let weights = (self.base.len()..k).map(|i| solved[i] / scale[i]).collect();
        Some(Explained { weights, left })
    }

    /// The fault by its name and the effect in its own measure.
    fn named(&self, fault: Fault, found: &Explained) -> (Fault, f64) {
        if fault == Fault::Softening {
            // The weight is the relative change of frequency at the widest swing.
            let change = found.weights[0];
            return (if change < 0.0 { fault } else { Fault::Hardening }, change.abs());
        }
        let largest =
            |values: &mut dyn Iterator<Item = f64>| values.fold(0.0f64, |l, x| l.max(x.abs()));
        let pattern =
            largest(&mut self.residuals.iter().zip(&found.left).map(|(r, left)| r - left));
        (fault, pattern / largest(&mut self.swing.iter().copied()))
    }
}

/// Legendre's polynomial of `degree` by Bonnet's recursion.
fn legendre(degree: usize, u: f64) -> f64 {
    let (mut before, mut now) = (1.0, u);
    for n in 1..degree {
        let n = n as f64;
        (before, now) = (now, ((2.0 * n + 1.0) * u * now - n * before) / (n + 1.0));
    }
    if degree == 0 { before } else { now }
}
