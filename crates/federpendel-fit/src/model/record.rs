//! The samples of a recording, filled from its beginning on, as many at once as the machine can.

use pulp::Simd;

/// The values and, if `K` is more than one, the columns of derivatives, where they are not filled yet.
pub(super) struct Record<'a, const K: usize> {
    first: f64,
    last: f64,
    times: &'a [f64],
    columns: [&'a mut [f64]; K],
    /// How many samples were taken off last.
    taken: usize,
}

/// How the times of a piece are counted: u = rate·(t − origin) − center.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clock {
    pub rate: f64,
    /// Since the first sample.
    pub origin: f64,
    pub center: f64,
}

impl<'a, const K: usize> Record<'a, K> {
    pub fn new(times: &'a [f64], columns: [&'a mut [f64]; K]) -> Self {
        let (first, last) = (times.first().copied(), times.last().copied());
        Record { first: first.unwrap_or(0.0), last: last.unwrap_or(0.0), times, columns, taken: 0 }
    }

    /// The first of all times.
    pub fn first(&self) -> f64 {
        self.first
    }

    /// Whether the recording goes on at least up to `time` since its first sample.
    pub fn reaches(&self, time: f64) -> bool {
        self.last - self.first >= time
    }

    /// Takes off the samples before `time` since the first.
    fn take(&mut self, time: f64) -> (&'a [f64], [&'a mut [f64]; K]) {
        let earlier = |t: f64| t - self.first < time;
        // Mostly about as many as the last time.
        let mut count = self.taken.min(self.times.len());
        while count < self.times.len() && earlier(self.times[count]) {
            count += 1;
        }
        while count > 0 && !earlier(self.times[count - 1]) {
            count -= 1;
        }
        self.taken = count;
        let (times, later) = self.times.split_at(count);
        self.times = later;
        let columns = self.columns.each_mut().map(|column| {
            let (now, later) = std::mem::take(column).split_at_mut(count);
            *column = later;
            now
        });
        (times, columns)
    }

    /// Fills all samples before `until` with the polynomials of these coefficients.
    #[inline(always)]
    pub fn fill<S: Simd>(&mut self, simd: S, until: f64, clock: Clock, rows: &[[f64; K]]) {
        let (times, columns) = self.take(until);
        let first = self.first;
        let evaluate = Evaluate { simd, first, clock, rows };
        let (blocks, rest) = S::as_simd_f64s(times);
        let outputs = columns.map(|column| S::as_mut_simd_f64s(column));
        for (i, time) in blocks.iter().enumerate() {
            let sums = evaluate.at(*time);
            for k in 0..K {
                outputs[k].0[i] = sums[k];
            }
        }
        if !rest.is_empty() {
            let sums = evaluate.at(simd.partial_load_f64s(rest));
            for k in 0..K {
                simd.partial_store_f64s(outputs[k].1, sums[k]);
            }
        }
    }

    /// Fills all samples left with these values.
    pub fn fill_rest(self, values: &[f64]) {
        for (column, value) in self.columns.into_iter().zip(values) {
            column.fill(*value);
        }
    }
}

/// The polynomials of a piece; not a closure, because only what is always inlined is compiled for the vector
/// instructions of the machine.
struct Evaluate<'a, S, const K: usize> {
    simd: S,
    first: f64,
    clock: Clock,
    rows: &'a [[f64; K]],
}

impl<S: Simd, const K: usize> Evaluate<'_, S, K> {
    #[inline(always)]
    fn at(&self, time: S::f64s) -> [S::f64s; K] {
        let Evaluate { simd, first, clock, rows } = *self;
        let since = simd.sub_f64s(time, simd.splat_f64s(first));
        let since = simd.sub_f64s(since, simd.splat_f64s(clock.origin));
        let u = simd.mul_f64s(since, simd.splat_f64s(clock.rate));
        let u = simd.sub_f64s(u, simd.splat_f64s(clock.center));
        let mut sums = [simd.splat_f64s(0.0); K];
        for row in rows.iter().rev() {
            for k in 0..K {
                sums[k] = simd.mul_add_e_f64s(sums[k], u, simd.splat_f64s(row[k]));
            }
        }
        sums
    }
}
