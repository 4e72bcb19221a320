//! A file that the system does not read.

use std::io;
use std::sync::Arc;

use super::error::ReadError;

/// What the system says where it does not read a file.
#[derive(Debug, Clone)]
pub struct SystemError(pub Arc<io::Error>);

impl PartialEq for SystemError {
    fn eq(&self, other: &Self) -> bool {
        let what = |error: &io::Error| (error.kind(), error.raw_os_error());
        what(&self.0) == what(&other.0)
    }
}

impl From<io::Error> for ReadError {
    /// What a stream refuses in its own words, else what the system says.
    fn from(error: io::Error) -> Self {
        match error.downcast::<ReadError>() {
            Ok(refused) => refused,
            Err(error) => ReadError::System(SystemError(Arc::new(error))),
        }
    }
}
