//! What is wrong with a formula or scheme of the article for one experiment.

use crate::article::Reading;
use crate::friction::Mix;
use crate::motion::Motion;
use crate::outcome::Outcome;

use super::Candidate;

/// Nearest to 1 N/m that a stiffness is told from it: there a factor C happens to be 1.
const SAME: f64 = 1e-12;

/// Something that a user of a method should know about it; one for each experiment at most.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Remark {
    /// The mass sticks where it is released, and the formula lets it swing.
    SticksAtOnce,
    /// The mass comes to rest, and the method knows none. Without sliding friction that is all.
    NoSticking,
    /// The decay is wrong by the factor C, and there is no sticking.
    WrongDecay,
    /// x0 < 0: the amplitude grows, and by the factor C.
    Grows,
    /// v0 < 0: the phase has lost its quadrant.
    WrongPhase,
    /// v0 < 0: the phase has lost its quadrant, and the decay is wrong by the factor C.
    WrongPhaseAndDecay,
    /// Right at the turning points only.
    OnlyAtTurningPoints,
    /// v0 ≠ 0: not even right there.
    MissesTurningPoints,
    /// A scheme with dry friction.
    Chatters,
    /// A scheme with other friction.
    FirstOrder,
    /// A scheme without friction.
    SecondOrder,
}

impl Remark {
    /// What is wrong with a formula or the scheme of the article for this motion; `None` where nothing is.
    pub fn of(candidate: Candidate, motion: &Motion) -> Option<Self> {
        match candidate {
            Candidate::Formula(Reading::Printed) => Self::of_formula(motion, true),
            Candidate::Formula(Reading::Corrected) => Self::of_formula(motion, false),
            Candidate::Scheme(_) if candidate.is_article() => Some(Self::of_scheme(motion)),
            Candidate::Scheme(_) => None,
        }
    }

    fn of_scheme(motion: &Motion) -> Self {
        let oscillator = motion.oscillator();
        if oscillator.offset() > 0.0 {
            return Remark::Chatters;
        }
        match oscillator.friction().mix() {
            _ if sticks(motion) => Remark::NoSticking,
            Mix { stokes: false, newton: false, .. } => Remark::SecondOrder,
            _ => Remark::FirstOrder,
        }
    }

    fn of_formula(motion: &Motion, printed: bool) -> Option<Self> {
        let (oscillator, release) = (motion.oscillator(), motion.release());
        if !oscillator.friction().mix().coulomb {
            return None;
        }
        if matches!(motion.outcome(), Outcome::Rests(rest) if rest.time == 0.0) {
            return Some(Remark::SticksAtOnce);
        }
        let decays = oscillator.offset() > 0.0;
        let wrong_decay = decays && (oscillator.stiffness() - 1.0).abs() > SAME;
        match (release.position, release.velocity) {
            (_, v0) if printed && v0 < 0.0 && wrong_decay => Some(Remark::WrongPhaseAndDecay),
            (_, v0) if printed && v0 < 0.0 => Some(Remark::WrongPhase),
            (x0, v0) if printed && decays && v0 == 0.0 && x0 < 0.0 => Some(Remark::Grows),
            _ if printed && wrong_decay => Some(Remark::WrongDecay),
            _ if !decays => sticks(motion).then_some(Remark::NoSticking),
            (_, 0.0) => Some(Remark::OnlyAtTurningPoints),
            _ => Some(Remark::MissesTurningPoints),
        }
    }
}

/// Whether static friction ends the motion.
fn sticks(motion: &Motion) -> bool {
    motion.oscillator().sticking_offset() > 0.0 && matches!(motion.outcome(), Outcome::Rests(_))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::{Coulomb, Friction, Newton, NormalForce, Stokes};
    use crate::oscillator::{Oscillator, State};
    use crate::scheme;

    const FORMULAS: [Candidate; 2] =
        [Candidate::Formula(Reading::Printed), Candidate::Formula(Reading::Corrected)];

    fn motion(stiffness: f64, friction: impl Into<Friction>, x0: f64, v0: f64) -> Motion {
        let oscillator = Oscillator::new(0.5, stiffness, friction).unwrap();
        Motion::new(oscillator, State::new(x0, v0).unwrap()).unwrap()
    }

    fn dry(kinetic: f64, held: f64) -> Coulomb {
        Coulomb::new(kinetic, held, NormalForce::Weight(9.81)).unwrap()
    }

    #[test]
    fn of_printed_and_corrected_formulas() {
        use Remark::*;
        let same = dry(0.02, 0.02);
        for (stiffness, friction, x0, v0, printed, corrected) in [
            (20.0, same, 0.1, 0.0, Some(WrongDecay), Some(OnlyAtTurningPoints)),
            (1.0, same, 0.5, 0.0, Some(OnlyAtTurningPoints), Some(OnlyAtTurningPoints)),
            (20.0, same, -0.1, 0.0, Some(Grows), Some(OnlyAtTurningPoints)),
            (1.0, same, -0.5, 0.0, Some(Grows), Some(OnlyAtTurningPoints)),
            (20.0, same, 0.1, 0.3, Some(WrongDecay), Some(MissesTurningPoints)),
            (20.0, same, 0.1, -0.3, Some(WrongPhaseAndDecay), Some(MissesTurningPoints)),
            (1.0, same, 0.5, -0.3, Some(WrongPhase), Some(MissesTurningPoints)),
            (20.0, same, 0.001, 0.0, Some(SticksAtOnce), Some(SticksAtOnce)),
            (20.0, same, 0.0, 0.0, Some(SticksAtOnce), Some(SticksAtOnce)),
            (20.0, dry(0.0, 0.02), 0.1, 0.0, None, None),
            (20.0, dry(0.0, 0.02), 0.001, 0.001, Some(NoSticking), Some(NoSticking)),
            (20.0, dry(0.0, 0.02), 0.1, -0.3, Some(WrongPhase), None),
        ] {
            let motion = motion(stiffness, friction, x0, v0);
            let found = FORMULAS.map(|formula| Remark::of(formula, &motion));
            assert_eq!(found, [printed, corrected], "{stiffness} {x0} {v0}");
        }
        let stokes = motion(20.0, Stokes::new(0.2).unwrap(), -0.1, -0.3);
        for formula in FORMULAS {
            assert_eq!(Remark::of(formula, &stokes), None);
        }
        let undamped = motion(20.0, Friction::NONE, -0.1, -0.3);
        assert_eq!(Remark::of(FORMULAS[0], &undamped), None);
    }

    #[test]
    fn of_the_scheme() {
        let scheme = |friction: Friction| {
            let article = scheme::named("article-scheme").map(Candidate::Scheme).unwrap();
            Remark::of(article, &motion(20.0, friction, 0.1, 0.0))
        };
        assert_eq!(scheme(dry(0.02, 0.03).into()), Some(Remark::Chatters));
        assert_eq!(scheme(Friction::NONE), Some(Remark::SecondOrder));
        assert_eq!(scheme(dry(0.0, 0.02).into()), Some(Remark::SecondOrder));
        assert_eq!(scheme(dry(0.0, 0.9).into()), Some(Remark::NoSticking));
        assert_eq!(scheme(Stokes::new(0.2).unwrap().into()), Some(Remark::FirstOrder));
        assert_eq!(scheme(Newton::new(0.2).unwrap().into()), Some(Remark::FirstOrder));
    }
}
