//! What is said of a recording and of its fit: why it is refused, how it was read, what acts.

mod fitted;
mod law;
mod note;
mod refused_file;
mod refused_fit;
mod verdict;

pub use fitted::Fitted;
pub use note::{edge, read_note, stop_reason};
pub use refused_file::read_error;
pub use refused_fit::fit_error;
pub use verdict::sentences;
