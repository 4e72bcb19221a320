//! The article's claims, each held against the exact motion of the experiment.
//!
//! A check computes what the article says as it stands in print, beside what the motion does; the verdict follows
//! from the two numbers alone. Sentences about it are in the catalogue: `check-ID` is the claim, and its attributes
//! `.holds`, `.fails`, `.holds-here`, `.not-applicable` say what was found.

mod coulomb_energy;
mod coulomb_rest;
mod coulomb_scheme;
mod coulomb_thrown;
mod decrement;
mod newton;
mod quotients;
mod stokes;
mod stokes_solution;
mod undamped;

use federpendel::Result;

use super::Laboratory;
use crate::document::Verdict;

/// A claim with its numbers and its verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Its number, from 1 in the order of the article.
    pub number: usize,
    /// Its name in files, and in the catalogue.
    pub id: &'static str,
    /// The equation or equations of the article it belongs to: `68`, `26–28`; a section where there is none: `§2.1`.
    pub equation: &'static str,
    /// Whether the article says it in so many words; else it follows from what the article leaves unsaid, or it
    /// takes a word like “suitable” at its most.
    pub stated: bool,
    /// What came out.
    pub computed: Vec<Figure>,
    /// What should have come out if the claim were right.
    pub expected: Vec<Figure>,
    /// What that says of the claim.
    pub verdict: Verdict,
}

/// A number with its symbol and unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// What it is, in the symbols of the article: `v_A`, `Δx/(T/2)`.
    pub symbol: &'static str,
    /// The time that it belongs to, s: x(20 s).
    pub time: Option<f64>,
    /// Its value, SI; NaN where the formula has none.
    pub value: f64,
    /// Its SI unit, `1` for a pure number.
    pub unit: &'static str,
    /// On which scale rounding counts; that of the whole check where there is none.
    pub(crate) scale: Option<f64>,
}

/// Two numbers that differ by less than this share of their scale are equal: rounding, after hundreds of swings.
const ROUNDING: f64 = 1e-9;

/// Two curves whose distance is below this share of the amplitude are one in a drawing: the width of a line.
pub const LINE_WIDTH: f64 = 5e-3;

/// All checks, by section of the article.
#[derive(Debug, Clone, PartialEq)]
pub struct Checks {
    /// Section 1, without friction.
    pub undamped: Vec<Check>,
    /// Section 2.1, Stokes friction.
    pub stokes: Vec<Check>,
    /// Section 2.2, the scheme.
    pub quotients: Vec<Check>,
    /// Section 3.1, the scheme with Coulomb friction.
    pub coulomb_scheme: Vec<Check>,
    /// Section 3.2.1, Coulomb friction from rest.
    pub coulomb_rest: Vec<Check>,
    /// Section 3.2.2, Coulomb friction with any release.
    pub coulomb_thrown: Vec<Check>,
    /// Section 4, Newton friction.
    pub newton: Vec<Check>,
    /// What decays tell of the laws.
    pub decrement: Vec<Check>,
}

impl Checks {
    /// Computes them.
    ///
    /// # Errors
    /// What the core refuses.
    pub fn of(laboratory: &Laboratory) -> Result<Self> {
        let mut coulomb_rest = coulomb_energy::checks(laboratory)?;
        coulomb_rest.extend(coulomb_rest::checks(laboratory)?);
        let mut checks = Checks {
            undamped: undamped::checks(laboratory)?,
            stokes: stokes::checks(laboratory)?,
            quotients: quotients::checks(laboratory)?,
            coulomb_scheme: coulomb_scheme::checks(laboratory)?,
            coulomb_rest,
            coulomb_thrown: coulomb_thrown::checks(laboratory)?,
            newton: newton::checks(laboratory)?,
            decrement: decrement::checks(laboratory)?,
        };
        for (index, check) in checks.sections_mut().into_iter().flatten().enumerate() {
            check.number = index + 1;
        }
        Ok(checks)
    }

