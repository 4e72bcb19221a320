//! The curves of a picture: on a grid of their own, however few samples the record has.

use federpendel::{Sample, motion};

use super::{Other, Record, Source};
use crate::progress::Progress;

/// Points for each period, so that a line through them looks round.
const PER_PERIOD: f64 = 200.0;

/// Fewest points of a picture.
const FEWEST: f64 = 2001.0;

/// Most points: more cannot be told apart.
const MOST: f64 = 20_000.0;

/// Most steps of a scheme that are taken once more for a picture.
const CHEAP_STEPS: f64 = 1e6;

/// What a picture shows.
pub(crate) struct Drawn {
    /// The motion.
    pub exact: Vec<Sample>,
    /// The method asked for, if that is another.
    pub other: Option<Vec<Sample>>,
}

impl Record {
    /// The curves, finely sampled.
    ///
    /// # Errors
    /// Whatever the core refuses.
    pub(crate) fn drawn(&self, progress: &Progress) -> federpendel::Result<Drawn> {
        let periods = self.motion.oscillator().frequency().unwrap_or(0.0) * self.duration;
        let points = (PER_PERIOD * periods).ceil().clamp(FEWEST, MOST) as usize;
        let times = motion::even_times(self.duration, points)?;
        let exact = self.motion.samples(&times)?;
        let other = self.other.as_ref().map(|other| self.finer(other, &times, progress));
        Ok(Drawn { exact, other })
    }

    /// Another method at `times`; its samples in the record where that would take long, or where it
    /// runs away in between.
    fn finer(&self, other: &Other, times: &[f64], progress: &Progress) -> Vec<Sample> {
        let time_step = match other.source {
            Source::Equation(_) => None,
            Source::Steps { time_step, .. } => Some(time_step),
        };
        let cheap = time_step.is_none_or(|step| self.duration / step <= CHEAP_STEPS);
        let finer =
            cheap.then(|| Other::compute(self.method, time_step, &self.motion, times, progress));
        match finer {
            Some(Ok(Some(finer))) => finer.samples,
            _ => {
                let stride = other.samples.len().div_ceil(MOST as usize).max(1);
                other.samples.iter().step_by(stride).copied().collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::{self, Field};
    use crate::record::Method;

    #[test]
    fn few_samples_make_no_jagged_curve() {
        for (method, duration, points) in [
            (Method::Exact, "5 s", 2001),
            (Method::ArticleScheme, "50 s", 10_066),
            (Method::ArticlePrinted, "1000 s", 20_000),
        ] {
            let mut draft = experiment::parse(experiment::BUILT_IN.as_bytes()).unwrap();
            draft.override_with([(Field::Samples, "20"), (Field::Duration, duration)]).unwrap();
            let experiment = draft.resolve(1000).unwrap();
            let progress = Progress::silent();
            let record = Record::compute(experiment, method, None, &progress).unwrap();
            let drawn = record.drawn(&progress).unwrap();
            assert_eq!((record.exact.len(), drawn.exact.len()), (20, points), "{duration}");
            let other = drawn.other.map(|other| other.len());
            assert_eq!(other, (method != Method::Exact).then_some(points));
            let last = drawn.exact.last().unwrap();
            assert_eq!(last.time, record.duration);
        }
    }
}
