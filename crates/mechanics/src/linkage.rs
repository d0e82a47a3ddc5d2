//! Planar linkages with one crank: how their links and points move with it, and the torque that turns it.
//!
//! Every place depends on the crank angle `θ` alone. Its derivatives `q′ = dq/dθ` and `q″ = d²q/dθ²`, the kinematic
//! coefficients of first and second order (Uicker, Pennock and Shigley, *Theory of Machines and Mechanisms*), give
//! velocity `q′ ω` and acceleration `q′ α + q″ ω²`. What is asked of a link or point is a formula, generic over
//! [`Real`]; where the linkage does not close or stands at a dead point its numbers are not finite.
//!
//! ```
//! use dalembert_mechanics::linkage::{LinkMass, LinkRotation, PointMotion};
//!
//! // A bar of 3 kg and 1 m turned about its end, at 60° to the horizontal: I = m L²/3 = 1 kg·m², Σ m y′ = m (L/2) cos 60°.
//! let bar = LinkMass { mass: 3.0, centre: [0.5, 0.0], inertia: 0.25 };
//! let crank = LinkRotation::crank(60_f64.to_radians());
//! let reduced = bar.reduced(PointMotion::fixed([0.0, 0.0]), crank);
//! assert!((reduced.inertia - 1.0).abs() < 1e-14 && (reduced.rise - 0.75).abs() < 1e-14);
//! // The torque for 5 rad/s and 2 rad/s²: I α + m g (L/2) cos 60°.
//! assert!((reduced.torque(5.0, 2.0, 9.81) - (2.0 + 0.75 * 9.81)).abs() < 1e-12);
//! ```

use crate::Real;

/// Rotation of a link as a function of the crank angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkRotation<S> {
    /// Cosine and sine of its angle `φ`.
    pub direction: [S; 2],
    /// `φ′`.
    pub first: S,
    /// `φ″`, 1/rad.
    pub second: S,
}

/// Motion of a point as a function of the crank angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMotion<S> {
    /// Position, m.
    pub at: [S; 2],
    /// First derivative with respect to the crank angle, m/rad.
    pub first: [S; 2],
    /// Second derivative with respect to the crank angle, m/rad².
    pub second: [S; 2],
}

/// The mass of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkMass<S> {
    /// Mass, kg.
    pub mass: S,
    /// Centre of mass from the first pin of the link, along the line to its second pin and across it, m.
    pub centre: [S; 2],
    /// Moment of inertia about the centre, kg·m².
    pub inertia: S,
}

/// Masses reduced to the crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReducedMasses<S> {
    /// `I = Σ m r′·r′ + J φ′²`, kg·m²: the kinetic energy is `I ω²/2`.
    pub inertia: S,
    /// `C = dI/dθ/2 = Σ m r′·r″ + J φ′ φ″`, kg·m².
    pub half_slope: S,
    /// `Σ m y′`, kg·m: the potential energy grows by g times this.
    pub rise: S,
}

impl<S: Real> LinkRotation<S> {
    /// The crank itself, at its angle.
    #[inline(always)]
    pub fn crank(angle: S) -> Self {
        Self { direction: [angle.cos(), angle.sin()], first: S::from(1.0), second: S::from(0.0) }
    }

    /// A vector of this link, given along it and across it.
    #[inline(always)]
    pub fn vector(self, [along, across]: [S; 2]) -> [S; 2] {
        let [c, s] = self.direction;
        [along * c - across * s, along * s + across * c]
    }
}

impl<S: Real> PointMotion<S> {
    /// A point of the frame.
    #[inline(always)]
    pub fn fixed(at: [S; 2]) -> Self {
        Self { at, first: [S::from(0.0); 2], second: [S::from(0.0); 2] }
    }

    /// Another point of a link that this one belongs to, by the vector to it along the link and across it:
    /// `r′ = φ′ k × d`, `r″ = φ″ k × d − φ′² d`.
    #[inline(always)]
    #[must_use]
    pub fn to(self, link: LinkRotation<S>, vector: [S; 2]) -> Self {
        let [x, y] = link.vector(vector);
        let square = link.first * link.first;
        Self {
            at: [self.at[0] + x, self.at[1] + y],
            first: [self.first[0] - link.first * y, self.first[1] + link.first * x],
            second: [
                self.second[0] - link.second * y - square * x,
                self.second[1] + link.second * x - square * y,
            ],
        }
    }
}

impl<S: Real> LinkMass<S> {
    /// The mass of a link that turns about its first pin, reduced to the crank.
    #[inline(always)]
    pub fn reduced(self, first_pin: PointMotion<S>, link: LinkRotation<S>) -> ReducedMasses<S> {
        let PointMotion { first: v, second: a, .. } = first_pin.to(link, self.centre);
        ReducedMasses {
            inertia: self.mass * (v[0] * v[0] + v[1] * v[1]) + self.inertia * link.first * link.first,
            half_slope: self.mass * (v[0] * a[0] + v[1] * a[1]) + self.inertia * link.first * link.second,
            rise: self.mass * v[1],
        }
    }
}

impl<S: Real> ReducedMasses<S> {
    /// A mass without turning, at a point.
    #[inline(always)]
    pub fn mass(mass: S, PointMotion { first: v, second: a, .. }: PointMotion<S>) -> Self {
        Self {
            inertia: mass * (v[0] * v[0] + v[1] * v[1]),
            half_slope: mass * (v[0] * a[0] + v[1] * a[1]),
            rise: mass * v[1],
        }
    }

    /// Both together.
    #[inline(always)]
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            inertia: self.inertia + other.inertia,
            half_slope: self.half_slope + other.half_slope,
            rise: self.rise + other.rise,
        }
    }

    /// The torque on the crank that moves these masses, `M = I α + C ω² + g Σ m y′`, N·m, with gravity against y:
    /// virtual power over the speed of the crank (Eksergian, *J. Franklin Inst.* 209, 1930). A load that acts on a
    /// point or link besides asks for less the load times its first coefficient.
    #[inline(always)]
    pub fn torque(self, speed: S, acceleration: S, gravity: S) -> S {
        self.inertia * acceleration + self.half_slope * speed * speed + self.rise * gravity
    }
}
