//! Which columns hold times, and in which unit.

use super::column::Table;
use super::error::{Field, ReadError};
use super::rate;
use super::unit::{self, TIMES, Unit};

/// Where times come from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Times {
    /// A column and its unit.
    Column(usize, Unit),
    /// A column of times of day.
    Clock(usize),
    /// Even times, 1/s.
    Rate(f64),
}

/// Columns of times, or none and a rate.
pub(super) struct TimeColumns {
    pub columns: Vec<usize>,
    pub guessed: bool,
    pub rate: Option<f64>,
    /// One that the header names, where a rate is asked for.
    pub ignored: Option<usize>,
}

impl Table<'_> {
    /// The column of times of each run, or a rate: what is asked for, what the header names, what stands above it.
    pub fn times(&self) -> Result<TimeColumns, ReadError> {
        let none =
            || TimeColumns { columns: Vec::new(), guessed: false, rate: None, ignored: None };
        let found = |columns| Ok(TimeColumns { columns, ..none() });
        let named = self.named_times();
        if let (Some(_), Some(time)) = (self.choice.rate, &self.choice.time) {
            return Err(ReadError::RateAndTime { time: time.clone() });
        }
        if let Some(asked) = &self.choice.time {
            return found(self.named(Field::Time, asked)?);
        }
        if let Some(value) = self.choice.rate {
            if !(value.is_finite() && value > 0.0) {
                return Err(ReadError::Rate { value });
            }
            return Ok(TimeColumns {
                rate: Some(value),
                ignored: named.first().copied(),
                ..none()
            });
        }
        if !named.is_empty() {
            return found(named);
        }
        let rate = rate::of(&self.layout.preamble);
        if rate.is_some() {
            return Ok(TimeColumns { rate, ..none() });
        }
        let first = self.headings.len() > 1
            && (self.sizes[0].rises() && !self.is_count(0) || self.sizes[0].is_clock());
        if first {
            return Ok(TimeColumns { columns: vec![0], guessed: true, ..none() });
        }
        Err(ReadError::NoTime { columns: self.labels() })
    }

    /// Columns that the header calls times, by name rather than by unit; if need be one of words, so that the first of
    /// them is refused with its line.
    fn named_times(&self) -> Vec<usize> {
        let header = self.layout.header;
        let all = |fits: &dyn Fn(usize) -> bool| -> Vec<usize> {
            (0..self.headings.len()).filter(|at| header && fits(*at)).collect()
        };
        let numeric = |at: usize| self.sizes[at].is_numeric();
        let by_name = |at: usize| self.headings[at].is_named_time();
        let by_unit = |at: usize| self.headings[at].is_time();
        let ways: [&dyn Fn(usize) -> bool; 3] =
            [&|at| by_name(at) && numeric(at), &|at| by_unit(at) && numeric(at), &by_name];
        ways.into_iter().map(all).find(|columns| !columns.is_empty()).unwrap_or_default()
    }

    /// The column of times with its unit, and whether seconds are assumed.
    pub fn time_unit(&self, at: usize) -> Result<(Times, bool), ReadError> {
        if self.sizes[at].is_clock() {
            return Ok((Times::Clock(at), false));
        }
        let heading = &self.headings[at];
        let named = unit::parse(&heading.unit).or_else(|| {
            // "Seconds", "millis".
            heading.unit.is_empty().then(|| unit::parse(&heading.name)).flatten()
        });
        let named = named.filter(|unit| unit.quantity.is_none());
        match named {
            Some(unit) => Ok((Times::Column(at, unit), false)),
            None if heading.unit.is_empty() => {
                let second = Unit { quantity: None, si: "s", numerator: 1.0, denominator: 1.0 };
                Ok((Times::Column(at, second), true))
            }
            None => Err(ReadError::TimeUnit {
                column: heading.label.clone(),
                unit: heading.unit.clone(),
                allowed: TIMES,
            }),
        }
    }
}
