//! The search for the roots of a beam: the number below a trial one is bisected, and its shape ends it.

use super::{BeamError, SEGMENTS};

/// Functions of a beam that the search for eigenvalues evaluates.
pub struct Search<Count, Quotient> {
    /// Number of `λ` below a value, the beam being divided into segments of at most a given angle.
    pub count: Count,
    /// Rayleigh's quotient of the shape at a trial `β`.
    pub quotient: Quotient,
    /// Width over place from which on a root that is alone between its bounds is found from its shape.
    pub alone: f64,
}

impl<Count, Quotient> Search<Count, Quotient>
where
    Count: Fn(f64, f64) -> Result<usize, BeamError>,
    Quotient: Fn(f64) -> Result<f64, BeamError>,
{
    /// The first `count` roots `β_n` above the motions as a whole, ascending.
    ///
    /// # Errors
    /// Those of the functions; `NotConverged`.
    pub fn roots(&self, rigid: usize, count: usize) -> Result<Vec<f64>, BeamError> {
        let mut roots: Vec<f64> = Vec::with_capacity(count);
        for n in 1..=count {
            let lower = roots.last().map_or(0.0, |root| root * (1.0 - 1e-12));
            let root = SEGMENTS.iter().find_map(|angle| self.root(rigid + n, lower, *angle).ok());
            roots.push(root.map_or_else(|| self.root(rigid + n, lower, SEGMENTS[0]), Ok)?);
        }
        Ok(roots)
    }

    /// The lowest β with `wanted` frequencies below it.
    fn root(&self, wanted: usize, lower: f64, angle: f64) -> Result<f64, BeamError> {
        let count = |beta: f64| (self.count)(beta.powi(4), angle);
        let (mut low, mut below) = (lower, 0);
        let mut high = lower + 4.0;
        let mut above = count(high)?;
        while above < wanted {
            (low, below) = (high, above);
            high *= 1.5;
            above = count(high)?;
        }
        for _ in 0..400 {
            let width = high - low;
            // Alone between the bounds, a root is found from its shape.
            if width <= self.alone * high
                && above == wanted
                && below + 1 == wanted
                && let Some(root) = self.polished([low, high])
            {
                return Ok(root);
            }
            if width <= 1e-9 * high {
                return self.polished([low, high]).ok_or(BeamError::NotConverged);
            }
            // A root far below one is found by its order of size first.
            let middle = if low == 0.0 { high / 8.0 } else { 0.5 * (low + high) };
            if middle < 1e-60 {
                return Err(BeamError::NotConverged);
            }
            let found = count(middle)?;
            if found < wanted {
                (low, below) = (middle, found);
            } else {
                (high, above) = (middle, found);
            }
        }
        Err(BeamError::NotConverged)
    }

    /// The root between two bounds from its shape: the error of Rayleigh's quotient is the square of that of the
    /// shape, and each round is of the next one's.
    fn polished(&self, [low, high]: [f64; 2]) -> Option<f64> {
        let slack = 1e-6 * high;
        let mut root = 0.5 * (low + high);
        for _ in 0..6 {
            let next = (self.quotient)(root).ok()?.sqrt().sqrt();
            if !(low - slack..=high + slack).contains(&next) {
                return None;
            }
            let step = (next - root).abs();
            root = next;
            // Beyond this, the next round changes nothing any more.
            if step <= 1e-8 * root {
                return Some(root);
            }
        }
        None
    }
}
