//! QR factorisation by plane rotations of a sparse matrix with a known pattern: factored without any branch, so that
//! several matrices can be taken in the lanes of a SIMD vector.
//!
//! ```
//! use dalembert_numerics::givens::GivensQr;
//!
//! // 2 x₂ = 4 and 3 x₁ + x₂ = 5. The entries stand in an array; each row has places in it and columns.
//! let entries = [2.0, 3.0, 1.0];
//! let rows = [vec![(0, 1)], vec![(1, 0), (2, 1)]];
//! let mut factors = GivensQr::new(&rows);
//! factors.factor(|place| entries[place]);
//! let mut x = [4.0, 5.0];
//! factors.solve(&mut x);
//! assert!((x[0] - 1.0).abs() < 1e-14 && (x[1] - 2.0).abs() < 1e-14);
//! // The determinant is −6: only its sign is kept.
//! assert!(factors.determinant()[0] < 0.0);
//! ```

use std::collections::BTreeSet;

use crate::simd::SimdReal;

/// Added to the diagonal before a plane rotation, so that a column of zeros has a direction: its square is above the
/// smallest number, and it changes no number above 10⁻¹³⁴.
const ROTATION_GUARD: f64 = 1e-150;

/// Orders of rows and columns of a square matrix that take few rotations, from the entries of each row, a pair of place
/// and column each, as for [`GivensQr::new`]: of what is left, the column that the fewest rows have goes first (J. A.
/// George, M. T. Heath, *Linear Algebra and its Applications* 34, 1980). So a loop that depends on another one is
/// separated from it.
pub fn ordering(rows: &[Vec<(usize, usize)>]) -> [Vec<usize>; 2] {
    let mut entries: Vec<BTreeSet<usize>> =
        rows.iter().map(|row| row.iter().map(|(_, column)| *column).collect()).collect();
    let mut left: BTreeSet<usize> = (0..rows.len()).collect();
    let mut rows_of = vec![BTreeSet::new(); rows.len()];
    for (row, entries) in entries.iter().enumerate() {
        for &column in entries {
            rows_of[column].insert(row);
        }
    }
    // The columns that are left, by the number of their rows.
    let mut queue: BTreeSet<(usize, usize)> = rows_of.iter().map(BTreeSet::len).zip(0..).collect();
    let mut ordered = [Vec::new(), Vec::new()];
    while let Some((_, column)) = queue.pop_first() {
        let Some(row) = rows_of[column].first().or(left.first()).copied() else { break };
        left.remove(&row);
        let mut merged = std::mem::take(&mut entries[row]);
        for &other in &merged {
            let rows = &mut rows_of[other];
            let is_left = queue.remove(&(rows.len(), other));
            rows.remove(&row);
            queue.extend(is_left.then_some((rows.len(), other)));
        }
        // A rotation leaves in both rows what either had.
        for other in std::mem::take(&mut rows_of[column]) {
            merged.extend(entries[other].iter());
            for &filled in merged.difference(&entries[other]) {
                let rows = &mut rows_of[filled];
                queue.remove(&(rows.len(), filled));
                rows.insert(other);
                queue.insert((rows.len(), filled));
            }
            entries[other].clone_from(&merged);
            entries[other].remove(&column);
        }
        ordered[0].push(row);
        ordered[1].push(column);
    }
    ordered
}

/// `A = Q R` by plane rotations (Golub and Van Loan, *Matrix Computations*, 4th ed., §5.2.5): stable without a choice
/// of pivots, which would differ from one position to the next. Only entries that the pattern of A or a rotation can
/// make different from zero are stored and computed.
#[derive(Debug, Clone)]
pub struct GivensQr<S> {
    /// The entries of A, then those of R, in their places.
    entries: Vec<S>,
    /// Of each entry of A its place and its place in what it is taken from.
    sources: Vec<(u32, u32)>,
    rotations: Vec<Rotation>,
    /// The places of the entries that are rotated into each other, in the upper row and in the lower one.
    pairs: Vec<[u32; 2]>,
    /// Cosine and sine of each rotation.
    turns: Vec<[S; 2]>,
    rows: Vec<Row>,
    /// The entries of R right of the diagonal, by rows: place and column.
    right: Vec<(u32, u32)>,
    /// The diagonals of R that no rotation has made positive.
    signed: Vec<usize>,
}

