//! The way through a recording, swing after swing.

use pulp::{Simd, WithSimd};

use super::course::{Course, Rest, TurningPoint};
use super::piece::Piece;
use super::record::{Clock, Record};
use super::series::{Series, State};
use super::start::{Frame, Reduced, Start, VALUE};
use super::{ModelError, Parameters, Stop};
use crate::recording::Quantity;

/// Series that are made before a motion is given up.
const MOST_STEPS: usize = 200_000;

/// Fills `record` with `quantity`. `D` directions of derivatives give `K` columns: none and the values alone, or 4 and
/// the values with all derivatives.
pub(super) fn walk<const D: usize, const K: usize>(
    parameters: &Parameters,
    stop: Stop,
    quantity: Quantity,
    record: Record<K>,
) -> Result<Course, ModelError> {
    let reduced = Reduced::new(parameters, stop);
    let start = Start::release(parameters);
    let course = Course::default();
    arch().dispatch(Walk::<D, K> {
        reduced,
        quantity,
        start,
        record,
        course,
        duration: std::f64::consts::PI,
        steps: 0,
    })
}

/// The vector instructions of this machine, as in the core; in a browser plain numbers.
fn arch() -> pulp::Arch {
    #[cfg(target_family = "wasm")]
    return pulp::Arch::Scalar;
    #[cfg(not(target_family = "wasm"))]
    pulp::Arch::new()
}

struct Walk<'a, const D: usize, const K: usize> {
    reduced: Reduced,
    quantity: Quantity,
    start: Start,
    record: Record<'a, K>,
    course: Course,
    /// How long the swing before took, ω0 t; the next takes about as long.
    duration: f64,
    steps: usize,
}

impl<const D: usize, const K: usize> WithSimd for Walk<'_, D, K> {
    type Output = Result<Course, ModelError>;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> Self::Output {
        while !self.start.rests(&self.reduced) {
            match self.swing(simd)? {
                None => return Ok(self.course),
                Some(turn) => self.start = turn,
            }
            let (time, position) = (self.time(&self.start), self.start.x[VALUE]);
            self.course.turning_points.push(TurningPoint { time, position });
        }
        Ok(self.rest())
    }
}

impl<const D: usize, const K: usize> Walk<'_, D, K> {
    /// The time of `start` on the clock of the recording.
    fn time(&self, start: &Start) -> f64 {
        self.record.first() + start.time[VALUE]
    }

    /// Fills the samples of the swing from `self.start`; the turning point after it, if the recording goes on up to there.
    #[inline(always)]
    fn swing<S: Simd>(&mut self, simd: S) -> Result<Option<Start>, ModelError> {
        let frame = self.start.frame(&self.reduced);
        let mut state = State::<D>::start(frame.y, frame.w);
        let scale = frame.y.abs().max(frame.w.abs());
        // The series about `center` serves from `from` on.
        let (mut center, mut from) = (0.0, 0.0);
        loop {
            let series = Series::new::<S>(self.reduced.law, &state, scale);
            let end = series.reversal::<S>(self.duration - center);
            let step = end.unwrap_or(series.reach);
            // Without an end the next series takes over half way.
            let until = center + end.unwrap_or(0.5 * step);
            self.fill(simd, &frame, (center, from, until), &series);
            (center, from) = (center + step, until);
            self.check(center)?;
            if !self.record.reaches(self.start.time[VALUE] + until / self.reduced.omega) {
                return Ok(None);
            }
            state = series.state::<S>(step);
            if end.is_some() {
                self.duration = center;
                return Ok(Some(self.start.turn(&self.reduced, &frame, center, &state)));
            }
        }
    }

    /// Fills the samples between two times of the swing from the series about `center`.
    #[inline(always)]
    fn fill<S: Simd>(
        &mut self,
        simd: S,
        frame: &Frame,
        (center, from, until): (f64, f64, f64),
        series: &Series<D>,
    ) {
        let origin = self.start.time[VALUE];
        let clock = Clock { rate: self.reduced.omega, origin, center };
        let piece =
            Piece::<K>::new(self.quantity, &self.reduced, (&self.start, frame), center, series);
        let reach = (center - from).max(until - center);
        let until = origin + until / self.reduced.omega;
        self.record.fill(simd, until, clock, piece.rows(reach));
    }

    /// Counts a step, which led to `center`.
    fn check(&mut self, center: f64) -> Result<(), ModelError> {
        self.steps += 1;
        let reached = self.start.time[VALUE] + center / self.reduced.omega;
        if !reached.is_finite() {
            return Err(ModelError::Overflow);
        }
        if self.steps > MOST_STEPS {
            return Err(ModelError::TooLong { limit: MOST_STEPS, reached });
        }
        Ok(())
    }

    /// Fills what is left with the rest of the mass.
    fn rest(self) -> Course {
        let Walk { start, record, mut course, reduced, .. } = self;
        let [position, derivatives @ ..] = start.x;
        let time = record.first() + start.time[VALUE];
        course.rest = Some(Rest { number: start.number, time, position, derivatives });
        let moves = if self.quantity == Quantity::Position { 1.0 } else { 0.0 };
        let recorded = |k: usize| moves * start.x[k] + reduced.equilibrium[k];
        record.fill_rest(&std::array::from_fn::<f64, K, _>(recorded));
        course
    }
}
