//! The lowest modes of banded matrices, by the Lanczos method on the inverse.

use nalgebra::{DMatrix, DVector};

use super::{
    LinalgError, Random, SymmetricEigen,
    band::{Factors, SymmetricBand},
    finite, not_above, power_of_two_below, symmetric_eigen,
};
use crate::simd::widest;

/// The most numbers that the vectors of the iteration may take.
const MOST_NUMBERS: usize = 24_000_000;

/// Shift `s` of `K + s M`, which is inverted where K is singular: a share of the largest entry of K (M being near 1)
/// that lies below the first elastic eigenvalue of a chain and yet leaves its digits to the inverse.
fn shift_of(size: usize) -> f64 {
    (0.1 / (size as f64).powi(3)).clamp(1e-11, 1e-4)
}

/// The `count` lowest eigenvalues of `K φ = λ M φ`, ascending, and vectors with `φᵀ M φ = 1`.
///
/// K may be singular (rigid body modes have the value zero) but not indefinite; M must be positive definite.
/// The Lanczos method runs on `(K − σ M)⁻¹ M` with full orthogonalisation and thick restarts (Bai et al., Templates
/// for the Solution of Algebraic Eigenvalue Problems, §4.5 and §5.5). Sylvester's law of inertia says that no value
/// was left out, repeated ones included. The values are Rayleigh quotients with twice the digits, so that the low
/// modes of a stiff chain keep theirs.
///
/// # Errors
/// `Shape` unless K and M have the same size and 1 ≤ count ≤ that size; `TooLarge`; `NotFinite`;
/// `NotPositiveDefinite`; `NotConverged`.
pub fn lowest_modes(
    k: &SymmetricBand,
    m: &SymmetricBand,
    count: usize,
) -> Result<SymmetricEigen, LinalgError> {
    let n = k.size();
    if m.size() != n || count == 0 || count > n {
        return Err(LinalgError::Shape {
            rows: m.size(),
            columns: count,
            wanted: "matrices of the same size and at least one mode, at most as many as there are rows",
        });
    }
    not_above("modes of a matrix of this size", count, (MOST_NUMBERS / n).saturating_sub(10).max(1))?;
    finite(k.entries().iter().chain(m.entries()))?;
    if let Some(row) = (0..n).find(|&row| m.diagonal_of(row) <= 0.0) {
        return Err(LinalgError::NotPositiveDefinite { matrix: "mass", row: row + 1 });
    }
    let scale: Vec<f64> = (0..n).map(|row| 1.0 / power_of_two_below(m.diagonal_of(row).sqrt())).collect();
    let k = k.scaled(&scale, 1.0);
    let size =
        power_of_two_below(k.entries().iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs())));
    let k = k.scaled(&vec![1.0; n], size);
    let m = m.scaled(&scale, 1.0);
    finite(k.entries().iter().chain(m.entries()))?;
    if m.width() > 0
        && let Some(row) = Factors::of(&m, &m, 0.0).doubtful
    {
        return Err(LinalgError::NotPositiveDefinite { matrix: "mass", row: row + 1 });
    }

    let mut shift = 0.0;
    let mut factors = Factors::of(&k, &m, shift);
    if factors.doubtful.is_some() {
        shift = -shift_of(n);
        factors = Factors::of(&k, &m, shift);
        if factors.negative > 0 {
            let row = factors.doubtful.unwrap_or(0);
            return Err(LinalgError::NotPositiveDefinite { matrix: "stiffness", row: row + 1 });
        }
    }

    let mut lanczos = Lanczos::new(&m, factors, count);
    if let Some(nearer) = lanczos.nearer_shift(&k, shift, count)? {
        shift = nearer;
        lanczos.go_on_from(Factors::of(&k, &m, shift));
    }
    let mut values;
    loop {
        let found = lanczos.run(count)?;
        lanczos.part(&k, count)?;
        values = lanczos.quotients(&k, count);
        // Values between the last one and a little above it would have been left out.
        let last = shift + 1.0 / found;
        let last = values.iter().fold(last, |last: f64, value| last.max(*value));
        let limit = last - 1e-9 * (last - shift) - 8.0 * f64::EPSILON;
        let seen = values.iter().filter(|value| **value < limit).count();
        if Factors::of(&k, &m, limit).negative <= seen {
            break;
        }
        lanczos.enrich()?;
    }

    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&p, &q| values[p].total_cmp(&values[q]));
    let vectors = DMatrix::from_fn(n, count, |row, mode| lanczos.basis[order[mode]][row] * scale[row]);
    let values = DVector::from_iterator(count, order.iter().map(|&mode| values[mode] * size));
    finite(values.iter().chain(vectors.iter()))?;
    Ok(SymmetricEigen { values, vectors })
}