/// A plane rotation of two rows that takes away an entry of the lower one.
#[derive(Debug, Clone, Copy)]
struct Rotation {
    /// Upper row, which is the column of the entry too, and lower row.
    rows: [usize; 2],
    /// The place of the diagonal of the upper row, and of the entry.
    places: [usize; 2],
    /// End of its pairs, which begin where those of the rotation before end.
    pairs: usize,
}

/// A row of R.
#[derive(Debug, Clone, Copy)]
struct Row {
    /// The place of its diagonal.
    diagonal: usize,
    /// Begin and end of the entries to the right.
    right: [usize; 2],
}

impl<S: SimdReal> GivensQr<S> {
    /// For square matrices with a list for each row: of each of its entries the place that [`factor`](Self::factor) is
    /// asked for, and the column, both counted from 0.
    pub fn new(rows: &[Vec<(usize, usize)>]) -> Self {
        let mut places: Vec<Vec<(usize, usize)>> = Vec::new();
        let mut count = 0;
        let mut new_place = || {
            count += 1;
            count - 1
        };
        let mut sources = Vec::new();
        for (number, row) in rows.iter().enumerate() {
            let mut of_row: Vec<(usize, usize)> = Vec::new();
            for &(source, column) in row {
                let place = new_place();
                sources.push((place as u32, source as u32));
                of_row.push((column, place));
            }
            if of_row.iter().all(|(column, _)| *column != number) {
                of_row.push((number, new_place()));
            }
            of_row.sort_unstable();
            places.push(of_row);
        }
        let mut rows_of = vec![BTreeSet::new(); rows.len()];
        for (row, places) in places.iter().enumerate() {
            for (column, _) in places {
                rows_of[*column].insert(row);
            }
        }
        let (mut rotations, mut pairs, mut signed) = (Vec::new(), Vec::new(), Vec::new());
        for column in 0..rows.len() {
            let below: Vec<usize> = rows_of[column].range(column + 1..).copied().collect();
            if below.is_empty() {
                signed.push(column);
            }
            for row in below {
                let [mut upper, mut lower] = [column, row].map(|row| std::mem::take(&mut places[row]));
                let other = |&(other, _): &(usize, usize)| other > column;
                let columns: BTreeSet<usize> =
                    upper.iter().chain(&lower).filter(|entry| other(entry)).map(|entry| entry.0).collect();
                for &other in &columns {
                    let mut place = |of_row: &mut Vec<(usize, usize)>, row: usize| {
                        let at = of_row.binary_search_by_key(&other, |entry| entry.0);
                        let at = at.unwrap_or_else(|at| {
                            of_row.insert(at, (other, new_place()));
                            rows_of[other].insert(row);
                            at
                        });
                        of_row[at].1
                    };
                    let pair = [place(&mut upper, column), place(&mut lower, row)];
                    pairs.push(pair.map(|place| place as u32));
                }
                let place = |of_row: &[(usize, usize)]| {
                    of_row.iter().find(|entry| entry.0 == column).map_or(0, |entry| entry.1)
                };
                let of_column = [place(&upper), place(&lower)];
                rotations.push(Rotation { rows: [column, row], places: of_column, pairs: pairs.len() });
                (places[column], places[row]) = (upper, lower);
            }
        }
        let mut right = Vec::new();
        let rows = places.iter().enumerate().map(|(row, places)| {
            let from = right.len();
            let beyond = places.iter().filter(|(column, _)| *column > row);
            right.extend(beyond.map(|&(column, place)| (place as u32, column as u32)));
            let diagonal = places.iter().find(|(column, _)| *column == row).map_or(0, |(_, place)| *place);
            Row { diagonal, right: [from, right.len()] }
        });
        let rows = rows.collect();
        let zero = S::from(0.0);
        Self {
            entries: vec![zero; count],
            sources,
            turns: vec![[zero; 2]; rotations.len()],
            rotations,
            pairs,
            rows,
            right,
            signed,
        }
    }

