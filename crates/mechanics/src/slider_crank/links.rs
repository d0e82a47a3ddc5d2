//! Rotation and motion of the links of a slider-crank as functions of the crank angle.

use super::Branch;
use crate::{
    Real,
    linkage::{LinkRotation, PointMotion},
};

/// Motion of crank, rod and slider as functions of the crank angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Links<S> {
    /// The crank.
    pub crank: LinkRotation<S>,
    /// The crank pin.
    pub crank_pin: PointMotion<S>,
    /// The rod, from the crank pin.
    pub rod: LinkRotation<S>,
    /// The slider.
    pub slider: PointMotion<S>,
}

/// The links at a crank angle, from the height of the slider, `r sin θ₂ + l sin θ₃ = e`, and its derivatives
/// `r cos θ₂ + l θ₃′ cos θ₃ = 0` and `l θ₃″ cos θ₃ = r sin θ₂ + l θ₃′² sin θ₃`: no angle but the crank's is needed.
///
/// Not a number where the rod is too short; infinite in its limit position, `cos θ₃ = 0`.
#[inline(always)]
pub fn links<S: Real>(crank: S, rod: S, offset: S, branch: Branch, crank_angle: S) -> Links<S> {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let turning = LinkRotation::crank(crank_angle);
    let crank_pin = PointMotion::fixed([zero; 2]).to(turning, [crank, zero]);
    let [along, height] = crank_pin.at;
    let sine = (offset - height) / rod;
    let cosine = (one - sine * sine).sqrt();
    let cosine = match branch {
        Branch::Ahead => cosine,
        Branch::Behind => -cosine,
    };
    let over = one / (rod * cosine);
    let first = -along * over;
    let second = (height + rod * first * first * sine) * over;
    let rod_turning = LinkRotation { direction: [cosine, sine], first, second };
    Links { crank: turning, crank_pin, rod: rod_turning, slider: crank_pin.to(rod_turning, [rod, zero]) }
}