/// A growing basis, orthonormal in M, and the projection of `A⁻¹ M` on it.
struct Lanczos<'a> {
    m: &'a SymmetricBand,
    factors: Factors,
    basis: Vec<Vec<f64>>,
    /// `qᵢᵀ M A⁻¹ M qⱼ` for each column j that has been worked, i up to its last neighbour.
    columns: Vec<Vec<f64>>,
    /// Norm of the component of each processed column outside the basis: a multiple of the next vector.
    outside: Vec<f64>,
    next: Vec<f64>,
    /// True if the next vector is the remainder of the columns, false if it is a random restart.
    continues: bool,
    momentum: Vec<f64>,
    random: Random,
    most: usize,
    restarts: usize,
}

impl<'a> Lanczos<'a> {
    fn new(m: &'a SymmetricBand, factors: Factors, count: usize) -> Self {
        let n = m.size();
        let most = (MOST_NUMBERS / n).min(3 * count + 40).max(count + 8).min(n);
        let mut random = Random::new();
        let next = (0..n).map(|_| random.next()).collect();
        Self {
            m,
            factors,
            basis: Vec::with_capacity(most),
            columns: Vec::with_capacity(most),
            outside: Vec::with_capacity(most),
            next,
            continues: false,
            momentum: vec![0.0; n],
            random,
            most,
            restarts: 0,
        }
    }

    /// A shift close below the lowest values, where more than `count` of them are alike as seen from the present one, so
    /// that the method would hardly tell them apart. `None` where they are not.
    ///
    /// By bisection between the shift and a Rayleigh quotient, with the number of values below (Sylvester).
    fn nearer_shift(
        &mut self,
        k: &SymmetricBand,
        shift: f64,
        count: usize,
    ) -> Result<Option<f64>, LinalgError> {
        while self.columns.len() < (count + 10).min(self.most) {
            self.step()?;
        }
        let eigen = symmetric_eigen(&self.projection())?;
        let last = self.columns.len() - 1;
        if last + 1 == self.m.size() || self.left(&eigen.vectors, last) <= 1e-6 * eigen.values[last] {
            return Ok(None);
        }
        let below = |value: f64| Factors::of(k, self.m, value).negative;
        let (mut low, mut high) = (shift, shift + 2.0 / eigen.values[last]);
        if below(high) <= count {
            return Ok(None);
        }
        let least = shift_of(self.m.size());
        while high - low > least {
            let middle = 0.5 * (low + high);
            match below(middle) {
                0 => low = middle,
                few if few <= count.div_ceil(2) => break,
                _ => high = middle,
            }
        }
        // No nearer than the bisection went: the lowest value may lie just above `low`.
        let nearer = low - 0.5 * (high - low);
        if nearer <= shift {
            return Ok(None);
        }
        let lowest = (0..count.min(last + 1)).map(|mode| eigen.vectors.column(last - mode));
        let sum = lowest.fold(DVector::zeros(last + 1), |sum, vector| sum + vector);
        self.rotate(1, |_| sum.as_slice().to_vec());
        Ok(Some(nearer))
    }

    /// Begins anew with another inverse, from the first vector of the basis.
    fn go_on_from(&mut self, factors: Factors) {
        self.factors = factors;
        self.next = self.basis.swap_remove(0);
        self.continues = false;
        self.basis.clear();
        self.columns.clear();
        self.outside.clear();
    }

    /// Size of what a vector of the projection leaves outside of the basis.
    fn left(&self, vectors: &DMatrix<f64>, mode: usize) -> f64 {
        let parts = vectors.column(mode).into_iter().zip(&self.outside);
        parts.map(|(entry, outside)| (entry * outside).powi(2)).sum::<f64>().sqrt()
    }

