//! Seismic instruments: where in frequency their reading is right to within an allowed error.
//!
//! The relative motion of the seismic mass is `Z = Y r²/√((1 − r²)² + (2ζr)²)` of a displacement `Y` and
//! `ω_n² Z = A/√((1 − r²)² + (2ζr)²)` of an acceleration `A`, with `r = ω/ω_n` (Rao, *Mechanical Vibrations*,
//! 5th ed., §10.3).

use std::ops::Bound::{Excluded, Included, Unbounded};

use dalembert_numerics::intervals::IntervalSet;

/// Quantity that the instrument measures: displacement or acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reads {
    /// Displacement: right far above its natural frequency.
    Displacement,
    /// Acceleration: right far below its natural frequency.
    Acceleration,
}

/// The frequency ratios `r ≥ 0` at which the reading is within `error` (a share, `0 < error < 1`) of the truth:
/// the union of one or more intervals, exactly.
///
/// The accelerometer is right where `1/(1 + e)² ≤ (1 − u)² + 4ζ²u ≤ 1/(1 − e)²` with `u = r²`, two quadratic
/// inequalities; the vibrometer where the same holds of `u = 1/r²`. Empty for numbers that are not finite.
pub fn usable_ratios(reads: Reads, damping_ratio: f64, error: f64) -> IntervalSet {
    let b = 1.0 - 2.0 * damping_ratio * damping_ratio;
    // u² − 2bu + 1 lies below `level` between these squares of r.
    let between = |level: f64| {
        let root = (b * b + (level - 1.0)).max(0.0).sqrt();
        let real = b * b + (level - 1.0) >= 0.0;
        // The product of the roots is 1 − level: the smaller one without a difference.
        let (small, large) = if b >= 0.0 {
            let large = b + root;
            (if large > 0.0 { (1.0 - level) / large } else { 0.0 }, large)
        } else {
            let small = b - root;
            (small, (1.0 - level) / small)
        };
        real.then_some((small, large))
    };
    // 1/(1 ± e)² − 1 written so that a small error keeps its digits.
    let upper = 1.0 + error * (2.0 - error) / ((1.0 - error) * (1.0 - error));
    let lower = 1.0 - error * (2.0 + error) / ((1.0 + error) * (1.0 + error));
    let finite = b.is_finite() && upper.is_finite() && lower.is_finite();
    let Some((from, to)) = between(upper).filter(|ends| finite && ends.0.is_finite() && ends.1.is_finite())
    else {
        return IntervalSet::none();
    };
    let inside = IntervalSet::interval(Included(from.max(0.0)), Included(to));
    let resonant = match between(lower) {
        Some((from, to)) if from < to && from.is_finite() && to.is_finite() => {
            IntervalSet::interval(Excluded(from), Excluded(to))
        }
        _ => IntervalSet::none(),
    };
    let squares = inside.intersection(&resonant.complement());
    match reads {
        Reads::Acceleration => squares.map_ascending(f64::sqrt),
        Reads::Displacement => {
            let turned = squares.intervals().map(|interval| {
                let turn = |bound| match bound {
                    Included(u) if u > 0.0 => Included(1.0 / f64::sqrt(u)),
                    Excluded(u) if u > 0.0 => Excluded(1.0 / f64::sqrt(u)),
                    _ => Unbounded,
                };
                IntervalSet::interval(turn(interval.upper), turn(interval.lower))
            });
            turned.fold(IntervalSet::none(), |set, part| set.union(&part))
        }
    }
}