    /// All of them in the order of the article.
    pub fn all(&self) -> impl Iterator<Item = &Check> {
        let sections = [
            &self.undamped,
            &self.stokes,
            &self.quotients,
            &self.coulomb_scheme,
            &self.coulomb_rest,
            &self.coulomb_thrown,
            &self.newton,
            &self.decrement,
        ];
        sections.into_iter().flatten()
    }

    fn sections_mut(&mut self) -> [&mut Vec<Check>; 8] {
        [
            &mut self.undamped,
            &mut self.stokes,
            &mut self.quotients,
            &mut self.coulomb_scheme,
            &mut self.coulomb_rest,
            &mut self.coulomb_thrown,
            &mut self.newton,
            &mut self.decrement,
        ]
    }
}

impl Check {
    /// Where it stands in the article: “(68)”, “§2.1”; nothing for the introduction.
    pub fn place(&self) -> String {
        match self.equation {
            "" => String::new(),
            section if section.starts_with('§') => section.to_owned(),
            numbers => format!("({numbers})"),
        }
    }

    fn new(id: &'static str, equation: &'static str) -> Self {
        let (computed, expected) = (Vec::new(), Vec::new());
        Check {
            number: 0,
            id,
            equation,
            stated: true,
            computed,
            expected,
            verdict: Verdict::NotApplicable,
        }
    }

    /// Marks it as something that the article does not say in so many words.
    fn reading(self) -> Self {
        Check { stated: false, ..self }
    }

    /// Adds a number that came out.
    fn computed(mut self, symbol: &'static str, value: f64, unit: &'static str) -> Self {
        self.computed.push(Figure { symbol, time: None, value, unit, scale: None });
        self
    }

    /// Adds a position x (m) that came out at `time` (s).
    fn computed_at(mut self, time: f64, symbol: &'static str, value: f64) -> Self {
        self.computed.push(Figure { symbol, time: Some(time), value, unit: "m", scale: None });
        self
    }

    /// Adds a number that should have come out.
    fn expected(mut self, symbol: &'static str, value: f64, unit: &'static str) -> Self {
        self.expected.push(Figure { symbol, time: None, value, unit, scale: None });
        self
    }

    /// On which scale rounding of the last expected number counts, where its unit is not that of the first.
    fn within(mut self, scale: f64) -> Self {
        if let Some(last) = self.expected.last_mut() {
            last.scale = Some(scale);
        }
        self
    }

    /// The verdict on a claim about all experiments, from what is true of this one.
    fn judged(self, agrees: bool) -> Self {
        Check { verdict: if agrees { Verdict::Holds } else { Verdict::Fails }, ..self }
    }

    /// The verdict on a claim that is wrong in general, where agreement is a coincidence.
    fn judged_by_chance(self, agrees: bool) -> Self {
        Check { verdict: if agrees { Verdict::HoldsHere } else { Verdict::Fails }, ..self }
    }

    /// [`Check::judged`], where each number that came out should be the expected one beside it (or the last one),
    /// but for rounding on the scale of `scale`.
    fn equal(self, scale: f64) -> Self {
        let agrees = self.agrees(scale, ROUNDING);
        self.judged(agrees)
    }

    /// [`Check::judged_by_chance`] by the same comparison.
    fn equal_by_chance(self, scale: f64) -> Self {
        let agrees = self.agrees(scale, ROUNDING);
        self.judged_by_chance(agrees)
    }

    fn agrees(&self, scale: f64, tolerance: f64) -> bool {
        let beside = |index: usize| self.expected.get(index).or(self.expected.last());
        self.computed.iter().enumerate().all(|(index, figure)| {
            beside(index).is_some_and(|expected| {
                let scale = expected.scale.unwrap_or(scale).abs();
                (figure.value - expected.value).abs() <= tolerance * scale
            })
        })
    }
}
