//! The four-bar linkage: crank of length `a` turning about the origin, coupler `b`, and rocker `c` about a fixed pin
//! at `(d, 0)`: `a e₂ + b e₃ = d i + c e₄` with unit vectors `e` along the links.
//!
//! ```
//! use dalembert_mechanics::four_bar::{Branch, FourBar};
//!
//! // Crank and rocker of 0.1 m, frame and coupler of 0.3 m. As a parallelogram the coupler only translates.
//! let linkage = FourBar { frame: 0.3, crank: 0.1, coupler: 0.3, rocker: 0.1 };
//! let parallel = linkage.links(1.0_f64, Branch::Open);
//! assert!((parallel.rocker.first - 1.0).abs() < 1e-12 && parallel.coupler.first.abs() < 1e-12);
//! // Crossed, the rocker turns the other way like elliptical gears: φ₄′ = −(d² − a²)/(a² + d² − 2 a d cos φ₂).
//! let crossed = linkage.links(1.0_f64, Branch::Crossed);
//! let ratio = -(0.09 - 0.01) / (0.01 + 0.09 - 0.06 * 1_f64.cos());
//! assert!((crossed.rocker.first - ratio).abs() < 1e-12);
//! ```

use crate::{
    Real,
    linkage::{LinkRotation, PointMotion},
};

/// The lengths of a four-bar linkage, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourBar<S> {
    /// Distance of the fixed pins, `d`.
    pub frame: S,
    /// `a`
    pub crank: S,
    /// `b`
    pub coupler: S,
    /// `c`
    pub rocker: S,
}

/// The two ways to assemble a four-bar linkage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// The pin of coupler and rocker is to the left of the line from the crank pin to the fixed pin.
    Open,
    /// It is to the right.
    Crossed,
}

/// Rotation of the links of a four-bar linkage as functions of the crank angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Links<S> {
    /// The crank.
    pub crank: LinkRotation<S>,
    /// The coupler, from the crank pin.
    pub coupler: LinkRotation<S>,
    /// The rocker, from its fixed pin.
    pub rocker: LinkRotation<S>,
    /// The crank pin.
    pub crank_pin: PointMotion<S>,
}

impl<S: Real> FourBar<S> {
    /// The links at a crank angle. Circles about the crank pin and the fixed pin meet in the pin between coupler and
    /// rocker; the derivatives of the closed loop along `e₄` and `e₃` give
    ///
    /// `φ₃′ = a sin(φ₂ − φ₄)/(b sin(φ₄ − φ₃))`, `φ₄′ = a sin(φ₂ − φ₃)/(c sin(φ₄ − φ₃))`,
    ///
    /// `φ₃″ = (a e₂·e₄ + b φ₃′² e₃·e₄ − c φ₄′²)/(b sin(φ₄ − φ₃))`,
    /// `φ₄″ = (a e₂·e₃ + b φ₃′² − c φ₄′² e₃·e₄)/(c sin(φ₄ − φ₃))`.
    ///
    /// Not a number where the circles do not meet; infinite at a dead point, `φ₃ = φ₄`.
    #[inline(always)]
    pub fn links(self, crank_angle: S, branch: Branch) -> Links<S> {
        let Self { frame: d, crank: a, coupler: b, rocker: c } = self;
        let crank = LinkRotation::crank(crank_angle);
        let crank_pin = PointMotion::fixed([S::from(0.0); 2]).to(crank, [a, S::from(0.0)]);
        let [x, y] = [d - crank_pin.at[0], -crank_pin.at[1]];
        let square = x * x + y * y;
        // The meeting point is `along` times the line between the centres and `across` times its normal away.
        let along = ((b * b - c * c) / square + 1.0) * 0.5;
        let across = (b * b / square - along * along).sqrt();
        let across = match branch {
            Branch::Open => across,
            Branch::Crossed => -across,
        };
        let to_rocker = along - 1.0;
        let e2 = crank.direction;
        let e3 = [(along * x - across * y) / b, (along * y + across * x) / b];
        let e4 = [(to_rocker * x - across * y) / c, (to_rocker * y + across * x) / c];
        let sine = cross(e3, e4);
        let (over_coupler, over_rocker) = (S::from(1.0) / (b * sine), S::from(1.0) / (c * sine));
        let coupler_first = a * cross(e4, e2) * over_coupler;
        let rocker_first = a * cross(e3, e2) * over_rocker;
        let (of_coupler, of_rocker) = (b * coupler_first * coupler_first, c * rocker_first * rocker_first);
        let cosine = dot(e3, e4);
        Links {
            crank,
            coupler: LinkRotation {
                direction: e3,
                first: coupler_first,
                second: (a * dot(e2, e4) + of_coupler * cosine - of_rocker) * over_coupler,
            },
            rocker: LinkRotation {
                direction: e4,
                first: rocker_first,
                second: (a * dot(e2, e3) + of_coupler - of_rocker * cosine) * over_rocker,
            },
            crank_pin,
        }
    }

    /// The fixed pin of the rocker.
    #[inline(always)]
    pub fn fixed_pin(self) -> PointMotion<S> {
        PointMotion::fixed([self.frame, S::from(0.0)])
    }
}

#[inline(always)]
fn dot<S: Real>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[0] + a[1] * b[1]
}

/// The sine of the angle from a to b, for unit vectors.
#[inline(always)]
fn cross<S: Real>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[1] - a[1] * b[0]
}
