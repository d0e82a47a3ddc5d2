//! Pressures in a cylinder and what they do. Pressures in Pa, volumes as fractions of the stroke volume.

use std::f64::consts::TAU;

use crate::Real;

/// Pressure after the expansion `p vᵏ = const` from a pressure and a volume, `p = p₁ (v₁/v)ᵏ`, absolute.
#[inline]
pub fn expanded<S: Real>(pressure: S, from: S, to: S, exponent: S) -> S {
    pressure * (from / to).pow(exponent)
}

/// Pressure after the expansion `p v = const`, `p = p₁ v₁/v`, absolute.
#[inline]
pub fn expanded_hyperbolically<S: Real>(pressure: S, from: S, to: S) -> S {
    pressure * from / to
}

/// Force on a piston towards the crank, `F = p₁ A₁ − p₂ A₂`, N, from the gauge pressures and areas of its two sides.
#[inline]
pub fn force<S: Real>(pressure: S, area: S, crank_side: S, crank_side_area: S) -> S {
    pressure * area - crank_side * crank_side_area
}

/// Mean effective pressure of admission up to the cut-off `c`, expansion `p v = const` with the clearance `κ`, and
/// exhaust at `p_b`: `p_m = p₁ [c + (c + κ) ln((1 + κ)/(c + κ))] − p_b`.
///
/// Without clearance, `None`, the formula is written without it.
#[inline]
pub fn mean_pressure_hyperbolic<S: Real>(admission: S, cut_off: S, clearance: Option<S>, exhaust: S) -> S {
    let (volume, whole) = volumes(cut_off, clearance);
    admission * (cut_off + volume * (whole / volume).ln()) - exhaust
}

/// The same with the expansion `p vᵏ = const`, `k ≠ 1`:
/// `p_m = p₁ [c + (c + κ)/(k − 1)·(1 − ((c + κ)/(1 + κ))ᵏ⁻¹)] − p_b`.
#[inline]
pub fn mean_pressure<S: Real>(admission: S, cut_off: S, clearance: Option<S>, exponent: S, exhaust: S) -> S {
    let (volume, whole) = volumes(cut_off, clearance);
    let less = exponent - 1.0;
    let left = (volume / whole).pow(less);
    admission * (cut_off + volume / less * (S::from(1.0) - left)) - exhaust
}

/// Volumes at the cut-off and at the end of the stroke.
fn volumes<S: Real>(cut_off: S, clearance: Option<S>) -> (S, S) {
    clearance.map_or((cut_off, 1.0.into()), |clearance| (cut_off + clearance, clearance + 1.0))
}

/// Pressure on the side of the piston away from the crank, over a cycle.
#[derive(Debug, Clone, PartialEq)]
pub enum Diagram {
    /// Admission at full pressure, expansion to the end of the stroke, exhaust on the way back.
    Expansion {
        /// Absolute pressure of the admission.
        admission: f64,
        /// Absolute pressure of the exhaust.
        exhaust: f64,
        /// Fraction of the stroke at which the admission ends.
        cut_off: f64,
        /// Clearance volume over the stroke volume.
        clearance: f64,
        /// Exponent of the expansion.
        exponent: f64,
    },
    /// Pressures over the fraction of the stroke, on the way to the crank and on the way back: rows of fraction,
    /// pressure out, pressure back, by ascending fraction, straight between rows.
    Stroke(Vec<[f64; 3]>),
    /// Pressures over the crank angle, rows of angle and pressure by ascending angle, straight between rows, repeated
    /// after one turn or after two.
    Angle {
        /// Rows of angle, rad, and pressure.
        rows: Vec<[f64; 2]>,
        /// Turns of a cycle.
        turns: u8,
    },
}

impl Diagram {
    /// Turns of the crank in a cycle.
    pub fn turns(&self) -> u8 {
        if let Diagram::Angle { turns, .. } = self { *turns } else { 1 }
    }

    /// The pressure at a crank angle, a fraction of the stroke from the dead centre away from the crank, and on the
    /// way to the crank (`out`) or back.
    pub fn pressure(&self, angle: f64, fraction: f64, out: bool) -> f64 {
        match self {
            &Diagram::Expansion { admission, exhaust, cut_off, clearance, exponent } => {
                let fraction = fraction.clamp(0.0, 1.0);
                if !out {
                    exhaust
                } else if fraction <= cut_off {
                    admission
                } else {
                    admission * ((cut_off + clearance) / (fraction + clearance)).powf(exponent)
                }
            }
            Diagram::Stroke(rows) => {
                let column = if out { 1 } else { 2 };
                straight(rows.iter().map(|row| (row[0], row[column])), fraction)
            }
            Diagram::Angle { rows, turns } => {
                let period = TAU * f64::from(*turns);
                let (Some(first), Some(last)) = (rows.first(), rows.last()) else { return 0.0 };
                let wrapped = first[0] + (angle - first[0]).rem_euclid(period);
                let again = (first[0] + period, first[1]);
                let closing = (last[0] < again.0).then_some(again);
                straight(rows.iter().map(|row| (row[0], row[1])).chain(closing), wrapped)
            }
        }
    }

    /// The pressure on the side towards the crank of a double-acting piston: the same diagram half a turn later,
    /// with the strokes exchanged.
    pub fn opposite(&self, angle: f64, fraction: f64, out: bool) -> f64 {
        self.pressure(angle + TAU / 2.0, 1.0 - fraction, !out)
    }

    /// Crank angles, or fractions of the stroke, at which the pressure has a corner.
    pub fn corners(&self) -> Corners {
        match self {
            Diagram::Expansion { cut_off, .. } => Corners::Fractions(vec![*cut_off]),
            Diagram::Stroke(rows) => Corners::Fractions(rows.iter().map(|row| row[0]).collect()),
            Diagram::Angle { rows, .. } => Corners::Angles(rows.iter().map(|row| row[0]).collect()),
        }
    }
}

/// Corners of an indicator diagram.
#[derive(Debug, Clone, PartialEq)]
pub enum Corners {
    /// At these fractions of the stroke.
    Fractions(Vec<f64>),
    /// At these crank angles, rad.
    Angles(Vec<f64>),
}

/// The value at `x` of straight lines through points by ascending abscissa; beyond the ends, that of the end.
fn straight(points: impl Iterator<Item = (f64, f64)>, x: f64) -> f64 {
    let mut before: Option<(f64, f64)> = None;
    for (x1, y1) in points {
        if x <= x1 {
            return match before {
                Some((x0, y0)) if x1 > x0 => y0 + (y1 - y0) * ((x - x0) / (x1 - x0)),
                _ => y1,
            };
        }
        before = Some((x1, y1));
    }
    before.map_or(0.0, |(_, y)| y)
}
