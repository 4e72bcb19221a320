//! What is found of formulas and schemes, in words.

use std::f64::consts::LN_2;

use federpendel::lens::{Findings, Remark};

use crate::catalogue::Catalogue;

impl Catalogue {
    /// What a user of a formula or scheme of the article should know about it; `equation` is the number of the formula.
    pub fn remark(&self, remark: Remark, equation: Option<&str>) -> String {
        let id = match remark {
            Remark::SticksAtOnce => "remark-sticks-at-once",
            Remark::NoSticking => "remark-no-sticking",
            Remark::WrongDecay => "remark-wrong-decay",
            Remark::Grows => "remark-grows",
            Remark::WrongPhase => "remark-wrong-phase",
            Remark::WrongPhaseAndDecay => "remark-wrong-phase-and-decay",
            Remark::OnlyAtTurningPoints => "remark-only-at-turning-points",
            Remark::MissesTurningPoints => "remark-misses-turning-points",
            Remark::Chatters => "remark-chatters",
            Remark::FirstOrder => "remark-first-order",
            Remark::SecondOrder => "remark-second-order",
        };
        let method = match equation {
            Some(number) => self.format("remark-equation", &[("number", number.into())]),
            None => self.text("remark-scheme"),
        };
        self.format(id, &[("method", method.into())])
    }

    /// The order that a numeric method declares and the one that is found of it, `2 → 1.0`; a dash where it has none.
    pub fn orders(&self, declared: Option<u32>, observed: Option<f64>) -> String {
        match (declared, observed) {
            (Some(declared), Some(observed)) => format!("{declared} → {}", self.fixed(observed, 1)),
            (Some(declared), None) => format!("{declared} → ?"),
            _ => "–".to_owned(),
        }
    }

    /// What a method does where the mass has come to rest; a dash where it never does.
    pub fn at_rest(&self, sticks: Option<bool>, creep: Option<f64>) -> String {
        match (sticks, creep) {
            (Some(true), _) => self.text("compare-sticks"),
            (Some(false), Some(creep)) => {
                let speed = self.quantity(creep, "m/s", 2);
                self.format("compare-creeps", &[("speed", speed.into())])
            }
            (Some(false), None) => self.text("compare-goes-on"),
            (None, _) => "–".to_owned(),
        }
    }

    /// What was found of a method of this declared order, in a sentence each; errors up to `rounding` (m) are nothing else.
    pub fn findings(&self, declared: Option<u32>, found: &Findings, rounding: f64) -> Vec<String> {
        let largest = found.errors.largest;
        let error = [("error", self.quantity(largest, "m", 3).into())];
        let id = if largest <= rounding { "lens-rounding" } else { "lens-error" };
        let mut sentences = vec![self.format(id, &error)];
        if let Some(declared) = declared {
            let declared = ("declared", declared.into());
            sentences.push(match found.ladder.order() {
                Some(order) => {
                    let factor = ("factor", self.number((order * LN_2).exp(), 2).into());
                    let observed = ("observed", self.fixed(order, 1).into());
                    self.format("lens-order", &[declared, factor, observed])
                }
                None => self.format("lens-no-order", &[declared]),
            });
        }
        sentences.extend(match (found.sticks, found.creep) {
            (Some(true), _) => Some(self.text("lens-sticks")),
            (Some(false), Some(creep)) => {
                let speed = self.quantity(creep, "m/s", 2);
                Some(self.format("lens-creeps", &[("speed", speed.into())]))
            }
            (Some(false), None) => Some(self.text("lens-goes-on")),
            (None, _) => None,
        });
        sentences
    }
}
