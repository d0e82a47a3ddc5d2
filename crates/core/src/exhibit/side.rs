//! The side of a point on which words stand.

use std::f64::consts::FRAC_1_SQRT_2;

use super::Point;

/// The side of a point on which words stand. A screen or a page takes it where that is free, else the nearest free one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Side {
    /// Right of it.
    #[default]
    Right,
    /// Above it at the right.
    UpperRight,
    /// Above it.
    Above,
    /// Above it at the left.
    UpperLeft,
    /// Left of it.
    Left,
    /// Below it at the left.
    LowerLeft,
    /// Below it.
    Below,
    /// Below it at the right.
    LowerRight,
    /// Centred on it: the letter of a body.
    Over,
}

impl Side {
    /// The eight sides around a point, counter-clockwise from the right.
    pub const AROUND: [Side; 8] = [
        Side::Right,
        Side::UpperRight,
        Side::Above,
        Side::UpperLeft,
        Side::Left,
        Side::LowerLeft,
        Side::Below,
        Side::LowerRight,
    ];

    /// The direction from the point to the words, of length 1; none for words over the point.
    pub fn direction(self) -> Point {
        let d = FRAC_1_SQRT_2;
        match self {
            Side::Right => (1.0, 0.0),
            Side::UpperRight => (d, d),
            Side::Above => (0.0, 1.0),
            Side::UpperLeft => (-d, d),
            Side::Left => (-1.0, 0.0),
            Side::LowerLeft => (-d, -d),
            Side::Below => (0.0, -1.0),
            Side::LowerRight => (d, -d),
            Side::Over => (0.0, 0.0),
        }
    }

    /// Eighths of a turn from one side to another, the shorter way; none from or to words over the point.
    pub fn turn_to(self, other: Side) -> usize {
        let place = |side| Side::AROUND.iter().position(|one| *one == side);
        match (place(self), place(other)) {
            (Some(from), Some(to)) => from.abs_diff(to).min(8 - from.abs_diff(to)),
            _ => 0,
        }
    }
}
