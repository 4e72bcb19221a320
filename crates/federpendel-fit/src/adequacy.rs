//! Whether the oscillator fits at all: the residuals searched for what a wrong model leaves in
//! them.
//!
//! Not χ² against a stated σ: noise that is larger than stated, or that hangs together, is no fault
//! of the model. A wrong model leaves a pattern that goes with the motion: a phase that drifts, an
//! amplitude that goes astray, a shape. Each is a small linear model of the residuals beside the
//! parameters themselves; what it explains is judged by its significance against the noise that is
//! left and by its size against the motion.

use crate::extremes::{fast_noise, look, spread};
use crate::least_squares::Minimum;
use crate::noise::{Excess, excess};
use crate::patterns::{Patterns, square};
use crate::problem::{LAWS, Loss, OMEGA, Problem};

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

impl Adequacy {
    /// The pattern that makes up a large part of the residuals, where the model describes the motion
    /// all the same: standard errors, which are those of noise, do not cover what it does to the values.
    pub fn slight(&self) -> Option<&Finding> {
        let main = |finding: &&Finding| finding.share > SLIGHT && finding.significance > NO_NOISE;
        self.findings.iter().find(main).filter(|_| self.adequate)
    }
}

/// A pattern counts from this χ² per degree of freedom on: beyond what noise does, its spectrum
/// being an estimate.
const SIGNIFICANT: f64 = 6.0;
/// A pattern with this share of the motion means that the model is wrong, not merely not perfect.
const GRAVE: f64 = 0.04;
/// And this share of the residuals: else noise hides the motion, not a wrong model.
const MAIN: f64 = 0.3;

/// A pattern that is not grave is said with the verdict from this share of the residuals on: weakly cubic springs begin
/// to look like further laws of friction at a quarter.
const SLIGHT: f64 = 0.2;
/// And so significant it is no noise that hangs together over much of the recording.
const NO_NOISE: f64 = 100.0;

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
    let creeps = minimum.at[LAWS[0]] > STRONG * omega;
    findings
        .extend(residual(problem, &patterns).or_else(|| swinging(&patterns).filter(|_| creeps)));
    // The others say more than what is merely left.
    let merely = |finding: &Finding| finding.fault == Fault::Residual;
    findings.sort_by(|a, b| merely(a).cmp(&merely(b)).then(b.share.total_cmp(&a.share)));
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
        Loss::Huber | Loss::Tukey => spread(patterns.residuals.iter().copied()),
    };
    let size = rms / (patterns.widest() / values.len() as f64).sqrt();
    let beyond = rms / fast_noise(values).max(f64::MIN_POSITIVE);
    (size > LARGE && beyond > BEYOND_NOISE).then(|| unexplained(size, beyond))
}

/// What the fit leaves altogether: so large beside the widest swing, so many times the noise from value to value.
fn unexplained(size: f64, beyond: f64) -> Finding {
    Finding {
        fault: Fault::Residual,
        size,
        share: 1.0,
        significance: beyond * beyond,
        effect: size,
        grave: true,
    }
}

/// From this damping ratio on a motion swings no more than a few times before it is too small to be seen.
const STRONG: f64 = 0.5;
/// So many turns beyond that are a motion of their own.
const TURNS: usize = 5;

/// Residuals that swing, where the motion that was fitted does not: it is not the one that was recorded.
fn swinging(patterns: &Patterns) -> Option<Finding> {
    let seen = look(&patterns.times, &patterns.residuals)?;
    let rms = (patterns.cost / patterns.residuals.len() as f64).sqrt();
    let size = (patterns.cost / patterns.widest()).sqrt();
    let beyond = rms / fast_noise(&patterns.residuals).max(f64::MIN_POSITIVE);
    (seen.extremes.len() >= TURNS && beyond > BEYOND_NOISE).then(|| unexplained(size, beyond))
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