    /// Goes on until the `count` largest values of the projection are settled, puts their vectors first in the
    /// basis and returns the smallest of them.
    fn run(&mut self, count: usize) -> Result<f64, LinalgError> {
        let mut check = (self.columns.len() + count + 10).min(self.most);
        loop {
            while self.columns.len() < check {
                self.step()?;
            }
            let full = self.columns.len() == self.m.size();
            let projection = self.projection();
            let eigen = symmetric_eigen(&projection)?;
            // Largest first.
            let vectors = &eigen.vectors;
            let last = projection.nrows();
            let settled = |mode: usize| {
                let left = self.left(vectors, last - 1 - mode);
                left <= 1e-15 * eigen.values[last - 1].abs().max(1e-300)
                    || left <= 1e-13 * eigen.values[last - 1 - mode]
            };
            let done = full || (0..count).all(settled);
            if done {
                self.restart(vectors, &eigen.values, count.max(last.min(count + 4)));
                return Ok(eigen.values[last - count]);
            }
            if self.columns.len() == self.most {
                self.restarts += 1;
                if self.restarts > 300 {
                    return Err(LinalgError::NotConverged);
                }
                let keep = (count + (self.most - count) / 3).min(self.most - 1);
                self.restart(vectors, &eigen.values, keep);
            }
            check = (self.columns.len() + 5).min(self.most);
        }
    }

    /// Adds a random direction, for a value that the basis has missed.
    fn enrich(&mut self) -> Result<(), LinalgError> {
        self.restarts += 1;
        if self.restarts > 300 || self.columns.len() >= self.most {
            return Err(LinalgError::NotConverged);
        }
        self.start_anew();
        Ok(())
    }

    fn start_anew(&mut self) {
        self.next = (0..self.m.size()).map(|_| self.random.next()).collect();
        self.continues = false;
    }

    /// Takes the next vector into the basis and works its column of the projection.
    fn step(&mut self) -> Result<(), LinalgError> {
        self.admit()?;
        let at = self.basis.len() - 1;
        self.m.multiply(&self.basis[at], &mut self.momentum);
        let mut image = self.momentum.clone();
        self.factors.solve(&mut image);
        self.m.multiply(&image, &mut self.momentum);
        let mut column = vec![0.0; at + 1];
        for (entry, q) in column.iter_mut().zip(&self.basis) {
            *entry = dot(q, &self.momentum);
        }
        for (entry, q) in column.iter().zip(&self.basis) {
            add(&mut image, -entry, q);
        }
        let size = {
            self.m.multiply(&image, &mut self.momentum);
            dot(&image, &self.momentum).max(0.0).sqrt()
        };
        if !size.is_finite() {
            return Err(LinalgError::NotFinite);
        }
        let own = column[at].abs();
        self.columns.push(column);
        self.outside.push(size);
        // An exhausted space: go on in a direction of its own.
        if size > 1e-14 * own {
            self.next = image;
            self.continues = true;
        } else {
            self.start_anew();
        }
        Ok(())
    }

    /// Makes the next vector orthogonal to the basis and of unit length, and takes it in.
    fn admit(&mut self) -> Result<(), LinalgError> {
        if self.continues {
            self.outside.fill(0.0);
        }
        let mut next = std::mem::take(&mut self.next);
        for pass in 0.. {
            self.m.multiply(&next, &mut self.momentum);
            let before = dot(&next, &self.momentum).max(0.0).sqrt();
            let mut taken = 0.0;
            for q in &self.basis {
                let part = dot(q, &self.momentum);
                taken += part * part;
                add(&mut next, -part, q);
            }
            // As long as most of it was in the basis, rounding of what was taken is seen in the rest.
            if taken.sqrt() <= 1e-8 * before {
                break;
            }
            if pass == 4 {
                next = (0..self.m.size()).map(|_| self.random.next()).collect();
            }
            if pass == 8 {
                return Err(LinalgError::NotConverged);
            }
        }
        self.m.multiply(&next, &mut self.momentum);
        let size = dot(&next, &self.momentum).max(0.0).sqrt();
        if !(size.is_finite() && size > 0.0) {
            return Err(LinalgError::NotFinite);
        }
        for entry in &mut next {
            *entry /= size;
        }
        self.basis.push(next);
        Ok(())
    }

    /// Replaces the first `keep` vectors of the basis by sums of its first vectors, some rows at a time.
    fn rotate(&mut self, keep: usize, weights: impl Fn(usize) -> Vec<f64>) {
        const ROWS: usize = 256;
        let n = self.m.size();
        let weights: Vec<Vec<f64>> = (0..keep).map(weights).collect();
        let mut block = vec![0.0; ROWS * keep];
        for from in (0..n).step_by(ROWS) {
            let rows = from..(from + ROWS).min(n);
            for (weights, sums) in weights.iter().zip(block.chunks_exact_mut(ROWS)) {
                let sums = &mut sums[..rows.len()];
                sums.fill(0.0);
                for (q, weight) in self.basis.iter().zip(weights) {
                    add(sums, *weight, &q[rows.clone()]);
                }
            }
            for (q, sums) in self.basis.iter_mut().zip(block.chunks_exact(ROWS)) {
                q[rows.clone()].copy_from_slice(&sums[..rows.len()]);
            }
        }
    }

