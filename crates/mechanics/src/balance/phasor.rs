//! Vibrations and weights that turn with the shaft, as vectors in a plane.

use crate::Real;

/// A vector that turns with the shaft, by its components: `x + i y`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phasor<S> {
    /// Component along the mark.
    pub x: S,
    /// Component a quarter turn ahead of the mark.
    pub y: S,
}

impl<S: Real> Phasor<S> {
    /// The vector of that size and angle: `A cos φ + i A sin φ`.
    #[inline(always)]
    pub fn polar(size: S, angle: S) -> Self {
        Self { x: size * angle.cos(), y: size * angle.sin() }
    }

    /// `a − b`
    #[inline(always)]
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }

    /// `a + b`
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }

    /// `a b`: sizes multiply, angles add.
    #[inline(always)]
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self { x: self.x * other.x - self.y * other.y, y: self.x * other.y + self.y * other.x }
    }

    /// `a/b`: sizes divide, angles subtract.
    #[inline(always)]
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        let square = other.x.powi(2) + other.y.powi(2);
        Self {
            x: (self.x * other.x + self.y * other.y) / square,
            y: (self.y * other.x - self.x * other.y) / square,
        }
    }

    /// `√(x² + y²)`
    #[inline(always)]
    pub fn size(self) -> S {
        (self.x.powi(2) + self.y.powi(2)).sqrt()
    }

    /// Phase angle, rad in `(−π, π]`.
    #[inline(always)]
    pub fn angle(self) -> S {
        self.y.atan2(self.x)
    }

    /// Angle as marked on a rotor, rad in `[0, 2π)`.
    #[inline(always)]
    pub fn marked_angle(self) -> S {
        super::marked_direction(self.x, self.y)
    }
}

/// The weights in two planes that take the readings of two sensors to zero, `α W = −V`, by Cramer's rule over
/// complex numbers; `alpha[sensor][plane]`. Goodman, *Trans. ASME J. Eng. Ind.* 86 (1964), for as many planes as
/// readings.
#[inline(always)]
pub fn two_plane_weights<S: Real>(alpha: [[Phasor<S>; 2]; 2], readings: [Phasor<S>; 2]) -> [Phasor<S>; 2] {
    let [[a11, a12], [a21, a22]] = alpha;
    let determinant = a11.times(a22).minus(a12.times(a21));
    let [v1, v2] = readings;
    [
        a12.times(v2).minus(a22.times(v1)).over(determinant),
        a21.times(v1).minus(a11.times(v2)).over(determinant),
    ]
}
