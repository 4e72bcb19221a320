//! An axis: its quantity, its unit, its scale.

use super::span::Span;
use crate::catalogue::Catalogue;

/// An axis: the quantity it shows and the unit of the numbers along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Name and symbol of the quantity and its unit, as they are written along the axis.
    pub label: String,
    /// Size of one unit of the axis in SI units: 0.001 if it shows millimetres.
    pub unit_size: f64,
    /// How values are laid out.
    pub scale: Scale,
    /// Whether zero is shown even where no point is near it; not on a logarithmic axis.
    pub with_zero: bool,
    /// The range beyond which nothing is shown, in the unit of the axis.
    pub limits: Option<(f64, f64)>,
    /// What is shown even where no point is, in the unit of the axis.
    pub whole: Option<[f64; 2]>,
}

/// How values are laid out along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Scale {
    /// Equal differences are equally far apart.
    #[default]
    Linear,
    /// Equal ratios are equally far apart. Values that are not positive are left out.
    Logarithmic,
}

impl Axis {
    /// An axis of the quantity `name` with its `symbol`, whose SI unit is `unit` (`1` for a pure
    /// number), shown in a unit that suits values up to `magnitude` (SI).
    pub fn new(
        catalogue: &Catalogue,
        name: &str,
        symbol: &str,
        unit: &str,
        magnitude: f64,
    ) -> Self {
        let (unit, unit_size) = crate::number::axis_unit(magnitude, unit);
        let unit = crate::number::typeset_unit(unit);
        let name_and_symbol = [("name", name.into()), ("symbol", symbol.into())];
        let label = if unit.is_empty() {
            catalogue.format("plot-axis-pure", &name_and_symbol)
        } else {
            let [name, symbol] = name_and_symbol;
            catalogue.format("plot-axis", &[name, symbol, ("unit", unit.into())])
        };
        Self { label, unit_size, scale: Scale::Linear, with_zero: false, limits: None, whole: None }
    }

    /// The same axis with equal ratios equally far apart.
    pub fn logarithmic(self) -> Self {
        Self { scale: Scale::Logarithmic, with_zero: false, ..self }
    }

    /// The same axis with zero on it even where no point is near it.
    pub fn from_zero(self) -> Self {
        Self { with_zero: self.scale == Scale::Linear, ..self }
    }

    /// The same axis, on which nothing beyond `low` and `high` (SI) is shown.
    pub fn within(self, low: f64, high: f64) -> Self {
        Self { limits: Some((low / self.unit_size, high / self.unit_size)), ..self }
    }

    /// The same axis from `low` to `high` (SI), wherever the points are.
    pub fn spanning(self, low: f64, high: f64) -> Self {
        let whole = Some([low / self.unit_size, high / self.unit_size]);
        Self { whole, ..self }
    }

    /// Whether `value`, in the unit of the axis, lies within the limits.
    pub(super) fn shows(&self, value: f64) -> bool {
        self.limits.is_none_or(|(low, high)| (low..=high).contains(&value))
    }

    /// What the axis spans to show `values` as far as it may.
    pub(super) fn span(&self, values: impl Iterator<Item = f64>) -> Span {
        let values =
            values.chain(self.with_zero.then_some(0.0)).chain(self.whole.into_iter().flatten());
        match self.limits {
            Some((low, high)) if low < high => {
                let mut values = values.map(|value| value.clamp(low, high)).peekable();
                let nothing = values.peek().is_none().then_some([low, high]);
                Span::of(values.chain(nothing.into_iter().flatten()), self.scale)
            }
            _ => Span::of(values, self.scale),
        }
    }
}
