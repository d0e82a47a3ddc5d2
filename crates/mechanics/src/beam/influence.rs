//! Deflections of uniform slender beams at a place, under a force of one at another place (influence coefficients,
//! m/N) or under their own weight `w` in N/m. Bending stiffness `EI` in N·m², lengths in m from the left end.
//!
//! Beer & Johnston, *Mechanics of Materials*, and Shigley, *Mechanical Engineering Design*, table A-9.

use crate::Real;

/// Simply supported over a span `L`, place `x` not beyond the load at `a`:
/// `(L − a) x (L² − (L − a)² − x²)/(6EIL)`.
#[inline]
pub fn simply_supported<S: Real>(bending: S, span: S, place: S, load: S) -> S {
    let rest = span - load;
    rest * place * (span.powi(2) - rest.powi(2) - place.powi(2)) / (bending * span * 6.0)
}

/// Clamped at the left end, place `x` not beyond the load at `a`: `x²(3a − x)/(6EI)`.
#[inline]
pub fn cantilever<S: Real>(bending: S, place: S, load: S) -> S {
    place.powi(2) * (load * 3.0 - place) / (bending * 6.0)
}

/// Overhang beyond the right support of a span `l`, load inside the span at `a`, place `u` beyond the support:
/// `−a (l² − a²) u/(6EIl)`.
#[inline]
pub fn overhang_of_inner_load<S: Real>(bending: S, span: S, beyond: S, load: S) -> S {
    -(load * (span.powi(2) - load.powi(2)) * beyond / (bending * span * 6.0))
}

/// Overhang beyond the right support of a span `l`, place `u` and load `v` beyond the support, `u ≤ v`:
/// `u (2 l v + 3 u v − u²)/(6EI)`.
#[inline]
pub fn overhang<S: Real>(bending: S, span: S, beyond: S, load: S) -> S {
    beyond * (span * load * 2.0 + beyond * load * 3.0 - beyond.powi(2)) / (bending * 6.0)
}

/// Own weight, simply supported: `w x (L³ − 2 L x² + x³)/(24EI)`.
#[inline]
pub fn own_simply_supported<S: Real>(bending: S, weight: S, span: S, place: S) -> S {
    weight * place * (span.powi(3) - span * place.powi(2) * 2.0 + place.powi(3)) / (bending * 24.0)
}

/// Own weight, clamped at the left end: `w x²(6L² − 4 L x + x²)/(24EI)`.
#[inline]
pub fn own_cantilever<S: Real>(bending: S, weight: S, length: S, place: S) -> S {
    weight * place.powi(2) * (length.powi(2) * 6.0 - length * place * 4.0 + place.powi(2)) / (bending * 24.0)
}

/// Own weight, overhang `c` beyond a span `l`, place inside the span:
/// `w x (l⁴ − 2 l² x² + l x³ − 2 c² l² + 2 c² x²)/(24EIl)`.
#[inline]
pub fn own_inside<S: Real>(bending: S, weight: S, span: S, overhang: S, place: S) -> S {
    let square = overhang.powi(2) * 2.0;
    weight
        * place
        * (span.powi(4) - span.powi(2) * place.powi(2) * 2.0 + span * place.powi(3) - square * span.powi(2)
            + square * place.powi(2))
        / (bending * span * 24.0)
}

/// Own weight, overhang `c` beyond a span `l`, place `u` beyond the support:
/// `w u (4 c² l − l³ + 6 c² u − 4 c u² + u³)/(24EI)`.
#[inline]
pub fn own_overhang<S: Real>(bending: S, weight: S, span: S, overhang: S, beyond: S) -> S {
    weight
        * beyond
        * (overhang.powi(2) * span * 4.0 - span.powi(3) + overhang.powi(2) * beyond * 6.0
            - overhang * beyond.powi(2) * 4.0
            + beyond.powi(3))
        / (bending * 24.0)
}
