//! An experiment while it is put together: values with the places they come from.

use std::collections::BTreeMap;

use federpendel_text::excerpt;

use super::{Error, Field};
use crate::quantity;

/// Where a value stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// In the experiment file, on this line (from 1).
    File {
        /// The line.
        line: usize,
    },
    /// On the command line.
    Flag,
}

/// A value as it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Given {
    /// Which value.
    pub field: Field,
    /// As it was written.
    pub written: String,
    /// Where.
    pub origin: Origin,
    /// In SI units.
    pub value: f64,
}

/// The values given so far; at most one for each field.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Draft {
    values: BTreeMap<Field, Given>,
}

impl Draft {
    /// What was given for `field`.
    pub fn get(&self, field: Field) -> Option<&Given> {
        self.values.get(&field)
    }

    /// Reads `quantity`, which stands at `origin` as `written`, into `field`.
    ///
    /// # Errors
    /// [`Error::Quantity`], and [`Error::Both`] if the same place already says it in another form.
    pub(super) fn set(
        &mut self,
        field: Field,
        quantity: &str,
        written: String,
        origin: Origin,
    ) -> Result<(), Error> {
        let value = quantity::parse(quantity, field.dimension());
        let given = Given { field, written, origin, value: value.clone().unwrap_or(f64::NAN) };
        if let Err(error) = value {
            return Err(Error::Quantity { given, error });
        }
        let rival = field.rivals().iter().find_map(|rival| self.values.get(rival));
        if let Some(rival) = rival {
            return Err(Error::Both { first: rival.clone(), second: given });
        }
        self.values.insert(field, given);
        Ok(())
    }

    /// Replaces fields by those given as flags, and with each the other forms of the same thing.
    ///
    /// # Errors
    /// As for a file: values that cannot be read, two forms of one thing among the flags.
    pub fn override_with<'a>(
        &mut self,
        flags: impl IntoIterator<Item = (Field, &'a str)>,
    ) -> Result<(), Error> {
        let mut overrides = Draft::default();
        for (field, text) in flags {
            overrides.set(field, text, excerpt(text), Origin::Flag)?;
        }
        for field in overrides.values.keys() {
            for rival in field.rivals() {
                self.values.remove(rival);
            }
        }
        self.values.append(&mut overrides.values);
        Ok(())
    }
}