    fn projection(&self) -> DMatrix<f64> {
        let n = self.columns.len();
        let mut projection = DMatrix::zeros(n, n);
        for (j, column) in self.columns.iter().enumerate() {
            for (i, entry) in column.iter().enumerate() {
                projection[(i, j)] = *entry;
                projection[(j, i)] = *entry;
            }
        }
        projection
    }

    /// Replaces the basis by the vectors of its `keep` largest values, row by row in place.
    fn restart(&mut self, vectors: &DMatrix<f64>, values: &DVector<f64>, keep: usize) {
        let (last, keep) = (values.len(), keep.min(values.len()));
        self.rotate(keep, |mode| vectors.column(last - 1 - mode).iter().copied().collect());
        self.basis.truncate(keep);
        self.outside = (0..keep).map(|mode| self.left(vectors, last - 1 - mode)).collect();
        self.columns = (0..keep)
            .map(|mode| {
                (0..=mode).map(|other| if other == mode { values[last - 1 - mode] } else { 0.0 }).collect()
            })
            .collect();
    }

    /// Parts the first `count` vectors by K itself: the inverse of a nearly singular matrix leaves a little of its
    /// rigid modes in the others (Rayleigh–Ritz).
    fn part(&mut self, k: &SymmetricBand, count: usize) -> Result<(), LinalgError> {
        let mut projection = DMatrix::zeros(count, count);
        for i in 0..count {
            k.multiply(&self.basis[i], &mut self.momentum);
            for j in 0..=i {
                projection[(i, j)] = dot(&self.basis[j], &self.momentum);
                projection[(j, i)] = projection[(i, j)];
            }
        }
        let eigen = symmetric_eigen(&projection)?;
        // The projection of the inverse, and what it leaves, turn with them.
        let turned = DMatrix::from_fn(count, count, |i, j| {
            let parts = eigen.vectors.column(i).component_mul(&eigen.vectors.column(j));
            parts
                .iter()
                .zip(&self.columns)
                .enumerate()
                .map(|(at, (part, column))| part * column[at])
                .sum::<f64>()
        });
        for (j, column) in self.columns.iter_mut().enumerate().take(count) {
            *column = turned.column(j).as_slice()[..=j].to_vec();
        }
        let worst = self.outside[..count].iter().copied().fold(0.0, f64::max);
        self.outside[..count].fill(worst);
        self.rotate(count, |mode| eigen.vectors.column(mode).iter().copied().collect());
        Ok(())
    }

    /// The Rayleigh quotients of the first vectors of the basis; zero where only rounding is left.
    fn quotients(&self, k: &SymmetricBand, count: usize) -> Vec<f64> {
        let mut momentum = vec![0.0; self.m.size()];
        self.basis[..count]
            .iter()
            .map(|x| {
                let (potential, size) = k.energy(x);
                if potential.abs() <= 4.0 * f64::EPSILON * size {
                    return 0.0;
                }
                // Nothing cancels in the kinetic energy.
                self.m.multiply(x, &mut momentum);
                potential / dot(x, &momentum)
            })
            .collect()
    }
}

/// `x·y` in sixteen sums, which the compiler keeps side by side.
fn dot(x: &[f64], y: &[f64]) -> f64 {
    widest(
        #[inline(always)]
        || {
            let mut sums = [0.0; 16];
            let ((x, x_rest), (y, y_rest)) = (x.as_chunks::<16>(), y.as_chunks::<16>());
            for (x, y) in x.iter().zip(y) {
                for lane in 0..16 {
                    sums[lane] += x[lane] * y[lane];
                }
            }
            let mut sum = 0.0;
            for lane in sums {
                sum += lane;
            }
            for (x, y) in x_rest.iter().zip(y_rest) {
                sum += x * y;
            }
            sum
        },
    )
}

/// `y + a x`
fn add(y: &mut [f64], a: f64, x: &[f64]) {
    widest(
        #[inline(always)]
        || {
            for (y, x) in y.iter_mut().zip(x) {
                *y += a * x;
            }
        },
    );
}
