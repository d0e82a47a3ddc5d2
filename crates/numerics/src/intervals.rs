//! Sets of real numbers made of intervals: the diameters that are permitted, the speeds that are not.
//!
//! ```
//! use std::ops::Bound::{Excluded, Included, Unbounded};
//!
//! use dalembert_numerics::intervals::IntervalSet;
//!
//! // Speeds from 0 on but for those between 90 and 110 rad/s, and the same of a rotor whose shaft turns twice as fast.
//! let resonance = IntervalSet::interval(Excluded(90.0), Excluded(110.0));
//! let permitted = IntervalSet::interval(Included(0.0), Unbounded).intersection(&resonance.complement());
//! assert!(permitted.contains(90.0) && !permitted.contains(100.0));
//! let twice: Vec<_> = permitted.map_ascending(|speed| 2.0 * speed).intervals().collect();
//! assert_eq!((twice[0].lower, twice[0].upper), (Included(0.0), Included(180.0)));
//! assert_eq!((twice[1].lower, twice[1].upper), (Included(220.0), Unbounded));
//! ```

use std::ops::Bound::{self, Excluded, Included, Unbounded};

/// A set of real numbers: a finite union of intervals, each end open, closed or unbounded.
///
/// Kept in normal form, so that equal sets compare equal: intervals ascending, none empty, none touching another.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct IntervalSet {
    /// Boundaries in ascending order: those at even indices open an interval, those at odd indices close it.
    cuts: Vec<Cut>,
}

/// An interval that is not empty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub lower: Bound<f64>,
    /// Upper end.
    pub upper: Bound<f64>,
}

/// A place between two neighbouring numbers: just below or just above one.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
struct Cut {
    at: f64,
    side: Side,
}

#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
enum Side {
    Below,
    Above,
}

impl IntervalSet {
    /// The empty set.
    pub fn none() -> Self {
        Self::default()
    }

    /// All real numbers.
    pub fn all() -> Self {
        Self::interval(Unbounded, Unbounded)
    }

    /// The numbers between two ends; empty when the ends cross. An infinite end counts as unbounded.
    ///
    /// # Panics
    /// If an end is NaN.
    pub fn interval(lower: Bound<f64>, upper: Bound<f64>) -> Self {
        let lower = match lower {
            Included(x) => Cut::new(x, Side::Below),
            Excluded(x) => Cut::new(x, Side::Above),
            Unbounded => Cut::new(f64::NEG_INFINITY, Side::Below),
        };
        let upper = match upper {
            Included(x) => Cut::new(x, Side::Above),
            Excluded(x) => Cut::new(x, Side::Below),
            Unbounded => Cut::new(f64::INFINITY, Side::Above),
        };
        if lower < upper { Self { cuts: vec![lower, upper] } } else { Self::none() }
    }

    /// The intervals, ascending.
    pub fn intervals(&self) -> impl ExactSizeIterator<Item = Interval> {
        self.cuts.chunks_exact(2).map(|ends| Interval {
            lower: match ends[0] {
                Cut { at: f64::NEG_INFINITY, .. } => Unbounded,
                Cut { at, side: Side::Below } => Included(at),
                Cut { at, side: Side::Above } => Excluded(at),
            },
            upper: match ends[1] {
                Cut { at: f64::INFINITY, .. } => Unbounded,
                Cut { at, side: Side::Above } => Included(at),
                Cut { at, side: Side::Below } => Excluded(at),
            },
        })
    }

    /// Returns true if the set is empty.
    pub fn is_none(&self) -> bool {
        self.cuts.is_empty()
    }

    /// Returns true if the set holds every real number.
    pub fn is_all(&self) -> bool {
        *self == Self::all()
    }

    /// Returns true if `x` is in the set.
    pub fn contains(&self, x: f64) -> bool {
        x.is_finite() && self.cuts.iter().filter(|&&cut| cut < Cut::new(x, Side::Above)).count() % 2 == 1
    }

    /// Numbers in this set, in the other, or in both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let mut changes: Vec<(Cut, i8)> = [self, other]
            .into_iter()
            .flat_map(|set| set.cuts.iter().zip([1, -1].into_iter().cycle()))
            .map(|(&cut, change)| (cut, change))
            .collect();
        // Ins before outs at the same cut: sets that touch there become one.
        changes.sort_by(|(p, p_change), (q, q_change)| {
            p.at.total_cmp(&q.at).then((p.side as u8).cmp(&(q.side as u8))).then(q_change.cmp(p_change))
        });
        let mut depth = 0;
        let mut cuts = Vec::new();
        for (cut, change) in changes {
            if depth == 0 || depth + change == 0 {
                cuts.push(cut);
            }
            depth += change;
        }
        Self { cuts }
    }

    /// Numbers that are not in this set.
    #[must_use]
    pub fn complement(&self) -> Self {
        let ends = Self::all().cuts;
        let mut cuts = self.cuts.clone();
        if cuts.first() == ends.first() {
            cuts.remove(0);
        } else {
            cuts.insert(0, ends[0]);
        }
        if cuts.last() == ends.last() {
            cuts.pop();
        } else {
            cuts.push(ends[1]);
        }
        Self { cuts }
    }

    /// Numbers in both sets.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        self.complement().union(&other.complement()).complement()
    }

    /// The set of `f(x)` for every `x` in the set, for a strictly ascending continuous `f`: stiffnesses into
    /// diameters. Unbounded ends stay unbounded.
    ///
    /// # Panics
    /// If `f` is NaN at an end of an interval.
    #[must_use]
    pub fn map_ascending(&self, f: impl Fn(f64) -> f64) -> Self {
        let map = |bound: Bound<f64>| bound.map(&f);
        self.intervals()
            .map(|interval| Self::interval(map(interval.lower), map(interval.upper)))
            .fold(Self::none(), |set, part| set.union(&part))
    }
}

impl Cut {
    fn new(at: f64, side: Side) -> Self {
        assert!(!at.is_nan(), "an end of an interval is a number");
        match at {
            f64::NEG_INFINITY => Self { at, side: Side::Below },
            f64::INFINITY => Self { at, side: Side::Above },
            // One zero: −0 and +0 are the same number.
            _ => Self { at: at + 0.0, side },
        }
    }
}
