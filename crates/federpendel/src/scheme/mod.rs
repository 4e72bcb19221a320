//! Numeric schemes, to be held beside the exact motion; one file each.

pub mod article;
