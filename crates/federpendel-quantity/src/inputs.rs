//! What is said of an experiment beside its recording, as written: on the command line, in the fields of the page.

use federpendel::parameter::{GRAVITY, MASS, NORMAL_FORCE, ParameterInfo, Range, STIFFNESS};
use federpendel_fit::{Given, Measured, Normal};
use federpendel_text::{Catalogue, excerpt};

use crate::words::{quantity_problem, refusal, value_of};
use crate::{Dimension, parse_uncertain};

/// Mass of the spring; no experiment has one.
const SPRING_MASS: ParameterInfo = ParameterInfo {
    name: "spring_mass",
    symbol: "m_s",
    unit: "kg",
    range: Range::NonNegative,
    default: None,
};

/// Beyond this share of a value its uncertainty is too much for propagation along tangents.
const MOST_UNCERTAIN: f64 = 0.5;

/// What μ is made with: dry friction needs something to press the body on its guide.
const PRESSES: ParameterInfo = ParameterInfo { range: Range::Positive, ..NORMAL_FORCE };
const WEIGHS: ParameterInfo = ParameterInfo { range: Range::Positive, ..GRAVITY };

/// What was measured beside a recording, as written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Beside {
    /// Mass of the body.
    pub mass: Option<String>,
    /// Stiffness of the spring.
    pub stiffness: Option<String>,
    /// Mass of the spring.
    pub spring_mass: Option<String>,
    /// Normal force.
    pub normal_force: Option<String>,
    /// Whether the weight of the body is the normal force.
    pub horizontal: bool,
    /// Gravity.
    pub gravity: Option<String>,
}

/// A sentence about an input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Said {
    /// The input by its name, as `spring_mass`.
    pub input: &'static str,
    /// The sentence.
    pub sentence: String,
}

/// Reads inputs, and calls them what they are called where they are given.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    /// Where the sentences come from.
    pub catalogue: &'a Catalogue,
    /// What an input is called: `--spring-mass` for `spring_mass`, or what stands beside its field.
    pub called: fn(&Catalogue, &str) -> String,
}

impl Inputs<'_> {
    fn name(&self, input: &str) -> String {
        (self.called)(self.catalogue, input)
    }

    /// The quantity of one of the dimensions, SI, if it is written.
    ///
    /// # Errors
    /// Why it is refused.
    pub fn value(
        &self,
        input: &'static str,
        range: Range,
        dimensions: &[Dimension],
        written: Option<&str>,
    ) -> Result<Option<f64>, Said> {
        let read = |written: &str| {
            value_of(self.catalogue, &self.name(input), range, dimensions, written)
                .map_err(|sentence| Said { input, sentence })
        };
        Ok(written.map(read).transpose()?.map(|(_, value)| value))
    }

    /// Beginning and end of the part to be fitted, s.
    ///
    /// # Errors
    /// Why one is refused, or both.
    pub fn window(&self, from: Option<&str>, to: Option<&str>) -> Result<[Option<f64>; 2], Said> {
        let from = self.value("from", Range::Finite, &[Dimension::Time], from)?;
        let to = self.value("to", Range::Finite, &[Dimension::Time], to)?;
        let Some((begin, end)) = from.zip(to).filter(|(from, to)| from >= to) else {
            return Ok([from, to]);
        };
        let time = |time| self.catalogue.exact_quantity(time, "s").into();
        let variables = [
            ("begin", self.name("from").into()),
            ("end", self.name("to").into()),
            ("from", time(begin)),
            ("to", time(end)),
        ];
        let sentence = self.catalogue.format("fit-window-reversed", &variables);
        Err(Said { input: "to", sentence })
    }

    /// The numbers that were measured beside a recording, and what is assumed of them.
    ///
    /// # Errors
    /// The first that is refused, and those that contradict each other.
    pub fn given(&self, beside: &Beside) -> Result<(Given, Vec<Said>), Said> {
        let mut remarks = Vec::new();
        let mut read = |info: &ParameterInfo, dimension: Dimension, written: &Option<String>| {
            let measured = |written: &String| self.measured(info, dimension, written);
            let found = written.as_ref().map(measured).transpose()?;
            Ok(found.map(|(measured, remark)| {
                remarks.extend(remark);
                measured
            }))
        };
        let normal_force = read(&PRESSES, Dimension::Force, &beside.normal_force)?;
        let gravity = read(&WEIGHS, Dimension::Acceleration, &beside.gravity)?;
        let given = Given {
            normal: self.normal(beside, normal_force, gravity)?,
            mass: read(&MASS, Dimension::Mass, &beside.mass)?,
            stiffness: read(&STIFFNESS, Dimension::Stiffness, &beside.stiffness)?,
            spring_mass: read(&SPRING_MASS, Dimension::Mass, &beside.spring_mass)?,
        };
        Ok((given, remarks))
    }

    /// What presses the body on its guide.
    fn normal(
        &self,
        beside: &Beside,
        force: Option<Measured>,
        gravity: Option<Measured>,
    ) -> Result<Option<Normal>, Said> {
        let refused = |input, id: &str, written: &Option<String>| {
            let written = excerpt(written.as_deref().unwrap_or_default());
            let value = self.catalogue.quoted(&written);
            let sentence = self.catalogue.format(id, &[("value", value.into())]);
            Err(Said { input, sentence })
        };
        match (force, gravity) {
            (Some(_), _) if beside.horizontal => {
                refused(PRESSES.name, "physical-horizontal-twice", &beside.normal_force)
            }
            (_, Some(_)) if !beside.horizontal => {
                refused(WEIGHS.name, "physical-gravity-alone", &beside.gravity)
            }
            (Some(force), _) => Ok(Some(Normal::Force(force))),
            (None, gravity) => {
                let usual = GRAVITY.default.map(|value| Measured { value, uncertainty: 0.0 });
                Ok(gravity.or(usual).filter(|_| beside.horizontal).map(Normal::Weight))
            }
        }
    }

    /// A value with its uncertainty, and in what unit a bare number is taken.
    fn measured(
        &self,
        info: &ParameterInfo,
        dimension: Dimension,
        written: &str,
    ) -> Result<(Measured, Option<Said>), Said> {
        let problem = match parse_uncertain(written, dimension) {
            Ok(measured) if !info.range.contains(measured.value) => None,
            Ok(measured) if measured.uncertainty > MOST_UNCERTAIN * measured.value => {
                Some(self.catalogue.text("quantity-uncertainty-large"))
            }
            Ok(measured) => return Ok((measured, self.bare(info, written, measured))),
            Err(error) => Some(quantity_problem(self.catalogue, &error)),
        };
        let name = self.name(info.name);
        let sentence = refusal(self.catalogue, &name, info.range, &[dimension], written, problem);
        Err(Said { input: info.name, sentence })
    }

    /// In what unit a bare number is taken, for “250” is more often grams than kilograms.
    fn bare(&self, info: &ParameterInfo, written: &str, measured: Measured) -> Option<Said> {
        // 9.81 can only be in m/s².
        if info.name == GRAVITY.name || parse_uncertain(written, Dimension::Number).is_err() {
            return None;
        }
        let value = self.catalogue.exact_quantity(measured.value, info.unit);
        let variables = [("name", self.name(info.name).into()), ("value", value.into())];
        let sentence = self.catalogue.format("physical-bare-number", &variables);
        Some(Said { input: info.name, sentence })
    }
}
