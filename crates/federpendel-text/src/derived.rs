//! What follows from an oscillator alone, in words.

use federpendel::{Oscillator, Regime};

use crate::catalogue::Catalogue;

const RATIO: &str = "derived-damping-ratio";
const BAND: &str = "derived-sticking-offset";

impl Catalogue {
    /// Name, symbol and value of each quantity that follows from the oscillator, as far as it has them.
    pub fn derived(
        &self,
        oscillator: &Oscillator,
        digits: usize,
    ) -> Vec<(String, &'static str, String)> {
        let mix = oscillator.friction().mix();
        let decrement = oscillator.logarithmic_decrement().filter(|_| mix.stokes);
        // Newton friction stretches large swings.
        let period = if mix.newton { "summary-period-small" } else { "summary-period" };
        let frequency = oscillator.frequency().filter(|_| !mix.newton);
        let acting = |acts: bool, value: f64| acts.then_some(value);
        let rows = [
            ("derived-angular-frequency", "ω0", Some(oscillator.angular_frequency()), "1/s"),
            (period, "T", oscillator.period(), "s"),
            // Its usual letter is that of the offset.
            ("derived-frequency", "", frequency, "Hz"),
            ("derived-damping-rate", "γ", acting(mix.stokes, oscillator.damping_rate()), "1/s"),
            (RATIO, "ζ", acting(mix.stokes, oscillator.damping_ratio()), "1"),
            ("derived-quality-factor", "Q", oscillator.quality_factor(), "1"),
            ("derived-logarithmic-decrement", "Λ", decrement, "1"),
            ("derived-offset", "f", acting(mix.coulomb, oscillator.offset()), "m"),
            (BAND, "f_s", acting(mix.coulomb, oscillator.sticking_offset()), "m"),
            ("derived-newton-rate", "κ", acting(mix.newton, oscillator.newton_rate()), "1/m"),
        ];
        let mut found = Vec::new();
        for (id, symbol, value, unit) in rows {
            let Some(value) = value else { continue };
            let value = match id {
                RATIO => self.damping_ratio(oscillator, digits),
                _ => self.quantity(value, unit, digits),
            };
            found.push((self.text(id), symbol, value));
        }
        found
    }

    /// The damping ratio with so many digits that it does not read 1 beside “underdamped”.
    pub fn damping_ratio(&self, oscillator: &Oscillator, digits: usize) -> String {
        let ratio = oscillator.damping_ratio();
        let written = |digits| self.number(ratio, digits);
        let one = self.number(1.0, digits);
        let near = [Regime::Underdamped, Regime::Overdamped].contains(&oscillator.regime());
        let clear = (digits..17).find(|digits| !near || written(*digits) != one);
        written(clear.unwrap_or(17))
    }
}
