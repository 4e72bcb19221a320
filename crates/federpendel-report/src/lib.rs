//! Reports that a person reads: what is said ([`Document`]), the page it is written on ([`html`]), and
//! drawings that may stand in it ([`sketch`]).
//!
//! [`article`] is the report on the German article from which federpendel started: its claims, each
//! checked by computation for one experiment. [`recording`] says what a fit found, [`plan`] what a plan
//! comes to.

pub mod article;
pub mod document;
#[cfg(feature = "pages")]
pub mod html;
pub mod plain;
pub mod plan;
pub mod recording;
pub mod sketch;

pub use document::{Block, Claim, Document, Row, Section, Verdict};
