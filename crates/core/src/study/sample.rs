//! Samples of the points of a study, by a hash of their numbers: the same whatever threads or machines solve them.

use std::collections::BinaryHeap;

use dalembert_numerics::random::uniform_bits;

/// Points that are kept.
const KEPT: usize = 400;
/// Seed of the choice, which is none of the points themselves.
const SEED: u64 = 0x5ca7_7e12;

/// Random number of a point, by which it belongs to a sample or not.
#[inline(always)]
pub(super) fn hash(point: u64) -> u64 {
    uniform_bits(SEED, point, 0)
}

/// The largest hash of about so many of all points.
pub(super) fn largest_hash(count: u64, points: u64) -> u64 {
    if points <= count { u64::MAX } else { (count as f64 / points as f64 * u64::MAX as f64) as u64 }
}

/// Simple random sample of rows: those whose numbers have the least hashes, whatever the number of rows.
#[derive(Clone, Debug, Default)]
pub(super) struct RowSample {
    /// Hash of each row that is kept, and its place, the largest on top.
    kept: BinaryHeap<(u64, usize)>,
    rows: Vec<Vec<f64>>,
}

impl RowSample {
    /// The largest hash of a row that is kept; only rows of smaller ones are taken.
    pub(super) fn largest_hash(&self) -> u64 {
        if self.kept.len() < KEPT { u64::MAX } else { self.kept.peek().map_or(u64::MAX, |(hash, _)| *hash) }
    }

    /// Takes the row of a point with a hash that is less than the largest one.
    pub(super) fn take(&mut self, hash: u64, row: impl Iterator<Item = f64>) {
        if self.kept.len() < KEPT {
            self.kept.push((hash, self.rows.len()));
            self.rows.push(row.collect());
        } else if let Some(mut largest) = self.kept.peek_mut() {
            let place = &mut self.rows[largest.1];
            place.clear();
            place.extend(row);
            largest.0 = hash;
        }
    }

    /// The rows that were kept.
    pub(super) fn rows(self) -> Vec<Vec<f64>> {
        self.rows
    }
}
