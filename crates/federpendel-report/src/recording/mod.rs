//! What is said of a recording and of its fit: why it is refused, how it was read, what acts; and the report of it.

mod caution;
mod damping;
mod decrement;
mod figures;
mod fitted;
mod law;
mod method;
mod mixes;
mod note;
mod physical;
mod reading;
mod refused_file;
mod refused_fit;
mod report;
mod result;
mod rows;
mod summary;
mod uncertainty;
mod verdict;
mod writer;

pub use damping::damping_rows;
pub use fitted::Fitted;
pub use note::{edge, read_note, stop_reason};
pub use physical::{physical_rows, physical_sentences};
pub use refused_file::read_error;
pub use refused_fit::fit_error;
pub use report::{document, sections};
pub use rows::{about_rows, parameter_rows, parameter_value, residual_row};
pub use uncertainty::correlation;
pub use verdict::sentences;
pub use writer::parameter_name;
