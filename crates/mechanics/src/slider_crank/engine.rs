//! An engine with one cylinder: its motion in three models, its forces, and the reactions in its pins.
//!
//! Axes: `x` along the stroke away from the crankshaft, `y` to its left, the crank turning from `x` to `y`. The rod is
//! replaced by masses at its two pins and a moment of inertia that they have less than the rod has, which is exact
//! (see [`equivalent`](super::equivalent)); [`EngineCylinder::reactions`] goes the other way, by Newton's and Euler's
//! equations of the rod itself.

use super::{
    CrankMotion, SliderCrank, SliderCrankError,
    motion::Branch,
    piston::{self, harmonics, two_term},
};
use dalembert_numerics::differentiation::derivative;

use crate::{Real, balance::reciprocating::harmonic_by_series};

/// Formulas of the piston motion: exact or approximate.
#[derive(Debug, Clone, PartialEq)]
pub enum PistonFormula {
    /// The closure of the slider-crank.
    Exact,
    /// Two terms.
    TwoTerm,
    /// The first order and even ones after it, with the amplitudes of the orders 2, 4, ….
    Harmonics(Vec<f64>),
}

/// A cylinder with its crank, rod and piston.
#[derive(Debug, Clone, PartialEq)]
pub struct EngineCylinder {
    /// Radius of the crank, m.
    pub crank: f64,
    /// Length of the rod, m.
    pub rod: f64,
    /// Height of the line of stroke above the crankshaft, m. Other than zero with the exact motion alone.
    pub offset: f64,
    /// Motion of the piston.
    pub model: PistonFormula,
    /// Mass that goes back and forth with the piston, kg.
    pub reciprocating: f64,
    /// Mass of the rod, kg.
    pub rod_mass: f64,
    /// Distance of the rod's centre of mass from the crank pin, m.
    pub rod_centre: f64,
    /// Moment of inertia of the rod about its centre of mass, kg·m².
    pub rod_inertia: f64,
    /// Acceleration of gravity along the stroke towards the crank, and across it against `y`, m/s².
    pub gravity: [f64; 2],
    /// Friction of the piston, against its motion, N.
    pub friction: f64,
}

/// Motion of piston and rod, positive towards the crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PistonMotion {
    /// Obliquity of the rod, rad.
    pub obliquity: f64,
    /// Displacement from the dead centre away from the crank, m.
    pub displacement: f64,
    /// Velocity of the piston, m/s.
    pub velocity: f64,
    /// Acceleration of the piston, m/s².
    pub acceleration: f64,
    /// Angular velocity of the rod, rad/s.
    pub rod_speed: f64,
    /// Angular acceleration of the rod, rad/s².
    pub rod_acceleration: f64,
    /// Way of the piston for the angle of the crank, m.
    pub arm: f64,
    /// Turn of the rod for that of the crank.
    pub turn: f64,
}

/// Forces in an engine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forces {
    /// Net effort along the stroke at the gudgeon pin, towards the crank, with the rod's share, N.
    pub effort: f64,
    /// Load of the piston alone on the gudgeon pin, N.
    pub gudgeon: f64,
    /// Force of the guide on the piston along `y`, N.
    pub guide: f64,
    /// Force at the crank pin along its motion, N.
    pub tangential: f64,
    /// Force at the crank pin towards the crankshaft, N.
    pub radial: f64,
    /// Turning moment on the crankshaft, N·m.
    pub moment: f64,
    /// Force of the rod on the crank pin, N: what the main bearings carry, with a crank that is balanced.
    pub bearing: [f64; 2],
}

/// Forces of the joints, in the axes of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reactions {
    /// Force of the rod on the crank pin, N.
    pub crank_pin: [f64; 2],
    /// Force of the piston on the rod, N.
    pub gudgeon_pin: [f64; 2],
    /// Force of the guide on the piston along `y`, N.
    pub guide: f64,
    /// Turning moment on the crankshaft, N·m.
    pub moment: f64,
}

impl PistonFormula {
    /// Harmonics up to an even order.
    pub fn up_to(highest: u8, ratio: f64) -> Self {
        let even = (1..=highest / 2).map(|half| harmonic_by_series(1.0 / ratio, 2 * half));
        PistonFormula::Harmonics(even.collect())
    }
}

impl EngineCylinder {
    /// The stroke of the piston, m.
    pub fn stroke(&self) -> f64 {
        let far = piston::farthest(self.crank, self.rod, self.offset);
        if self.offset == 0.0 {
            2.0 * self.crank
        } else {
            far - piston::nearest(self.crank, self.rod, self.offset)
        }
    }

