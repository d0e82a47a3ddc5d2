//! Field balancing by influence coefficients: any number of planes and readings.
//!
//! A reading is a complex amplitude: of a sensor at a speed. Without weights they are `V`; weights `W` in the
//! planes make them `V + α W`. The influence coefficients `α` come from runs with trial weights.

use nalgebra::{Complex, DMatrix, DVector};

use dalembert_numerics::linalg::{self, LinalgError};

/// A run with a trial weight.
#[derive(Debug, Clone, PartialEq)]
pub struct TrialRun {
    /// The plane of the weight, counted from 0.
    pub plane: usize,
    /// The weight that was added before this run.
    pub weight: Complex<f64>,
    /// Readings of the sensors in this run, one per sensor.
    pub readings: Vec<Complex<f64>>,
}

/// Weights, and what they leave.
#[derive(Debug, Clone, PartialEq)]
pub struct Weights {
    /// The weight of each plane.
    pub weights: Vec<Complex<f64>>,
    /// Predicted readings of the sensors with the correction weights, one per sensor.
    pub residuals: Vec<Complex<f64>>,
    /// Condition number of the coefficients, their columns scaled.
    pub condition: f64,
}

/// Reason for which no correction weights are found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum InfluenceError {
    /// A plane in which no run has a weight.
    #[error("no run has a trial weight in plane {plane}; make one, or count the planes without gaps")]
    NoTrial {
        /// The plane, counted from 1.
        plane: usize,
    },
    /// Fewer readings than planes.
    #[error(
        "{readings} readings cannot determine the weights of {planes} planes; read more sensors or speeds"
    )]
    TooFewReadings {
        /// Number of readings.
        readings: usize,
        /// Number of correction planes.
        planes: usize,
    },
    /// A system of equations without an answer.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}

/// Influence coefficients from trial runs, a row for each reading and a column for each plane. `first` are the readings
/// without weights, in the order of the sensors in every run.
///
/// Each run is held against the first one, or where weights stay on, against the run before it. Several runs in a
/// plane are averaged by least squares: `α = Σ W̄ ΔV / Σ |W|²`.
///
/// # Errors
/// `NoTrial`.
pub fn influence_coefficients(
    first: &[Complex<f64>],
    runs: &[TrialRun],
    weights_stay: bool,
) -> Result<DMatrix<Complex<f64>>, InfluenceError> {
    let planes = runs.iter().map(|run| run.plane + 1).max().unwrap_or(0).max(1);
    let mut alpha = DMatrix::zeros(first.len(), planes);
    let mut squares = vec![0.0; planes];
    let mut before = first;
    for run in runs {
        for ((row, reading), before) in run.readings.iter().enumerate().zip(before) {
            alpha[(row, run.plane)] += run.weight.conj() * (reading - before);
        }
        squares[run.plane] += run.weight.norm_sqr();
        if weights_stay {
            before = &run.readings;
        }
    }
    for (plane, square) in squares.into_iter().enumerate() {
        if square == 0.0 {
            return Err(InfluenceError::NoTrial { plane: plane + 1 });
        }
        alpha.column_mut(plane).iter_mut().for_each(|entry| *entry /= square);
    }
    Ok(alpha)
}

/// The weights that make `Σ gᵢ |Vᵢ + (α W)ᵢ|²` least. Goodman (1964).
///
/// Coefficients have a row for each reading and a column for each plane; `importance` holds `gᵢ` for each reading, 1 for
/// those beyond its end.
///
/// # Errors
/// `TooFewReadings`; `Linalg`, above all `Singular` when planes act alike.
pub fn least_squares(
    alpha: &DMatrix<Complex<f64>>,
    readings: &[Complex<f64>],
    importance: &[f64],
) -> Result<Weights, InfluenceError> {
    let (rows, planes) = alpha.shape();
    if rows < planes {
        return Err(InfluenceError::TooFewReadings { readings: rows, planes });
    }
    let root = |row: usize| importance.get(row).map_or(1.0, |g| g.sqrt());
    let matrix = DMatrix::from_fn(2 * rows, 2 * planes, |row, column| {
        let entry = alpha[(row / 2, column / 2)];
        root(row / 2)
            * match (row % 2, column % 2) {
                (0, 0) | (1, 1) => entry.re,
                (0, _) => -entry.im,
                _ => entry.im,
            }
    });
    let right = DVector::from_fn(2 * rows, |row, _| {
        let reading = readings[row / 2];
        -root(row / 2) * if row % 2 == 0 { reading.re } else { reading.im }
    });
    let solved = linalg::least_squares(&matrix, &right)?;
    let weights: Vec<Complex<f64>> =
        (0..planes).map(|plane| Complex::new(solved.x[2 * plane], solved.x[2 * plane + 1])).collect();
    let residuals = residuals(alpha, readings, &weights);
    Ok(Weights { weights, residuals, condition: solved.condition })
}

/// Residual readings with those weights, `V + α W`, one per sensor.
pub fn residuals(
    alpha: &DMatrix<Complex<f64>>,
    readings: &[Complex<f64>],
    weights: &[Complex<f64>],
) -> Vec<Complex<f64>> {
    let with = |(row, reading): (usize, &Complex<f64>)| {
        reading + weights.iter().enumerate().map(|(plane, w)| alpha[(row, plane)] * w).sum::<Complex<f64>>()
    };
    readings.iter().enumerate().map(with).collect()
}

/// The cosine of the angle between the effects of two planes: 1 where one plane can do nothing that the other
/// cannot.
pub fn collinearity(alpha: &DMatrix<Complex<f64>>, one: usize, other: usize) -> f64 {
    let (a, b) = (alpha.column(one), alpha.column(other));
    // Scaled, so that no square leaves the range of numbers.
    let size = |column: &dyn Fn(usize) -> Complex<f64>| {
        (0..a.nrows()).map(|row| column(row).norm()).fold(0.0, f64::max)
    };
    let (p, q) = (size(&|row| a[row]), size(&|row| b[row]));
    if p == 0.0 || q == 0.0 {
        return 1.0;
    }
    let product: Complex<f64> = a.iter().zip(b.iter()).map(|(a, b)| (a / p).conj() * (b / q)).sum();
    let square = |column: nalgebra::DVectorView<'_, Complex<f64>>, by: f64| {
        column.iter().map(|entry| (entry / by).norm_sqr()).sum::<f64>()
    };
    product.norm() / (square(a, p) * square(b, q)).sqrt()
}
