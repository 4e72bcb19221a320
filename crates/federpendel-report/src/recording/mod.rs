//! What is said of a recording and of its fit: why it is refused, how it was read, what acts.

mod damping;
mod fitted;
mod law;
mod note;
mod physical;
mod refused_file;
mod refused_fit;
mod verdict;

pub use damping::damping_rows;
pub use fitted::Fitted;
pub use note::{edge, read_note, stop_reason};
pub use physical::{physical_rows, physical_sentences};
pub use refused_file::read_error;
pub use refused_fit::fit_error;
pub use verdict::sentences;