    /// Factors the matrix with the entries that a function has in their places.
    #[inline(always)]
    pub fn factor(&mut self, entry: impl Fn(usize) -> S) {
        let Self { entries, sources, rotations, pairs, turns, .. } = self;
        entries.fill(S::from(0.0));
        for &(place, source) in &*sources {
            entries[place as usize] = entry(source as usize);
        }
        let mut from = 0;
        for (turn, rotation) in turns.iter_mut().zip(&*rotations) {
            let [diagonal, below] = rotation.places;
            let (a, b) = (entries[diagonal] + ROTATION_GUARD, entries[below]);
            let square = a * a + b * b;
            let short = S::from(1.0) / square.sqrt();
            let (cos, sin) = (a * short, b * short);
            *turn = [cos, sin];
            entries[diagonal] = square * short;
            for &[upper, lower] in &pairs[from..rotation.pairs] {
                let [p, q] = [entries[upper as usize], entries[lower as usize]];
                entries[upper as usize] = cos * p + sin * q;
                entries[lower as usize] = cos * q - sin * p;
            }
            from = rotation.pairs;
        }
    }

    /// The product of the diagonals of R whose signs are left open, which has the sign of the determinant, and the
    /// smallest diagonal over the largest: small near a singular position.
    #[inline(always)]
    pub fn determinant(&self) -> [S; 2] {
        let one = S::from(1.0);
        let Some(last) = self.rows.last() else { return [one, one] };
        let last = self.entries[last.diagonal].abs();
        let (mut least, mut most) = (last, last);
        for row in &self.rows[..self.rows.len() - 1] {
            let diagonal = self.entries[row.diagonal].abs();
            least = least.with(diagonal, f64::min);
            most = most.with(diagonal, f64::max);
        }
        let mut product = one;
        for &row in &self.signed {
            product = product * self.entries[self.rows[row].diagonal];
        }
        [product, least / most]
    }

    /// `A x = b` in place, with an entry for each row; without meaning where A is singular, see
    /// [`determinant`](Self::determinant).
    #[inline(always)]
    pub fn solve(&self, x: &mut [S]) {
        for ([cos, sin], rotation) in self.turns.iter().zip(&self.rotations) {
            let [upper, lower] = rotation.rows;
            let [p, q] = [x[upper], x[lower]];
            x[upper] = *cos * p + *sin * q;
            x[lower] = *cos * q - *sin * p;
        }
        for (number, row) in self.rows.iter().enumerate().rev() {
            let mut sum = x[number];
            for &(place, column) in self.right(row) {
                sum = sum - self.entries[place as usize] * x[column as usize];
            }
            x[number] = sum / self.entries[row.diagonal];
        }
    }

    /// `Aᵀ y = g` in place, with an entry for each row.
    #[inline(always)]
    pub fn solve_transposed(&self, y: &mut [S]) {
        for (number, row) in self.rows.iter().enumerate() {
            let known = y[number] / self.entries[row.diagonal];
            y[number] = known;
            for &(place, column) in self.right(row) {
                y[column as usize] = y[column as usize] - self.entries[place as usize] * known;
            }
        }
        for ([cos, sin], rotation) in self.turns.iter().zip(&self.rotations).rev() {
            let [upper, lower] = rotation.rows;
            let [p, q] = [y[upper], y[lower]];
            y[upper] = *cos * p - *sin * q;
            y[lower] = *cos * q + *sin * p;
        }
    }

    #[inline(always)]
    fn right(&self, row: &Row) -> &[(u32, u32)] {
        let [from, to] = row.right;
        &self.right[from..to]
    }
}
