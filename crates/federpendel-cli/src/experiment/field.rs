//! The fields of an experiment: where each stands in a file, and its flag.

use federpendel::parameter::{self, ParameterInfo};

use crate::quantity::Dimension;

macro_rules! fields {
    ($($(#[$doc:meta])* $name:ident = $path:literal, $info:ident, $dimension:ident;)*) => {
        /// One value of an experiment.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Field { $($(#[$doc])* $name,)* }

        impl Field {
            /// All fields, in the order of a file.
            pub const ALL: &[Field] = &[$(Field::$name),*];

            /// Where it stands in a file: `friction.coulomb.static`.
            pub fn path(self) -> &'static str {
                match self { $(Field::$name => $path,)* }
            }

            /// The core's description of it.
            pub fn info(self) -> &'static ParameterInfo {
                match self { $(Field::$name => &parameter::$info,)* }
            }

            /// What it measures.
            pub fn dimension(self) -> Dimension {
                match self { $(Field::$name => Dimension::$dimension,)* }
            }
        }
    };
}

fields! {
    /// Mass of the body.
    Mass = "oscillator.mass", MASS, Mass;
    /// Stiffness of the spring.
    Stiffness = "oscillator.stiffness", STIFFNESS, Stiffness;
    /// Acceleration of gravity.
    Gravity = "oscillator.gravity", GRAVITY, Acceleration;
    /// Normal force, instead of gravity.
    NormalForce = "oscillator.normal_force", NORMAL_FORCE, Force;
    /// Damping of Stokes friction.
    Damping = "friction.stokes.damping", DAMPING, Damping;
    /// Kinetic coefficient of Coulomb friction.
    Kinetic = "friction.coulomb.kinetic", KINETIC, Number;
    /// Static coefficient of Coulomb friction.
    Static = "friction.coulomb.static", STATIC, Number;
    /// Density of the medium of Newton friction.
    Density = "friction.newton.density", DENSITY, Density;
    /// Drag coefficient of Newton friction.
    DragCoefficient = "friction.newton.drag_coefficient", DRAG_COEFFICIENT, Number;
    /// Frontal area of Newton friction.
    Area = "friction.newton.area", AREA, Area;
    /// Newton coefficient ½ρc_wA, instead of the three above.
    NewtonCoefficient = "friction.newton.coefficient", NEWTON_COEFFICIENT, MassPerLength;
    /// Position of release.
    Position = "release.position", POSITION, Length;
    /// Velocity of release.
    Velocity = "release.velocity", VELOCITY, Velocity;
    /// Length of the record.
    Duration = "record.duration", DURATION, Time;
    /// Number of samples.
    Samples = "record.samples", SAMPLES, Number;
}

impl Field {
    /// The three values that make a Newton coefficient.
    pub const DRAG: [Field; 3] = [Field::Density, Field::DragCoefficient, Field::Area];

    /// Its name on the command line, without the dashes.
    pub fn flag(self) -> String {
        self.info().name.replace('_', "-")
    }

    /// The field at `path` in a file.
    pub fn at(path: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|field| field.path() == path)
    }

    /// The other ways to say what this field says.
    pub fn rivals(self) -> &'static [Field] {
        match self {
            Field::Gravity => &[Field::NormalForce],
            Field::NormalForce => &[Field::Gravity],
            Field::NewtonCoefficient => &Self::DRAG,
            Field::Density | Field::DragCoefficient | Field::Area => &[Field::NewtonCoefficient],
            _ => &[],
        }
    }
}