    /// Crank angles of the two dead centres, the outer one (away from the crank) first, rad.
    pub fn dead_centres(&self) -> [f64; 2] {
        let outer = (self.offset / (self.rod + self.crank)).asin();
        let inner = std::f64::consts::PI + (self.offset / (self.rod - self.crank)).asin();
        [outer, inner]
    }

    /// Motion of piston and rod.
    pub fn motion(&self, crank: CrankMotion) -> PistonMotion {
        let &Self { crank: r, rod: l, offset: e, .. } = self;
        let (angle, speed, n) = (crank.angle, crank.speed, l / r);
        let alpha = Some(crank.acceleration);
        let obliquity = piston::obliquity_with_offset(r, l, e, angle);
        let (arm, turn) = (piston::arm(r, angle, obliquity), piston::turn(r, l, angle, obliquity));
        let rod_speed = turn * speed;
        let rod_acceleration =
            piston::rod_acceleration([r, l], [angle, obliquity], [speed, rod_speed], alpha);
        let exact = || PistonMotion {
            obliquity,
            displacement: if e == 0.0 {
                piston::displacement(r, n, angle, obliquity)
            } else {
                piston::farthest(r, l, e) - piston::position(r, l, angle, obliquity)
            },
            velocity: arm * speed,
            acceleration: piston::acceleration(
                [r, l],
                [angle, obliquity],
                [speed, rod_speed],
                rod_acceleration,
                alpha,
            ),
            rod_speed,
            rod_acceleration,
            arm,
            turn,
        };
        match &self.model {
            PistonFormula::Exact => exact(),
            PistonFormula::TwoTerm => PistonMotion {
                obliquity,
                displacement: two_term::displacement(r, n, angle),
                velocity: two_term::velocity(r, n, angle, speed),
                acceleration: two_term::acceleration(r, n, angle, speed, alpha),
                rod_speed: two_term::rod_speed(n, angle, speed),
                rod_acceleration: two_term::rod_acceleration(n, angle, speed, alpha),
                arm,
                turn,
            },
            PistonFormula::Harmonics(amplitudes) => PistonMotion {
                displacement: harmonics::displacement(r, amplitudes, angle),
                velocity: harmonics::velocity(r, amplitudes, angle, speed),
                acceleration: harmonics::acceleration(r, amplitudes, angle, speed, alpha),
                ..exact()
            },
        }
    }

    /// Forces with a gas force towards the crank, N, by virtual work and the equilibrium of the rod with masses in its
    /// pins.
    pub fn forces(&self, crank: CrankMotion, motion: &PistonMotion, gas: f64) -> Forces {
        let &Self { crank: r, rod: l, gravity: [along, across], .. } = self;
        let (at_gudgeon, at_pin) = self.shares();
        let missing = self.missing_inertia();
        let friction = if motion.arm < 0.0 { -self.friction } else { self.friction };
        let gudgeon = gas + self.reciprocating * (along - motion.acceleration) - friction;
        let effort = gudgeon + at_gudgeon * (along - motion.acceleration);
        let (sine, cosine) = crank.angle.sin_cos();
        let lateral = lateral(effort, motion.obliquity, missing * motion.rod_acceleration, l);
        let tangential = effort * sine + lateral * cosine + at_pin * (along * sine - across * cosine)
            - at_pin * r * crank.acceleration;
        let radial = effort * cosine - lateral * sine + at_pin * (along * cosine + across * sine)
            - at_pin * r * crank.speed.powi(2);
        Forces {
            effort,
            gudgeon,
            guide: lateral + (self.reciprocating + at_gudgeon) * across,
            tangential,
            radial,
            moment: tangential * r,
            bearing: [-radial * cosine - tangential * sine, -radial * sine + tangential * cosine],
        }
    }

    /// The turning moment as the virtual work of all loads for one radian of the crank, `T = F_P h − ΔI φ̈ φ′ + …`, N·m.
    pub fn moment_by_virtual_work(&self, crank: CrankMotion, motion: &PistonMotion, gas: f64) -> f64 {
        let [along, across] = self.gravity;
        let (sine, cosine) = crank.angle.sin_cos();
        let at_pin = self.shares().1 * self.crank;
        self.forces(crank, motion, gas).effort * motion.arm
            - self.missing_inertia() * motion.rod_acceleration * motion.turn
            + at_pin * (along * sine - across * cosine - self.crank * crank.acceleration)
    }

