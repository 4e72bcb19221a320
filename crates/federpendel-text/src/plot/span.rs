//! What an axis spans.

use super::Scale;

/// The part of an axis that is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    pub low: f64,
    pub high: f64,
    pub scale: Scale,
}

impl Span {
    /// From the lowest to the highest value that can be shown; widened where they are one.
    pub fn of(values: impl IntoIterator<Item = f64>, scale: Scale) -> Self {
        let shown = |value: &f64| value.is_finite() && (scale == Scale::Linear || *value > 0.0);
        let (low, high) = values
            .into_iter()
            .filter(shown)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        let (low, high) = match scale {
            _ if low < high => (low, high),
            Scale::Linear if low == high && low != 0.0 => {
                (low - 0.5 * low.abs(), low + 0.5 * low.abs())
            }
            Scale::Linear => (-1.0, 1.0),
            Scale::Logarithmic if low == high => (low / 10.0, low * 10.0),
            Scale::Logarithmic => (0.1, 10.0),
        };
        Span { low, high, scale }
    }

    /// The same span, widened to `values` unless that makes it more than `most` times as wide.
    pub fn including(self, values: impl IntoIterator<Item = f64>, most: f64) -> Self {
        let (low, high) = values
            .into_iter()
            .fold((self.low, self.high), |(low, high), value| (low.min(value), high.max(value)));
        if high - low <= most * (self.high - self.low) { Span { low, high, ..self } } else { self }
    }

    /// The same span with room at both ends, each `share` of it wide.
    pub fn with_room(self, share: f64) -> Self {
        match self.scale {
            Scale::Linear => {
                let room = share * (self.high - self.low);
                Span { low: self.low - room, high: self.high + room, ..self }
            }
            Scale::Logarithmic => {
                let room = (self.high / self.low).powf(share);
                Span { low: self.low / room, high: self.high * room, ..self }
            }
        }
    }

    /// The same span, widened about its middle to this range.
    fn widened(self, range: f64) -> Self {
        let room = ((range - (self.high - self.low)) / 2.0).max(0.0);
        Span { low: self.low - room, high: self.high + room, ..self }
    }

    /// Both spans with one of them widened, so that a unit is as long along `x`, which is `width` long, as
    /// along `y`, which is `height` long.
    pub fn equal(x: Span, y: Span, width: f64, height: f64) -> (Self, Self) {
        let unit = f64::max((x.high - x.low) / width, (y.high - y.low) / height);
        (x.widened(unit * width), y.widened(unit * height))
    }

    /// Where `value` lies, 0 at the low end and 1 at the high end; `None` if it cannot be shown.
    pub fn fraction(&self, value: f64) -> Option<f64> {
        let fraction = match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Logarithmic if value > 0.0 => {
                (value / self.low).ln() / (self.high / self.low).ln()
            }
            Scale::Logarithmic => return None,
        };
        fraction.is_finite().then_some(fraction)
    }

    /// The value that lies at `fraction`.
    pub fn at(&self, fraction: f64) -> f64 {
        match self.scale {
            Scale::Linear => self.low + fraction * (self.high - self.low),
            Scale::Logarithmic => self.low * (self.high / self.low).powf(fraction),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_never_empty() {
        for values in [vec![], vec![0.0], vec![3.0], vec![-3.0, -3.0], vec![f64::NAN]] {
            for scale in [Scale::Linear, Scale::Logarithmic] {
                let span = Span::of(values.iter().copied(), scale).with_room(0.05);
                assert!(span.low < span.high, "{values:?} {scale:?}");
            }
        }
    }

    #[test]
    fn equal_scales_widen_the_span_that_has_room() {
        let (x, y) = (Span::of([0.0, 10.0], Scale::Linear), Span::of([1.0, 3.0], Scale::Linear));
        let (wide, high) = Span::equal(x, y, 500.0, 200.0);
        assert_eq!((wide, high), (x, Span { low: 0.0, high: 4.0, ..y }));
        assert_eq!(Span::equal(x, y, 500.0, 10.0).0, Span { low: -45.0, high: 55.0, ..x });
    }

    #[test]
    fn fractions_follow_the_scale() {
        let linear = Span::of([0.0, 10.0], Scale::Linear);
        assert_eq!(linear.fraction(2.5), Some(0.25));
        let logarithmic = Span::of([1e-4, 1e4], Scale::Logarithmic);
        assert!((logarithmic.fraction(1.0).unwrap() - 0.5).abs() < 1e-12);
        assert_eq!(logarithmic.fraction(-1.0), None);
    }
}
