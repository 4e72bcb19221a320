//! What the reader says of the experiment beside its recording, field by field as written.

use federpendel::parameter::Range;
use federpendel_fit::read::{Choice, ColumnName, Field, Read, ReadError};
use federpendel_fit::{Given, Options};
use federpendel_quantity::Dimension;
use federpendel_quantity::inputs::{Beside, Inputs, Said};
use federpendel_report::recording::read_error;
use federpendel_text::Catalogue;
use serde::{Deserialize, Serialize};

use crate::Refusal;

/// The fields by their names, with texts; one that is empty or not there says nothing.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
pub struct Asked(serde_json::Map<String, serde_json::Value>);

/// The same as a fit takes it.
pub struct Wanted {
    /// What is read of the file.
    pub choice: Choice,
    /// The choices for the fit.
    pub options: Options,
    /// What was measured beside the recording.
    pub given: Given,
    /// What is assumed of it: fields, and what there is to say of each.
    pub remarks: Vec<(&'static str, String)>,
}

/// Something of a file that a field can be set to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Offer {
    /// What is written into the field.
    pub value: String,
    /// What the reader sees.
    pub label: String,
}

impl<const N: usize> From<[(&str, &str); N]> for Asked {
    fn from(fields: [(&str, &str); N]) -> Self {
        Asked(fields.map(|(name, written)| (name.to_owned(), written.into())).into_iter().collect())
    }
}

impl Asked {
    fn written(&self, name: &str) -> Option<&str> {
        self.0.get(name)?.as_str().map(str::trim).filter(|written| !written.is_empty())
    }

    /// All that is written, read.
    ///
    /// # Errors
    /// The first field that is refused.
    pub fn read(&self, catalogue: &Catalogue) -> Result<Wanted, Refusal> {
        let refused = |said: Said| Refusal::new(said.input, said.sentence);
        let inputs = Inputs { catalogue, called };
        let owned = |name: &str| self.written(name).map(str::to_owned);
        let rate = inputs
            .value("rate", Range::Positive, &[Dimension::Frequency], self.written("rate"))
            .map_err(refused)?;
        let [from, to] =
            inputs.window(self.written("from"), self.written("to")).map_err(refused)?;
        // What presses on the guide is the weight or a force, never both.
        let support = self.written("support");
        let beside = Beside {
            mass: owned("mass"),
            stiffness: owned("stiffness"),
            spring_mass: owned("spring_mass"),
            normal_force: owned("normal_force").filter(|_| support == Some("force")),
            horizontal: support == Some("horizontal"),
            gravity: None,
        };
        let (given, remarks) = inputs.given(&beside).map_err(refused)?;
        Ok(Wanted {
            choice: Choice {
                time: owned("time"),
                value: owned("value"),
                unit: owned("unit"),
                table: owned("table"),
                rate,
                ..Choice::default()
            },
            options: Options { from, to, ..Options::default() },
            given,
            remarks: remarks.into_iter().map(|said| (said.input, said.sentence)).collect(),
        })
    }

    /// The field to which a refusal of what is fitted belongs.
    pub fn field_of_fit(&self) -> &'static str {
        ["from", "to"].into_iter().find(|name| self.written(name).is_some()).unwrap_or("file")
    }
}

/// What stands beside a field.
fn called(catalogue: &Catalogue, field: &str) -> String {
    catalogue.text(&format!("asked-{}", field.replace('_', "-")))
}

/// A file that is refused, at the field that can mend it, with what that can be set to.
pub fn refused_file(catalogue: &Catalogue, error: &ReadError, file: &str) -> Refusal {
    let numbered = |columns: &[String]| {
        let offer = |(at, label): (usize, &String)| Offer {
            value: (at + 1).to_string(),
            label: label.clone(),
        };
        columns.iter().enumerate().map(offer).collect()
    };
    let named = |names: &[String]| {
        names.iter().map(|name| Offer { value: name.clone(), label: name.clone() }).collect()
    };
    let (field, offers) = match error {
        ReadError::NoTime { columns } => ("time", numbered(columns)),
        ReadError::NoValue { columns } => ("value", numbered(columns)),
        ReadError::ColumnNotFound { field: Field::Time, .. }
        | ReadError::ColumnAmbiguous { field: Field::Time, .. }
        | ReadError::TimeUnit { .. } => ("time", vec![]),
        ReadError::ColumnNotFound { .. } | ReadError::ColumnAmbiguous { .. } => ("value", vec![]),
        ReadError::SeveralTables { tables } | ReadError::TableNotFound { tables, .. } => {
            ("table", named(tables))
        }
        ReadError::ValueUnit { .. } => ("unit", vec![]),
        ReadError::Rate { .. } | ReadError::RateAndTime { .. } => ("rate", vec![]),
        _ => ("file", vec![]),
    };
    Refusal { offers, ..Refusal::new(field, read_error(catalogue, error, file)) }
}

/// The columns that could be read instead of `column`, and it itself. Of several runs each has its own columns, which only
/// their names without the run have in common.
pub fn columns(read: &Read, column: Option<&ColumnName>) -> Vec<Offer> {
    let mut columns: Vec<&ColumnName> = Vec::new();
    for column in column.into_iter().chain([&read.value]).chain(&read.others) {
        let at = columns.partition_point(|before| before.number < column.number);
        if columns.get(at).is_none_or(|same| same.number != column.number) {
            columns.insert(at, column);
        }
    }
    let offer = |column: &ColumnName| match read.run {
        None => Offer { value: column.number.to_string(), label: column.label.clone() },
        Some(_) => Offer { value: column.name.clone(), label: column.name.clone() },
    };
    columns.into_iter().map(offer).collect()
}
