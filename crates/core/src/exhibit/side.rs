//! The side of a point on which words stand.

use std::f64::consts::FRAC_1_SQRT_2;

use super::Point;

/// The side of a point on which words stand. A screen or a page takes it where that is free, else the nearest free one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum LabelSide {
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

impl LabelSide {
    /// The eight sides around a point, counter-clockwise from the right.
    pub const AROUND: [LabelSide; 8] = [
        LabelSide::Right,
        LabelSide::UpperRight,
        LabelSide::Above,
        LabelSide::UpperLeft,
        LabelSide::Left,
        LabelSide::LowerLeft,
        LabelSide::Below,
        LabelSide::LowerRight,
    ];

    /// The direction from the point to the words, of length 1; none for words over the point.
    pub fn direction(self) -> Point {
        let d = FRAC_1_SQRT_2;
        match self {
            LabelSide::Right => (1.0, 0.0),
            LabelSide::UpperRight => (d, d),
            LabelSide::Above => (0.0, 1.0),
            LabelSide::UpperLeft => (-d, d),
            LabelSide::Left => (-1.0, 0.0),
            LabelSide::LowerLeft => (-d, -d),
            LabelSide::Below => (0.0, -1.0),
            LabelSide::LowerRight => (d, -d),
            LabelSide::Over => (0.0, 0.0),
        }
    }

    /// The side of the eight that is nearest to a direction; the right where there is none.
    pub fn towards((x, y): Point) -> Self {
        let along = |side: LabelSide| {
            let (across, up) = side.direction();
            x * across + y * up
        };
        Self::AROUND.into_iter().fold(
            LabelSide::Right,
            |best, side| {
                if along(side) > along(best) { side } else { best }
            },
        )
    }

    /// Eighths of a turn from one side to another, the shorter way; none from or to words over the point.
    pub fn turn_to(self, other: LabelSide) -> usize {
        let place = |side| LabelSide::AROUND.iter().position(|one| *one == side);
        match (place(self), place(other)) {
            (Some(from), Some(to)) => from.abs_diff(to).min(8 - from.abs_diff(to)),
            _ => 0,
        }
    }
}
