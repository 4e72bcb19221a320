//! What a user of the article's formulas and scheme should know.

use federpendel::lens::Remark;
use federpendel_text::Catalogue;

use crate::record::{Record, Source};

/// One sentence about the method of this record, where there is something to say.
pub(crate) fn remark(catalogue: &Catalogue, record: &Record) -> Option<String> {
    // What is said of a scheme holds as long as it has not run away.
    if record.too_long_step().is_some() {
        return None;
    }
    let remark = Remark::of(record.method.candidate()?, &record.motion)?;
    let equation = match record.other.as_ref()?.source {
        Source::Equation(number) => Some(number),
        Source::Steps { .. } => None,
    };
    Some(catalogue.remark(remark, equation))
}