    /// Reactions of all joints from Newton's and Euler's equations of piston and rod, with the exact motion.
    ///
    /// # Errors
    /// [`SliderCrankError`].
    pub fn reactions(&self, crank: CrankMotion, gas: f64) -> Result<Reactions, SliderCrankError> {
        let &Self { crank: r, rod: l, rod_mass: m, rod_centre: c, gravity: [along, across], .. } = self;
        let mechanism = SliderCrank { crank: r, rod: l, offset: self.offset, branch: Branch::Ahead };
        let motion = mechanism.motion(crank)?;
        let (sine, cosine) = crank.angle.sin_cos();
        let (rod_sine, rod_cosine) = motion.rod_angle.sin_cos();
        let (swing, spin) = (motion.rod_acceleration, motion.rod_speed.powi(2));
        let [ax, ay] = [
            -r * crank.speed.powi(2) * cosine
                - r * crank.acceleration * sine
                - c * spin * rod_cosine
                - c * swing * rod_sine,
            -r * crank.speed.powi(2) * sine + r * crank.acceleration * cosine - c * spin * rod_sine
                + c * swing * rod_cosine,
        ];
        let against = if self.falls(crank.angle) { self.friction } else { -self.friction };
        // The piston along x, then moments of the rod about the crank pin, then the piston along y.
        let gx = against - gas - self.reciprocating * (along + motion.slider_acceleration);
        let about_pin =
            self.rod_inertia * swing + m * c * (rod_cosine * (ay + across) - rod_sine * (ax + along));
        let gy = (about_pin + l * rod_sine * gx) / (l * rod_cosine);
        let guide = gy + self.reciprocating * across;
        let crank_pin = [gx - m * (ax + along), gy - m * (ay + across)];
        let moment = r * (cosine * crank_pin[1] - sine * crank_pin[0]);
        Ok(Reactions { crank_pin, gudgeon_pin: [gx, gy], guide, moment })
    }

    /// Kinetic energy of piston and rod at a crank angle and speed, with the exact motion, J.
    pub fn kinetic_energy(&self, angle: f64, speed: f64) -> f64 {
        let &Self { crank: r, rod: l, rod_mass: m, rod_centre: c, .. } = self;
        let obliquity = piston::obliquity_with_offset(r, l, self.offset, angle);
        let (arm, turn) = (piston::arm(r, angle, obliquity), piston::turn(r, l, angle, obliquity));
        // Towards the crank and along y, for one radian of the crank.
        let along = r * angle.sin() + c * turn * obliquity.sin();
        let across = r * angle.cos() - c * turn * obliquity.cos();
        let reduced = self.reciprocating * arm.powi(2)
            + m * (along.powi(2) + across.powi(2))
            + self.rod_inertia * turn.powi(2);
        0.5 * reduced * speed.powi(2)
    }

    /// Moment of the inertia of piston and rod at a steady speed, `−dE/dθ`, N·m, by differences of the kinetic energy
    /// of eighth order.
    pub fn inertia_moment_by_energy(&self, angle: f64, speed: f64) -> f64 {
        // The energy is smooth as far as the crank angle at which the rod would stand across the stroke, an imaginary
        // one away.
        let reach = ((self.rod - self.offset.abs()) / self.crank).acosh().min(1.0);
        let step = 0.01 * reach;
        -derivative(|angle| self.kinetic_energy(angle, speed), angle, step)
    }

    /// Masses of the rod at gudgeon pin and crank pin, kg.
    pub fn shares(&self) -> (f64, f64) {
        let part = self.rod_centre / self.rod;
        (self.rod_mass * part, self.rod_mass * (1.0 - part))
    }

    /// Moment of inertia that the masses in the pins have less than the rod, kg·m².
    pub fn missing_inertia(&self) -> f64 {
        super::equivalent::missing_inertia_from(
            self.rod_inertia,
            self.rod_mass,
            self.rod_centre,
            self.rod - self.rod_centre,
        )
    }

    /// Returns true if the piston moves towards the crank as the crank turns forward.
    fn falls(&self, angle: f64) -> bool {
        let obliquity = piston::obliquity_with_offset(self.crank, self.rod, self.offset, angle);
        piston::arm(self.crank, angle, obliquity) >= 0.0
    }
}

/// Force across the stroke at the gudgeon pin on a rod with masses in its pins, `V = F tan φ − ΔI φ̈/(l cos φ)`, N.
#[inline]
pub fn lateral<S: Real>(effort: S, obliquity: S, missing_couple: S, rod: S) -> S {
    effort * obliquity.tan() - missing_couple / (rod * obliquity.cos())
}
