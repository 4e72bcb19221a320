//! Methods beside the exact motion: which, how far they are from it, and what they cost.

mod measured;

pub(crate) use federpendel::lens::Candidate;
pub(crate) use measured::Measured;

use federpendel::Error;
use federpendel::scheme::Setting;

use crate::progress::Progress;
use crate::record::Record;

/// The exact motion with everything that was found of methods beside it.
pub(crate) struct Comparison {
    /// The exact motion.
    pub record: Record,
    /// The methods in the order in which they were asked for.
    pub methods: Vec<Compared>,
}

/// A method and what was found of it.
pub(crate) struct Compared {
    /// The method.
    pub candidate: Candidate,
    /// What was found, or why it failed.
    pub found: Result<Measured, Error>,
}

impl Comparison {
    /// Holds `candidates` beside the motion of `record`, each with what it needs of `setting`.
    pub(crate) fn compute(
        record: Record,
        candidates: Vec<Candidate>,
        setting: &Setting,
        progress: &Progress,
    ) -> Self {
        let compare = |candidate: Candidate| {
            let found = Measured::of(candidate, &record, setting);
            progress.advance(1);
            Compared { candidate, found }
        };
        let methods = candidates.into_iter().map(compare).collect();
        Comparison { record, methods }
    }

    /// The methods that did not fail.
    pub(crate) fn measured(&self) -> impl Iterator<Item = (Candidate, &Measured)> {
        self.methods
            .iter()
            .filter_map(|compared| Some((compared.candidate, compared.found.as_ref().ok()?)))
    }
}
