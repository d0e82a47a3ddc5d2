//! The matrices of a chain of nodes in one plane: symmetric, two degrees of freedom a node, coupled only to neighbours.

use std::ops::{AddAssign, Mul};

use nalgebra::{DVector, Matrix2, Matrix4, Vector2};

/// A symmetric block-tridiagonal matrix of 2 by 2 blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// Blocks on the diagonal, one a node.
    pub diagonal: Vec<Matrix2<f64>>,
    /// Blocks above the diagonal: from each node to the next.
    pub above: Vec<Matrix2<f64>>,
}

/// A factorised positive definite matrix of that kind.
#[derive(Debug, Clone)]
pub(super) struct PlaneFactors {
    /// Inverses of the pivots.
    pivots: Vec<Matrix2<f64>>,
    above: Vec<Matrix2<f64>>,
}

impl Plane {
    /// Zeros for so many nodes.
    pub fn zeros(nodes: usize) -> Self {
        Self { diagonal: vec![Matrix2::zeros(); nodes], above: vec![Matrix2::zeros(); nodes - 1] }
    }

    /// Adds an element between node `n` and the next, times a factor.
    pub(super) fn add(&mut self, n: usize, element: &Matrix4<f64>, factor: f64) {
        self.diagonal[n] += element.fixed_view::<2, 2>(0, 0) * factor;
        self.diagonal[n + 1] += element.fixed_view::<2, 2>(2, 2) * factor;
        self.above[n] += element.fixed_view::<2, 2>(0, 2) * factor;
    }

    /// `self + factor × other`.
    pub(super) fn plus(&self, other: &Plane, factor: f64) -> Plane {
        let sum =
            |a: &[Matrix2<f64>], b: &[Matrix2<f64>]| a.iter().zip(b).map(|(a, b)| a + b * factor).collect();
        Plane { diagonal: sum(&self.diagonal, &other.diagonal), above: sum(&self.above, &other.above) }
    }

    /// The matrix times a vector `(x₁, φ₁, x₂, φ₂, …)`.
    pub fn times(&self, x: &DVector<f64>) -> DVector<f64> {
        let mut y = DVector::zeros(x.len());
        let at = |x: &DVector<f64>, n: usize| Vector2::new(x[2 * n], x[2 * n + 1]);
        for (n, block) in self.diagonal.iter().enumerate() {
            let mut sum = block * at(x, n);
            if n > 0 {
                sum += self.above[n - 1].tr_mul(&at(x, n - 1));
            }
            if let Some(above) = self.above.get(n) {
                sum += above * at(x, n + 1);
            }
            y[2 * n] = sum[0];
            y[2 * n + 1] = sum[1];
        }
        y
    }

    /// The matrix times real or complex numbers, one for each freedom.
    pub(super) fn product<T: Copy + AddAssign + Mul<f64, Output = T>>(&self, x: &[T], zero: T) -> Vec<T> {
        let mut y = vec![zero; x.len()];
        for (n, block) in self.diagonal.iter().enumerate() {
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                y[2 * n + i] += x[2 * n + j] * block[(i, j)];
                if let Some(above) = self.above.get(n) {
                    y[2 * n + i] += x[2 * n + 2 + j] * above[(i, j)];
                    y[2 * n + 2 + j] += x[2 * n + i] * above[(i, j)];
                }
            }
        }
        y
    }

    /// `xᵀ A x`.
    pub fn energy(&self, x: &[f64]) -> f64 {
        let x = DVector::from_column_slice(x);
        x.dot(&self.times(&x))
    }

    /// Removes a freedom: its row and column are zero but for `diagonal`.
    pub(super) fn fix(&mut self, freedom: usize, diagonal: f64) {
        let (n, k) = (freedom / 2, freedom % 2);
        for j in 0..2 {
            self.diagonal[n][(k, j)] = 0.0;
            self.diagonal[n][(j, k)] = 0.0;
            if let Some(above) = self.above.get_mut(n) {
                above[(k, j)] = 0.0;
            }
            if n > 0 {
                self.above[n - 1][(j, k)] = 0.0;
            }
        }
        self.diagonal[n][(k, k)] = diagonal;
    }

    /// Factors of a positive definite matrix; `None` where a pivot is not above this share of its diagonal entry.
    ///
    /// A share is free of units: deflections and slopes stand side by side, and scaling either changes nothing.
    pub(super) fn factors(&self, least: f64) -> Option<PlaneFactors> {
        let mut pivots: Vec<Matrix2<f64>> = Vec::with_capacity(self.diagonal.len());
        for (n, block) in self.diagonal.iter().enumerate() {
            let mut pivot = *block;
            if n > 0 {
                let above = &self.above[n - 1];
                pivot -= above.transpose() * pivots[n - 1] * above;
            }
            let (a, b) = (pivot[(0, 0)], 0.5 * (pivot[(0, 1)] + pivot[(1, 0)]));
            let rest = pivot[(1, 1)] - b * (b / a);
            if !(a > least * block[(0, 0)] && rest > least * block[(1, 1)]) {
                return None;
            }
            let (slant, second) = (b / a, 1.0 / rest);
            let cross = -slant * second;
            pivots.push(Matrix2::new(1.0 / a - slant * cross, cross, cross, second));
        }
        Some(PlaneFactors { pivots, above: self.above.clone() })
    }
}

impl PlaneFactors {
    /// The number of degrees of freedom.
    pub(super) fn size(&self) -> usize {
        2 * self.pivots.len()
    }

    /// The solution of `A x = b`.
    pub(super) fn solve(&self, b: &DVector<f64>) -> DVector<f64> {
        let mut x = b.clone();
        let at = |x: &DVector<f64>, n: usize| Vector2::new(x[2 * n], x[2 * n + 1]);
        let put = |x: &mut DVector<f64>, n: usize, value: Vector2<f64>| {
            x[2 * n] = value[0];
            x[2 * n + 1] = value[1];
        };
        for n in 1..self.pivots.len() {
            let carried = self.above[n - 1].tr_mul(&(self.pivots[n - 1] * at(&x, n - 1)));
            let value = at(&x, n) - carried;
            put(&mut x, n, value);
        }
        for n in (0..self.pivots.len()).rev() {
            let mut value = at(&x, n);
            if let Some(above) = self.above.get(n) {
                value -= above * at(&x, n + 1);
            }
            put(&mut x, n, self.pivots[n] * value);
        }
        x
    }
}
