//! The stiffness matrix of a frame: as many negative pivots as negative eigenvalues, and solutions where it is singular.

use nalgebra::DMatrix;

/// A symmetric matrix by rows, each from its first entry to the diagonal.
pub(super) struct Envelope {
    /// Column of the first entry of each row.
    starts: Vec<usize>,
    /// Place of the first entry of each row, and the number of all entries.
    places: Vec<usize>,
    entries: Vec<f64>,
}

/// The factors of a matrix with exchanged rows.
pub(super) struct FrameElimination {
    rows: Vec<Vec<f64>>,
    /// Row exchanged with each row.
    order: Vec<usize>,
    scale: Vec<f64>,
}

impl Envelope {
    /// Zeros, with room for what couples the unknowns of each group.
    pub(super) fn zeros(size: usize, groups: impl Iterator<Item = [Option<usize>; 6]>) -> Self {
        let mut starts: Vec<usize> = (0..size).collect();
        for group in groups {
            let Some(first) = group.into_iter().flatten().min() else { continue };
            for row in group.into_iter().flatten() {
                starts[row] = starts[row].min(first);
            }
        }
        let mut places = Vec::with_capacity(size + 1);
        places.push(0);
        let mut all = 0;
        for (row, start) in starts.iter().enumerate() {
            all += row + 1 - start;
            places.push(all);
        }
        Self { starts, places, entries: vec![0.0; all] }
    }

    /// Adds to an entry at or below the diagonal.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        self.entries[self.places[row] + column - self.starts[row]] += value;
    }

    /// The full matrix.
    pub(super) fn full(&self) -> DMatrix<f64> {
        let size = self.starts.len();
        let mut full = DMatrix::zeros(size, size);
        for (row, start) in self.starts.iter().enumerate() {
            let entries = &self.entries[self.places[row]..self.places[row + 1]];
            for (column, entry) in (*start..).zip(entries) {
                full[(row, column)] = *entry;
                full[(column, row)] = *entry;
            }
        }
        full
    }

    /// The pivots of `L D Lᵀ`, of which as many are negative as there are eigenvalues below zero; one that vanishes is
    /// replaced by rounding.
    pub(super) fn pivots(self) -> Vec<f64> {
        let Envelope { starts, places, mut entries } = self;
        let mut diagonal: Vec<f64> = Vec::with_capacity(starts.len());
        for row in 0..starts.len() {
            let start = starts[row];
            let (above, rest) = entries.split_at_mut(places[row]);
            let own = &mut rest[..=row - start];
            let size = own[row - start].abs();
            for column in start..row {
                let (first, other) = (starts[column].max(start), &above[places[column]..]);
                let left = &own[first - start..column - start];
                let up = &other[first - starts[column]..column - starts[column]];
                let known: f64 = left.iter().zip(up).map(|(a, b)| a * b).sum();
                own[column - start] -= known;
            }
            let mut pivot = own[row - start];
            for column in start..row {
                let entry = own[column - start];
                let multiple = entry / diagonal[column];
                pivot -= entry * multiple;
                own[column - start] = multiple;
            }
            let least = f64::EPSILON * size.max(f64::MIN_POSITIVE);
            diagonal.push(if pivot.abs() < least { least.copysign(pivot) } else { pivot });
        }
        diagonal
    }
}

impl FrameElimination {
    /// Gaussian elimination with partial pivoting of the matrix scaled to even rows: where a member resonates between joints
    /// at rest, a part of the matrix is singular that the elimination without pivoting would begin with.
    pub(super) fn of(matrix: &Envelope) -> Self {
        let full = matrix.full();
        let size = full.nrows();
        let scale: Vec<f64> =
            full.row_iter().map(|row| row.amax().max(f64::MIN_POSITIVE).sqrt().recip()).collect();
        let mut rows: Vec<Vec<f64>> =
            (0..size).map(|i| (0..size).map(|j| full[(i, j)] * scale[i] * scale[j]).collect()).collect();
        let mut order = Vec::with_capacity(size);
        for column in 0..size {
            let at = (column..size)
                .max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))
                .unwrap_or(column);
            rows.swap(column, at);
            order.push(at);
            let (above, below) = rows.split_at_mut(column + 1);
            let pivot = &mut above[column];
            if pivot[column].abs() < f64::EPSILON {
                pivot[column] = f64::EPSILON.copysign(pivot[column]);
            }
            for row in below {
                if row[column] == 0.0 {
                    continue;
                }
                let multiple = row[column] / pivot[column];
                row[column] = multiple;
                for (entry, own) in row[column + 1..].iter_mut().zip(&pivot[column + 1..]) {
                    *entry -= multiple * own;
                }
            }
        }
        Self { rows, order, scale }
    }

    /// Solves with the factors.
    pub(super) fn solve(&self, x: &mut [f64]) {
        x.iter_mut().zip(&self.scale).for_each(|(x, scale)| *x *= scale);
        // The multiples were exchanged with their rows.
        for (column, at) in self.order.iter().enumerate() {
            x.swap(column, *at);
        }
        for row in 0..x.len() {
            let known: f64 = self.rows[row][..row].iter().zip(&x[..row]).map(|(a, x)| a * x).sum();
            x[row] -= known;
        }
        for row in (0..x.len()).rev() {
            let entries = &self.rows[row];
            let known: f64 = entries[row + 1..].iter().zip(&x[row + 1..]).map(|(a, x)| a * x).sum();
            x[row] = (x[row] - known) / entries[row];
        }
        x.iter_mut().zip(&self.scale).for_each(|(x, scale)| *x *= scale);
    }
}
