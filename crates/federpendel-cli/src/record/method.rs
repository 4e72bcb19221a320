//! By which method samples are computed.

/// A method of computing the motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The exact motion, to rounding.
    Exact,
}

impl Method {
    /// All methods.
    pub const ALL: [Method; 1] = [Method::Exact];

    /// Its name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Method::Exact => "exact",
        }
    }

    /// The method of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }
}
