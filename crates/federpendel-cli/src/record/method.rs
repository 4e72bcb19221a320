//! By which method samples are computed.

use federpendel::article::Formula;
use federpendel::lens::Candidate;
use federpendel::scheme::article::Scheme;
use federpendel::{Motion, Sample};

use crate::progress::Progress;

use super::CHUNK;

/// Steps of a scheme between two signs of progress, some hundredths of a second.
const STEPS_BETWEEN_SIGNS: f64 = 1e7;

/// A method of computing the motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The exact motion, to rounding.
    Exact,
    /// The article's formula as printed.
    ArticlePrinted,
    /// The article's formula, its errors put right.
    ArticleCorrected,
    /// The article's difference scheme.
    ArticleScheme,
}

impl Method {
    /// All methods.
    pub const ALL: [Method; 4] =
        [Method::Exact, Method::ArticlePrinted, Method::ArticleCorrected, Method::ArticleScheme];

    /// Its name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Method::Exact => "exact",
            Method::ArticlePrinted => "article-printed",
            Method::ArticleCorrected => "article-corrected",
            Method::ArticleScheme => "article-scheme",
        }
    }

    /// The same among those that can be held beside the exact motion; none for that itself.
    pub(crate) fn candidate(self) -> Option<Candidate> {
        Candidate::named(self.name())
    }

    /// The method of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }
}

/// Samples by a method other than the exact one.
#[derive(Debug)]
pub(crate) struct Other {
    /// The samples.
    pub samples: Vec<Sample>,
    /// How they were made.
    pub source: Source,
}

/// How samples were made.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Source {
    /// By this equation of the article.
    Equation(&'static str),
    /// By a numeric scheme.
    Steps {
        /// Time step, s.
        time_step: f64,
        /// Whether some samples lie between two steps.
        interpolated: bool,
    },
}

impl Other {
    /// Samples of `motion` at `times` by `method`; none for the exact one.
    pub(super) fn compute(
        method: Method,
        time_step: Option<f64>,
        motion: &Motion,
        times: &[f64],
        progress: &Progress,
    ) -> federpendel::Result<Option<Self>> {
        let (oscillator, release) = (motion.oscillator(), motion.release());
        match method {
            Method::Exact => Ok(None),
            Method::ArticlePrinted => {
                Self::formula(Formula::printed(oscillator, release)?, times, progress)
            }
            Method::ArticleCorrected => {
                Self::formula(Formula::corrected(oscillator, release)?, times, progress)
            }
            Method::ArticleScheme => {
                let time_step = time_step.unwrap_or_else(|| Scheme::default_time_step(oscillator));
                Self::scheme(Scheme::new(oscillator, release, time_step)?, times, progress)
                    .map(Some)
            }
        }
    }

    /// The scheme takes many steps between two samples or few: progress is told after so many steps.
    fn scheme(scheme: Scheme, times: &[f64], progress: &Progress) -> federpendel::Result<Self> {
        let time_step = scheme.time_step();
        let stretch = STEPS_BETWEEN_SIGNS * time_step;
        let mut walk = scheme.walk();
        let mut samples = Vec::with_capacity(times.len());
        let (mut told, mut last) = (0, 0.0);
        for (index, &time) in times.iter().enumerate() {
            while time - last > stretch {
                last += stretch;
                walk.advance(last)?;
                let share = last / times.last().copied().unwrap_or(last);
                // Below the number of samples, since `last` lies before one of them.
                let done = (share * times.len() as f64) as u64;
                progress.advance(done.saturating_sub(told));
                told = told.max(done);
            }
            samples.push(walk.sample(time)?);
            if (index + 1) % CHUNK == 0 {
                progress.advance((index as u64 + 1).saturating_sub(told));
                told = told.max(index as u64 + 1);
            }
        }
        progress.advance((times.len() as u64).saturating_sub(told));
        let source = Source::Steps { time_step, interpolated: walk.interpolated() };
        Ok(Self { samples, source })
    }

    fn formula(
        formula: Formula,
        times: &[f64],
        progress: &Progress,
    ) -> federpendel::Result<Option<Self>> {
        let mut samples = Vec::with_capacity(times.len());
        for chunk in times.chunks(CHUNK) {
            for &time in chunk {
                samples.push(formula.at(time)?);
            }
            progress.advance(chunk.len() as u64);
        }
        Ok(Some(Self { samples, source: Source::Equation(formula.equation().name()) }))
    }
}
