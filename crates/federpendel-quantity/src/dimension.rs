//! What a quantity measures.

use super::unit::Unit;

/// Powers of kilogram, metre and second.
pub(super) type Powers = [i32; 3];

macro_rules! dimensions {
    ($($(#[$doc:meta])* $name:ident = $key:literal, $powers:expr, [$($unit:literal),+];)*) => {
        /// The dimensions that an experiment has, and some that its units may be mistaken for.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Dimension { $($(#[$doc])* $name,)* }

        impl Dimension {
            /// All of them.
            pub const ALL: &[Dimension] = &[$(Dimension::$name),*];

            /// A key for the message catalogue.
            pub fn key(self) -> &'static str {
                match self { $(Dimension::$name => $key,)* }
            }

            /// Units to name when one is asked for; the SI unit first.
            pub fn units(self) -> &'static [&'static str] {
                match self { $(Dimension::$name => &[$($unit),+],)* }
            }

            pub(super) fn powers(self) -> Powers {
                match self { $(Dimension::$name => $powers,)* }
            }
        }
    };
}

dimensions! {
    /// kg
    Mass = "mass", [1, 0, 0], ["kg", "g", "mg", "t", "lb"];
    /// m
    Length = "length", [0, 1, 0], ["m", "cm", "mm", "µm", "km", "in", "ft"];
    /// s
    Time = "time", [0, 0, 1], ["s", "ms", "min", "h"];
    /// N
    Force = "force", [1, 1, -2], ["N", "mN", "kN", "lbf"];
    /// N/m
    Stiffness = "stiffness", [1, 0, -2], ["N/m", "N/mm", "kN/m", "lbf/in"];
    /// kg/s
    Damping = "damping", [1, 0, -1], ["kg/s", "N·s/m", "g/s"];
    /// kg/m
    MassPerLength = "mass-per-length", [1, -1, 0], ["kg/m", "g/cm", "g/m"];
    /// m/s
    Velocity = "velocity", [0, 1, -1], ["m/s", "cm/s", "mm/s", "km/h"];
    /// m/s^2
    Acceleration = "acceleration", [0, 1, -2], ["m/s^2", "cm/s^2"];
    /// kg/m^3
    Density = "density", [1, -3, 0], ["kg/m^3", "g/cm^3", "kg/l"];
    /// m^2
    Area = "area", [0, 2, 0], ["m^2", "cm^2", "mm^2"];
    /// A pure number.
    Number = "number", [0, 0, 0], ["1", "%"];
    /// Hz
    Frequency = "frequency", [0, 0, -1], ["Hz", "1/s"];
    /// m^3
    Volume = "volume", [0, 3, 0], ["m^3", "l"];
    /// J
    Energy = "energy", [1, 2, -2], ["J", "N·m"];
    /// W
    Power = "power", [1, 2, -3], ["W"];
    /// Pa
    Pressure = "pressure", [1, -1, -2], ["Pa", "bar"];
}

impl Dimension {
    /// What is measured in this SI unit, as the table of parameters writes it; none where it has no name here.
    ///
    /// ```
    /// # use federpendel_quantity::Dimension;
    /// assert_eq!(Dimension::of_unit("kg/m^3"), Some(Dimension::Density));
    /// ```
    pub fn of_unit(unit: &str) -> Option<Self> {
        Self::from_powers(Unit::parse(unit, Dimension::Number).ok()?.powers)
    }

    pub(super) fn from_powers(powers: Powers) -> Option<Self> {
        Self::ALL.iter().copied().find(|dimension| dimension.powers() == powers)
    }
}
