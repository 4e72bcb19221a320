//! What a heading means: a time, a position, velocity or acceleration, a magnitude, a count, the column a user names.

use super::ColumnName;
use super::heading::Heading;
use super::unit::{self, Unit};
use crate::Quantity;

impl Heading {
    /// The unit if it is understood. Grams are a mass where the name says so.
    pub fn known_unit(&self) -> Option<Unit> {
        let unit = unit::parse(&self.unit)?;
        let mass = ["mass", "weight", "gewicht"].iter().any(|word| self.has(word));
        let grams = matches!(self.unit.trim(), "g" | "mg");
        (!(mass && grams)).then_some(unit)
    }

    /// Whether the name contains a word, given in small letters.
    fn has(&self, word: &str) -> bool {
        self.name.to_lowercase().contains(word)
    }

    /// Whether the name is that of a time.
    pub fn is_named_time(&self) -> bool {
        const NAMES: &[&str] =
            &["t", "sec", "seconds", "sekunden", "millis", "tempo", "temps", "tiempo"];
        let name = self.name.to_lowercase();
        let name = name.trim_matches(|c: char| !c.is_alphanumeric());
        NAMES.contains(&name)
            || name.contains("elapsed")
            || ["time", "zeit"].iter().any(|word| name.starts_with(word) || name.ends_with(word))
    }

    /// Whether this is a time, by its name or its unit.
    pub fn is_time(&self) -> bool {
        let timed = || unit::parse(&self.unit).is_some_and(|unit| unit.quantity.is_none());
        self.is_named_time()
            || !(self.unit.is_empty() || self.has("period") || self.label.ends_with("_s"))
                && timed()
    }

    /// What the column holds: by its unit, else by its name.
    pub fn quantity(&self) -> Option<Quantity> {
        self.known_unit().and_then(|unit| unit.quantity).or_else(|| self.named_quantity())
    }

    /// What the name says that the column holds.
    pub fn named_quantity(&self) -> Option<Quantity> {
        const WORDS: &[(Quantity, &[&str])] = &[
            (Quantity::Acceleration, &["accel", "beschleun", "acc_", "acc "]),
            (
                Quantity::Velocity,
                &[
                    "veloc",
                    "speed",
                    "geschwind",
                    "gyro",
                    "drehrate",
                    "rotation rate",
                    "angular rate",
                    "omega",
                    "ω",
                ],
            ),
            (
                Quantity::Position,
                &[
                    "posit", "displac", "auslenk", "elong", "distan", "abstand", "angle", "winkel",
                    "height", "höhe",
                ],
            ),
        ];
        const SYMBOLS: &[(Quantity, &[&str])] = &[
            (
                Quantity::Position,
                &["x", "y", "z", "s", "h", "ort", "weg", "phi", "φ", "ϕ", "theta", "θ", "ϑ", "deg"],
            ),
            (Quantity::Velocity, &["v", "vx", "vy", "vz", "v_x", "v_y", "v_z"]),
            (Quantity::Acceleration, &["a", "ax", "ay", "az", "a_x", "a_y", "a_z", "acc"]),
        ];
        let name = self.name.to_lowercase();
        let holds = |words: &[&str]| words.iter().any(|word| name.contains(word));
        let by_word = WORDS.iter().find(|(_, words)| holds(words));
        let by_symbol = || SYMBOLS.iter().find(|(_, symbols)| symbols.contains(&name.as_str()));
        by_word.or_else(by_symbol).map(|(quantity, _)| *quantity)
    }

    /// Whether the column is a magnitude, which folds an oscillation.
    pub fn is_magnitude(&self) -> bool {
        let words = ["absolute", "magnitude", "betrag", "absolut", "resultant", "|"];
        words.iter().any(|word| self.has(word))
            || ["abs", "r"].contains(&self.name.to_lowercase().as_str())
    }

    /// Whether the column counts or comments rows rather than measures.
    pub fn is_count(&self) -> bool {
        const COUNTS: &[&str] = &[
            "", "frame", "index", "step", "sample", "mode", "modus", "#", "n", "nr", "no", "no.",
            "nr.", "id", "row", "count", "counter", "status",
        ];
        const ERRORS: &[&str] =
            &["accuracy", "uncertainty", "unsicherheit", "sigma", "error", "fehler"];
        let name = self.name.to_lowercase();
        let counts = COUNTS.contains(&name.trim()) || name.starts_with("unnamed");
        counts && self.unit.is_empty() || ERRORS.contains(&name.trim())
    }

    /// Whether `asked` names this column: by its label, by its name, or by its number, each in any case.
    pub fn fits(&self, asked: &str, column: usize) -> Fit {
        let same = |text: &str| squeezed(text) == squeezed(asked);
        if self.label == asked.trim() {
            Fit::Label
        } else if same(&self.label) {
            Fit::Nearly
        } else if same(&self.name) {
            Fit::Name
        } else if asked.trim() == (column + 1).to_string() {
            Fit::Number
        } else {
            Fit::No
        }
    }
}

impl ColumnName {
    /// Whether it holds angles or their rates: the name says so where the unit does not.
    pub fn is_angle(&self) -> bool {
        const WORDS: &[&str] =
            &["angul", "angle", "winkel", "gyro", "drehrate", "rotation", "theta", "omega"];
        const SYMBOLS: &[&str] = &["phi", "φ", "ϕ", "θ", "ϑ", "ω", "deg", "rad"];
        let name = self.name.to_lowercase();
        let named =
            WORDS.iter().any(|word| name.contains(word)) || SYMBOLS.contains(&name.as_str());
        self.unit.is_empty() && named
    }
}

/// How well a column fits a name; the best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fit {
    /// To the letter.
    Label,
    /// But for case and blanks.
    Nearly,
    /// Without unit and run.
    Name,
    /// By its number.
    Number,
    /// Not at all.
    No,
}

/// Without blanks, in small letters.
pub(super) fn squeezed(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_without_a_unit_are_known_by_name() {
        let column = |name: &str, unit: &str| ColumnName {
            label: name.to_owned(),
            name: name.to_owned(),
            unit: unit.to_owned(),
            number: 2,
        };
        for name in ["angular_velocity", "Winkel", "θ", "Gyroscope x", "phi"] {
            assert!(column(name, "").is_angle(), "{name}");
        }
        for name in ["Position", "x", "Auslenkung", "v"] {
            assert!(!column(name, "").is_angle(), "{name}");
        }
        assert!(!column("Winkel", "m").is_angle());
    }

    #[test]
    fn times_and_quantities() {
        for label in [
            "t",
            "Time",
            "Zeit (s)",
            "Elapsed time [ms]",
            "time_s",
            "timestamp",
            "X (ms)",
            "Messzeit",
        ] {
            assert!(Heading::parse(label).is_time(), "{label}");
        }
        for label in ["x", "s", "x_s", "Period (s)", "Temperature", "Position (m)", "Frame"] {
            assert!(!Heading::parse(label).is_time(), "{label}");
        }
        for (label, quantity) in [
            ("Auslenkung", Some(Quantity::Position)),
            ("Winkel (°)", Some(Quantity::Position)),
            ("angular_velocity", Some(Quantity::Velocity)),
            ("Gyroscope x (rad/s)", Some(Quantity::Velocity)),
            ("Beschleunigung ohne g", Some(Quantity::Acceleration)),
            ("X (g)", Some(Quantity::Acceleration)),
            ("Mass (g)", None),
            ("Voltage (V)", None),
        ] {
            assert_eq!(Heading::parse(label).quantity(), quantity, "{label}");
        }
    }
}
