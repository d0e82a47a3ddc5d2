//! Rotation and motion of the links of a slider-crank as functions of the crank angle.

#![expect(
    clippy::inline_always,
    reason = "SIMD code is compiled for the widest registers where all is inlined"
)]

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        linkage::{LinkMass, ReducedMasses},
        slider_crank::{CrankMotion, SliderCrank},
    };

    #[test]
    fn torque_is_that_of_the_equation_of_motion() {
        // Lagrange's equation derived by computer algebra, with a force of 200 N on the slider along x.
        let torques = [
            4.949497872144,
            10.471218321386,
            4.391767367560,
            -2.352141859274,
            -8.501153170190,
            -8.858462404553,
        ];
        for (step, printed) in (0..).zip(torques) {
            let angle = 0.3 + f64::from(step) * std::f64::consts::FRAC_PI_3;
            let links = links(0.05, 0.2, 0.0, Branch::Ahead, angle);
            let masses = LinkMass { mass: 1.2, centre: [0.02, 0.0], inertia: 8e-4 }
                .reduced(PointMotion::fixed([0.0; 2]), links.crank)
                .and(
                    LinkMass { mass: 0.8, centre: [0.07, 0.0], inertia: 3.5e-3 }
                        .reduced(links.crank_pin, links.rod),
                )
                .and(ReducedMasses::mass(0.5, links.slider));
            let torque = masses.torque(30.0, 5.0, 9.81) - 200.0 * links.slider.first[0];
            assert!((torque - printed).abs() < 1e-11, "at {angle}: {torque} for {printed}");
        }
    }

    #[test]
    fn motion_is_that_of_the_formulas_with_angles() {
        for (branch, offset) in [(Branch::Ahead, 0.0), (Branch::Ahead, 0.02), (Branch::Behind, -0.01)] {
            let mechanism = SliderCrank { crank: 0.05, rod: 0.2, offset, branch };
            for step in 0..12 {
                let angle = 0.1 + 0.5 * f64::from(step);
                let links = links(0.05, 0.2, offset, branch, angle);
                let steady = CrankMotion { angle, speed: 1.0, acceleration: 0.0 };
                let motion = mechanism.motion(steady).expect("the mechanism can be assembled");
                let [c, s] = links.rod.direction;
                for (ours, theirs) in [
                    ((s.atan2(c) - motion.rod_angle).sin(), 0.0),
                    (links.rod.first, motion.rod_speed),
                    (links.rod.second, motion.rod_acceleration),
                    (links.slider.at[0], motion.slider_position),
                    (links.slider.first[0], motion.slider_velocity),
                    (links.slider.second[0], motion.slider_acceleration),
                    (links.slider.at[1], offset),
                    (links.slider.first[1], 0.0),
                    (links.slider.second[1], 0.0),
                ] {
                    assert!((ours - theirs).abs() < 1e-15, "{branch:?}, {angle}: {ours} for {theirs}");
                }
            }
        }
    }
}
