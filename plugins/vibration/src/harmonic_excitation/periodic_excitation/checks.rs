//! The steady motion in a second method: what every impulse of the wave, period after period, leaves of itself.

use dalembert_core::Worksheet;
use dalembert_mechanics::vibration::periodic::{ExcitationPath, PeriodicResponse, WaveSegment};
use dalembert_numerics::quadrature::integral;
use nalgebra::Complex;

/// An oscillator and a period of what drives it.
pub(super) struct Circle<'p> {
    pub(super) zeta: f64,
    /// Radians of the free motion, without damping, in a period.
    pub(super) angle: f64,
    pub(super) drive: ExcitationPath,
    pub(super) pieces: &'p [WaveSegment],
}

/// The most radians that are added up.
const MOST: f64 = 300.0;

impl Circle<'_> {
    /// Displacement at a share of the period, over that of the wave at rest, by the convolution of the wave with the
    /// response to an impulse in every period; and what rounding makes of it. `None` near a double root, and where too
    /// much would have to be added up.
    fn displacement(&self, share: f64) -> Option<[f64; 2]> {
        let spread = Complex::new(self.zeta * self.zeta - 1.0, 0.0).sqrt();
        let roots = [spread - self.zeta, -spread - self.zeta];
        let radians = self.angle * (1.0 + 2.0 * self.zeta);
        if spread.norm() < 1e-3 || radians.is_nan() || radians > MOST {
            return None;
        }
        // A root without damping in it does not decay, but a period turns it.
        let returned = roots.map(|root| Complex::new(1.0, 0.0) - (root * self.angle).exp());
        let weights = [0, 1].map(|n| {
            let sign = if n == 0 { 1.0 } else { -1.0 };
            let through = match self.drive {
                ExcitationPath::Force => Complex::new(1.0, 0.0),
                ExcitationPath::Base => roots[n] * (2.0 * self.zeta) + 1.0,
            };
            through * sign / (spread * 2.0 * returned[n])
        });
        let impulse =
            |since: f64| (weights[0] * (roots[0] * since).exp() + weights[1] * (roots[1] * since).exp()).re;
        let mut sum = 0.0;
        for piece in self.pieces {
            let drive = |at: f64| {
                let since = at - piece.from;
                piece.value + piece.slope * since + piece.sine * (piece.rate * since).sin()
            };
            let middle = share.clamp(piece.from, piece.to);
            for ([from, to], turns) in [([piece.from, middle], 0.0), ([middle, piece.to], 1.0)] {
                if to <= from {
                    continue;
                }
                let of = |at: f64| impulse(self.angle * (share - at + turns)) * drive(at);
                let parts = (2.0 * (to - from) * (radians + piece.rate)).ceil().max(1.0);
                sum += self.angle * integral(of, [from, to], parts as u32);
            }
        }
        let size = self.pieces.iter().fold(0.0, |size: f64, piece| {
            size.max(piece.value.abs() + (piece.slope * (piece.to - piece.from)).abs() + piece.sine.abs())
        });
        let weight = weights[0].norm() + weights[1].norm();
        // The turn of a period is known to its last place.
        let returned = returned[0].norm().min(returned[1].norm());
        let turned = 1.0 + self.angle / returned;
        Some([sum, f64::EPSILON * weight * self.angle * size * turned])
    }
}

/// Holds the displacement at a share of the period.
pub(super) fn displacement<W: Worksheet>(circle: &Circle<'_>, share: f64, shown: f64, sheet: W) {
    if let Some([other, rounding]) = circle.displacement(share) {
        sheet.check_residual(
            "displacement at that time, by convolution of the wave with the unit impulse response",
            W::Num::from(shown - other),
            shown.abs().max(other.abs()).max(1e-3),
            rounding,
        );
    }
}

/// Holds the largest and the least displacement: where the velocity changes its sign.
pub(super) fn extremes<W: Worksheet>(
    circle: &Circle<'_>,
    steady: &PeriodicResponse,
    shown: [f64; 2],
    sheet: W,
) {
    let radians = circle.angle * (1.0 + 2.0 * circle.zeta);
    if radians.is_nan() || radians > MOST {
        return;
    }
    let count = (16.0 * radians).ceil().max(400.0) as usize;
    let mut shares: Vec<f64> = (0..count).map(|n| n as f64 / count as f64).collect();
    shares.extend(circle.pieces.iter().map(|piece| piece.from));
    shares.sort_by(f64::total_cmp);
    shares.dedup();
    let last = shares.len() - 1;
    let whats = [
        "maximum displacement: by convolution, at the instant at which the velocity changes sign",
        "minimum displacement: by convolution, at the instant at which the velocity changes sign",
    ];
    for ((sign, shown), what) in [1.0, -1.0].into_iter().zip(shown).zip(whats) {
        let of = |share: f64| sign * steady.displacement(share);
        let top = |n: usize| {
            let mut low = if n == 0 { shares[last] - 1.0 } else { shares[n - 1] };
            let mut high = if n == last { shares[0] + 1.0 } else { shares[n + 1] };
            for _ in 0..55 {
                let middle = f64::midpoint(low, high);
                if sign * steady.velocity(middle) > 0.0 { low = middle } else { high = middle }
            }
            if of(low) > of(shares[n]) { low.rem_euclid(1.0) } else { shares[n] }
        };
        let heights: Vec<f64> = shares.iter().map(|&share| of(share)).collect();
        let tops = (0..=last).filter(|&n| {
            let before = heights[if n == 0 { last } else { n - 1 }];
            let after = heights[if n == last { 0 } else { n + 1 }];
            heights[n] >= before && heights[n] >= after
        });
        let Some(place) = tops.map(top).max_by(|a, b| of(*a).total_cmp(&of(*b))) else { continue };
        if let Some([other, rounding]) = circle.displacement(place) {
            let scale = shown.abs().max(other.abs()).max(1e-3);
            sheet.check_residual(what, W::Num::from(shown - other), scale, rounding);
        }
    }
}
