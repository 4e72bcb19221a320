//! The matrix of derivatives.

use super::Parameters;

/// Derivatives of each value (rows) with respect to each of the [`Parameters`] (columns, in the order of the fields),
/// column after column in memory.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Jacobian {
    rows: usize,
    entries: Vec<f64>,
}

impl Jacobian {
    /// A matrix of no rows, to be filled by [`super::evaluate`].
    pub fn new() -> Self {
        Self::default()
    }

    /// Number of rows, one for each sample.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The derivatives of all samples with respect to parameter `index`.
    ///
    /// # Panics
    /// If there is no such parameter.
    pub fn column(&self, index: usize) -> &[f64] {
        &self.entries[index * self.rows..(index + 1) * self.rows]
    }

    /// All entries, column after column.
    pub fn entries(&self) -> &[f64] {
        &self.entries
    }

    /// Makes room for so many samples; what it holds then is of no use.
    pub(super) fn resize(&mut self, rows: usize) {
        self.rows = rows;
        self.entries.resize(rows * Parameters::COUNT, 0.0);
    }

    /// All columns.
    pub(super) fn columns_mut(&mut self) -> [&mut [f64]; Parameters::COUNT] {
        let mut rest = self.entries.as_mut_slice();
        std::array::from_fn(|_| {
            let (column, others) = std::mem::take(&mut rest).split_at_mut(self.rows);
            rest = others;
            column
        })
    }
}
