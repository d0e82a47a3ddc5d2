//! Matrices with few entries different from zero.

use nalgebra::DMatrix;

/// A matrix by rows: of each the columns, counted from 0, and the entries, in any order, a column once at most.
#[derive(Debug, Clone, PartialEq)]
pub struct SparseMatrix {
    columns: usize,
    rows: Vec<Vec<(usize, f64)>>,
}

impl SparseMatrix {
    /// A matrix with so many columns and these rows, each a list of column, counted from 0, and entry.
    pub fn new(columns: usize, rows: Vec<Vec<(usize, f64)>>) -> Self {
        Self { columns, rows }
    }

    /// The number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The rows: columns and entries of each.
    pub fn rows(&self) -> &[Vec<(usize, f64)>] {
        &self.rows
    }

    /// The rows, to be changed.
    pub fn rows_mut(&mut self) -> &mut [Vec<(usize, f64)>] {
        &mut self.rows
    }

    /// Some of the rows, each once at most, in this order.
    #[must_use]
    pub fn select_rows(mut self, rows: &[usize]) -> Self {
        let selected = rows.iter().map(|&row| std::mem::take(&mut self.rows[row])).collect();
        Self { columns: self.columns, rows: selected }
    }

    /// Some of the columns, in this order.
    #[must_use]
    pub fn select_columns(mut self, columns: &[usize]) -> Self {
        let mut numbers = vec![None; self.columns];
        for (number, &column) in columns.iter().enumerate() {
            numbers[column] = Some(number);
        }
        for row in &mut self.rows {
            row.retain_mut(|(column, _)| numbers[*column].inspect(|number| *column = *number).is_some());
        }
        Self { columns: columns.len(), rows: self.rows }
    }

    /// `Aᵀ`.
    #[must_use]
    pub fn transpose(&self) -> Self {
        let mut rows = vec![Vec::new(); self.columns];
        for (row, entries) in self.rows.iter().enumerate() {
            for &(column, x) in entries {
                rows[column].push((row, x));
            }
        }
        Self { columns: self.rows.len(), rows }
    }

    /// `A Aᵀ`.
    #[must_use]
    pub fn times_transpose(&self) -> Self {
        let by_column = self.transpose();
        // Where a column stands in the row of the product, from 1; 0 for those that it does not have.
        let mut position = vec![0; self.rows.len()];
        let product = self.rows.iter().map(|entries| {
            let mut row: Vec<(usize, f64)> = Vec::new();
            for &(column, a) in entries {
                for &(other, b) in &by_column.rows[column] {
                    if position[other] == 0 {
                        row.push((other, 0.0));
                        position[other] = row.len();
                    }
                    row[position[other] - 1].1 += a * b;
                }
            }
            for (other, _) in &row {
                position[*other] = 0;
            }
            row
        });
        let product = product.collect();
        Self { columns: self.rows.len(), rows: product }
    }

    /// `Aᵀ x`, for x with an entry for each row.
    pub fn transposed_times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.columns];
        for (row, x) in self.rows.iter().zip(x) {
            for &(column, a) in row {
                product[column] += a * x;
            }
        }
        product
    }

    /// Adds a number to the entry of a row in its own column: to the diagonal.
    pub fn add_to_diagonal(&mut self, row: usize, x: f64) {
        match self.rows[row].iter_mut().find(|(column, _)| *column == row) {
            Some((_, entry)) => *entry += x,
            None => self.rows[row].push((row, x)),
        }
    }
}

impl From<&DMatrix<f64>> for SparseMatrix {
    fn from(a: &DMatrix<f64>) -> Self {
        let row = |row: usize| {
            let entry = |column: usize| (column, a[(row, column)]);
            (0..a.ncols()).map(entry).filter(|(_, x)| *x != 0.0).collect()
        };
        Self { columns: a.ncols(), rows: (0..a.nrows()).map(row).collect() }
    }
}
