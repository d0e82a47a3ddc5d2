//! Natural and complex modes of `M ẍ + C ẋ + K x = f`.

use nalgebra::{Complex, DMatrix, DVector};

use dalembert_numerics::linalg::{self, LinalgError};

/// Reason for which a system has no modes.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ModesError {
    /// The matrices are not those of masses and springs.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
    /// The stiffness does work in some direction: the position of rest is unstable.
    #[error(
        "the stiffness matrix is indefinite: ω² = {square:e} rad²/s² is below zero, the rest is unstable"
    )]
    Unstable {
        /// The lowest ω².
        square: f64,
    },
}

/// The modes without damping.
#[derive(Debug, Clone, PartialEq)]
pub struct NaturalModes {
    /// ω², ascending; exactly zero for a rigid body mode.
    pub squares: Vec<f64>,
    /// The mode shapes, a column each, with `φᵀ M φ = 1`.
    pub shapes: DMatrix<f64>,
}

/// A root of `det(λ² M + λ C + K)` and its shape; an oscillation stands for its conjugate too.
#[derive(Debug, Clone, PartialEq)]
pub struct ComplexMode {
    /// λ, with a positive imaginary part for an oscillation.
    pub root: Complex<f64>,
    /// The shape, of unit length.
    pub shape: DVector<Complex<f64>>,
}

/// The modes of `K φ = ω² M φ`, with mass and stiffness n by n.
///
/// # Errors
/// `Linalg` for matrices that are not symmetric or a mass matrix that is not positive definite; `Unstable`.
pub fn natural_modes(m: &DMatrix<f64>, k: &DMatrix<f64>) -> Result<NaturalModes, ModesError> {
    let eigen = linalg::generalised_eigen(k, m)?;
    let mut squares: Vec<f64> = eigen.values.iter().copied().collect();
    let largest = squares.iter().fold(0.0, |largest: f64, square| largest.max(square.abs()));
    for square in &mut squares {
        if *square < -1e-12 * largest {
            return Err(ModesError::Unstable { square: *square });
        }
        *square = square.max(0.0);
    }
    let mut modes = NaturalModes { squares, shapes: eigen.vectors };
    modes.settle_repeated(m);
    Ok(modes)
}

impl NaturalModes {
    /// Modes of the same frequency may be mixed at will; those are taken that carry most of the first coordinate,
    /// then of the next one, so that the same system always has the same modes.
    fn settle_repeated(&mut self, m: &DMatrix<f64>) {
        let mut from = 0;
        while from < self.squares.len() {
            let same = |square: &&f64| (**square - self.squares[from]).abs() <= 1e-10 * self.squares[from];
            let count = self.squares[from..].iter().take_while(same).count();
            if count > 1 {
                self.settle(m, from, count);
            }
            from += count;
        }
    }

    fn settle(&mut self, m: &DMatrix<f64>, from: usize, count: usize) {
        let group = self.shapes.columns(from, count).into_owned();
        // The share of the group in a unit displacement of each coordinate.
        let shares = group.transpose() * m;
        let largest = shares.column_iter().map(|share| share.norm()).fold(0.0, f64::max);
        let mut chosen: Vec<DVector<f64>> = Vec::new();
        for share in shares.column_iter() {
            let mut left = share.into_owned();
            for _ in 0..2 {
                for other in &chosen {
                    left -= other * other.dot(&left);
                }
            }
            let size = left.norm();
            if chosen.len() < count && size > 1e-3 * largest {
                chosen.push(left / size);
            }
        }
        if chosen.len() == count {
            self.shapes.columns_mut(from, count).copy_from(&(group * DMatrix::from_columns(&chosen)));
        }
    }

    /// `Φᵀ C Φ`: diagonal where the damping leaves the modes alone.
    pub fn damping(&self, c: &DMatrix<f64>) -> DMatrix<f64> {
        self.shapes.transpose() * c * &self.shapes
    }

    /// `Φᵀ M r`: the shares of the modes in a motion r of all masses.
    pub fn participation(&self, m: &DMatrix<f64>, r: &DVector<f64>) -> DVector<f64> {
        self.shapes.transpose() * (m * r)
    }
}

/// Returns true if a modal damping matrix `Φᵀ C Φ` is diagonal to rounding: proportional damping.
pub fn is_proportional(modal_damping: &DMatrix<f64>) -> bool {
    let limit = 1e-9 * modal_damping.diagonal().amax();
    (0..modal_damping.ncols()).all(|column| {
        (0..column)
            .all(|row| modal_damping[(row, column)].abs().max(modal_damping[(column, row)].abs()) <= limit)
    })
}

/// The damped modes of `M ẍ + C ẋ + K x = 0`, ascending by |λ|, with C n by n in the coordinates of M and K.
///
/// The state (q, q̇/ω) in the modes without damping has the matrix `[0, ω; −Ω²/ω, −ΦᵀCΦ]`, symmetric M and K given.
///
/// # Errors
/// As for [`natural_modes`]; `NotConverged`.
pub fn complex_modes(modes: &NaturalModes, c: &DMatrix<f64>) -> Result<Vec<ComplexMode>, ModesError> {
    let n = modes.squares.len();
    let damping = modes.damping(c);
    let unit = modes.squares.last().copied().unwrap_or(0.0).sqrt().max(damping.amax());
    let unit = if unit > 0.0 { unit } else { 1.0 };
    let state = DMatrix::from_fn(2 * n, 2 * n, |row, column| match (row < n, column < n) {
        (true, true) => 0.0,
        (true, false) => {
            if row == column - n {
                unit
            } else {
                0.0
            }
        }
        (false, true) => {
            if row - n == column {
                -modes.squares[column] / unit
            } else {
                0.0
            }
        }
        (false, false) => -damping[(row - n, column - n)],
    });
    let eigen = linalg::complex_eigen(&state)?;
    let mut found: Vec<ComplexMode> = eigen
        .values
        .iter()
        .enumerate()
        .filter(|(_, root)| root.im >= 0.0)
        .map(|(at, root)| {
            let modal = eigen.vectors.column(at).rows(0, n).into_owned();
            let mut shape = DVector::from_fn(n, |row, _| {
                modes.shapes.row(row).iter().zip(modal.iter()).map(|(phi, q)| q * *phi).sum::<Complex<f64>>()
            });
            let length = shape.norm();
            if length > 0.0 {
                shape.iter_mut().for_each(|entry| *entry /= length);
            }
            ComplexMode { root: *root, shape }
        })
        .collect();
    found.sort_by(|p, q| p.root.norm().total_cmp(&q.root.norm()).then(p.root.re.total_cmp(&q.root.re)));
    Ok(found)
}

impl ComplexMode {
    /// `|λ|`: the natural frequency of an oscillation.
    pub fn natural(&self) -> f64 {
        self.root.norm()
    }
}
