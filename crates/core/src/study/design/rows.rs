//! The inputs of successive points, a column after the other: in the grid, and drawn from distributions.

use std::ops::Range;

use dalembert_numerics::{
    distribution::{normal_cumulative, normal_quantiles},
    random::{uniform, uniforms},
    sampling::{latin_hypercube, sobol},
};
use nalgebra::DVector;

use super::Design;
use crate::study::{grid::GridAxis, indices::INDEPENDENT, plan::Sampling};

impl Design {
    /// Writes the inputs of successive points, the first of them counted from 0, in their units and in SI: a point a row.
    pub fn rows(&self, first: u64, shown: &mut [f64], si: &mut [f64]) {
        let width = self.inputs.len().max(1);
        if !self.grid.is_empty() {
            let rows = shown.chunks_exact_mut(width).zip(si.chunks_exact_mut(width));
            for ((shown, si), point) in rows.zip(first..) {
                self.write_grid(point / self.points_of_sample / self.samples, shown, si);
            }
        }
        let points = (shown.len() / width) as u64;
        let mut shares: Vec<Vec<f64>> =
            (0..self.drawn.len()).map(|at| self.shares(first..first + points, at)).collect();
        if let Some(root) = &self.correlation {
            // Correlation is that of the normal scores.
            for scores in &mut shares {
                normal_quantiles(scores);
            }
            for row in 0..points as usize {
                let independent = shares.iter().map(|scores| scores[row]);
                let scores = root * DVector::from_iterator(self.drawn.len(), independent);
                for (shares, score) in shares.iter_mut().zip(&scores) {
                    shares[row] = normal_cumulative(*score);
                }
            }
        }
        for (drawn, mut values) in self.drawn.iter().zip(shares) {
            drawn.distribution.quantiles(&mut values);
            let unit = &self.inputs[drawn.input].unit;
            let rows = shown.chunks_exact_mut(width).zip(si.chunks_exact_mut(width));
            for ((shown, si), value) in rows.zip(values) {
                (shown[drawn.input], si[drawn.input]) = (value, unit.si(value));
            }
        }
    }

    /// Writes the inputs of a place in the grid.
    fn write_grid(&self, mut place: u64, shown: &mut [f64], si: &mut [f64]) {
        for axis in self.grid.iter().rev() {
            let at = place % axis.len();
            place /= axis.len();
            match axis {
                GridAxis::Range(range) => {
                    shown[range.input] = range.value(at);
                    si[range.input] = self.inputs[range.input].unit.si(shown[range.input]);
                }
                GridAxis::Rows { inputs, rows } => {
                    for (input, [own, in_si]) in inputs.iter().zip(&rows[at as usize]) {
                        (shown[*input], si[*input]) = (*own, *in_si);
                    }
                }
            }
        }
    }

    /// The shares of successive points for the drawn input of that place.
    fn shares(&self, points: Range<u64>, at: usize) -> Vec<f64> {
        let is_plain = self.grid.is_empty() && self.points_of_sample == 1;
        if self.sampling == Sampling::MonteCarlo && is_plain {
            let mut shares = vec![0.0; (points.end - points.start) as usize];
            uniforms(self.seed, points.start, at as u64, &mut shares);
            return shares;
        }
        let share = |point: u64| {
            let (sample, of_sample) =
                (point / self.points_of_sample % self.samples, point % self.points_of_sample);
            // Of a base sample, the first point takes one half of the dimensions, the second one the other, and each
            // further one the first half with one input of the other.
            let is_other = of_sample == 1 || of_sample == (INDEPENDENT + at) as u64;
            let dimension = at + if is_other { self.drawn.len() } else { 0 };
            match self.sampling {
                Sampling::MonteCarlo => uniform(self.seed, sample, dimension as u64),
                Sampling::LatinHypercube => {
                    latin_hypercube(self.seed, self.samples, sample, dimension as u64)
                }
                Sampling::Sobol => sobol(self.seed, sample, dimension),
            }
        };
        points.map(share).collect()
    }
}
