//! What can be held beside the exact motion: the article's formulas and every numeric method.

use crate::article::{Formula, Reading};
use crate::error::Result;
use crate::motion::Motion;
use crate::oscillator::{Oscillator, State};
use crate::scheme::{self, SCHEMES, Scheme, Setting};

use super::Course;

/// A method to be held beside the exact motion.
#[derive(Debug, Clone, Copy)]
pub enum Candidate {
    /// A formula of the article.
    Formula(Reading),
    /// A numeric method.
    Scheme(&'static Scheme),
}

impl Candidate {
    /// All of them.
    pub fn all() -> Vec<Self> {
        const LIST: &[Scheme] = &SCHEMES;
        let formulas = [Reading::Printed, Reading::Corrected].map(Candidate::Formula);
        formulas.into_iter().chain(LIST.iter().map(Candidate::Scheme)).collect()
    }

    /// Its name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Candidate::Formula(Reading::Printed) => "article-printed",
            Candidate::Formula(Reading::Corrected) => "article-corrected",
            Candidate::Scheme(scheme) => scheme.name,
        }
    }

    /// The method of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|candidate| candidate.name() == name)
    }

    /// Its place in the list of all, by which pictures tell it apart.
    pub fn number(self) -> usize {
        let names = Self::all().into_iter().map(Candidate::name);
        names.take_while(|name| *name != self.name()).count()
    }

    /// Whether it applies to this oscillator: the article solves three mixes only.
    ///
    /// # Errors
    /// Why not.
    pub fn applies(self, oscillator: &Oscillator) -> Result<()> {
        match self {
            Candidate::Formula(_) => {
                let at_rest = State { position: 0.0, velocity: 0.0 };
                Formula::printed(oscillator, at_rest).map(|_| ())
            }
            Candidate::Scheme(_) => Ok(()),
        }
    }

    /// The declared order of a numeric method.
    pub fn order(self) -> Option<u32> {
        match self {
            Candidate::Formula(_) => None,
            Candidate::Scheme(scheme) => Some(scheme.order),
        }
    }

    /// Whether it is the article's: a formula, or its scheme.
    pub fn is_article(self) -> bool {
        match self {
            Candidate::Formula(_) => true,
            Candidate::Scheme(scheme) => scheme.name == scheme::article::SCHEME.name,
        }
    }

    /// The number of the article's equation that it is for this motion; none for a numeric method.
    ///
    /// # Errors
    /// As [`Candidate::applies`].
    pub fn equation(self, motion: &Motion) -> Result<Option<&'static str>> {
        match self {
            Candidate::Formula(reading) => Ok(Some(formula(reading, motion)?.equation().name())),
            Candidate::Scheme(_) => Ok(None),
        }
    }

    /// Its states at `times` (s), which must not fall, with what it needs of `setting`.
    ///
    /// # Errors
    /// Why the method fails.
    pub fn states(self, motion: &Motion, times: &[f64], setting: &Setting) -> Result<Vec<State>> {
        match self {
            Candidate::Formula(reading) => {
                let formula = formula(reading, motion)?;
                times.iter().map(|time| formula.at(*time).map(|sample| sample.state())).collect()
            }
            Candidate::Scheme(scheme) => {
                let mut course = Course::new(scheme, setting)?;
                if let Some(last) = times.last() {
                    course.check(*last)?;
                }
                times.iter().map(|time| course.at(*time)).collect()
            }
        }
    }
}

fn formula(reading: Reading, motion: &Motion) -> Result<Formula> {
    match reading {
        Reading::Printed => Formula::printed(motion.oscillator(), motion.release()),
        Reading::Corrected => Formula::corrected(motion.oscillator(), motion.release()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pictures tell twelve methods apart; a thirteenth needs another look in `federpendel-text`.
    #[test]
    fn every_method_has_a_look_and_a_name_of_its_own() {
        let names: Vec<_> = Candidate::all().into_iter().map(Candidate::name).collect();
        assert!(names.len() <= 12, "{names:?}");
        for (number, name) in names.iter().enumerate() {
            assert_eq!(Candidate::named(name).map(Candidate::number), Some(number), "{name}");
        }
    }
}
