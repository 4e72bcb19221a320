//! What a user of the article's formulas and scheme should know.

use federpendel_text::Catalogue;

use crate::record::{Record, Remark, Source};

/// One sentence about the method of this record, where there is something to say.
pub(crate) fn remark(catalogue: &Catalogue, record: &Record) -> Option<String> {
    // What is said of a scheme holds as long as it has not run away.
    if record.too_long_step().is_some() {
        return None;
    }
    let id = match Remark::of(record.method, &record.motion)? {
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
    let method = match record.other.as_ref()?.source {
        Source::Equation(number) => {
            catalogue.format("remark-equation", &[("number", number.into())])
        }
        Source::Steps { .. } => catalogue.text("remark-scheme"),
    };
    Some(catalogue.format(id, &[("method", method.into())]))
}
