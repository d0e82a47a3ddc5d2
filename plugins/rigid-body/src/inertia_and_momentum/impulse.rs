//! A blow, a body that sticks, or a constraint that takes hold at once: the motion just after it.

mod after;
mod checks;
mod common_errors;
mod free;

use dalembert_core::{About, Analysis, Inputs, Refusal, Worksheet, register};
use nalgebra::Vector3;

use crate::{
    shared::body::{Body, BodyRotation, BodyVelocity},
    sources::{BEER, HIBBELER, MERIAM, RIUL},
};

/// A rigid body, its motion before, and what happens to it in a time so short that it does not move meanwhile.
#[derive(Clone, Debug, Inputs)]
pub struct Impulse {
    /// Body.
    pub body: Body,
    /// Its rotation before.
    #[input(default = "vector")]
    pub turning: BodyRotation,
    /// Its motion before.
    #[input(default = "mass-centre")]
    pub going: BodyVelocity,
    /// Impulses.
    pub blows: Vec<Blow>,
    /// Angular impulses.
    pub angular_impulses: Vec<AngularImpulse>,
    /// Projectiles.
    pub projectiles: Vec<Projectile>,
    /// Constraint after the impact.
    #[input(default = "nothing")]
    pub hold: BodyConstraint,
    /// Required angular speed after impact.
    /// About an axis, from rest: calculates the mass for which the body, with the same shape, reaches this speed.
    #[input("ω*", "rad/s", positive)]
    pub wanted_speed: Option<f64>,
}

/// A blow at a point of the body.
#[derive(Clone, Debug, Inputs)]
pub struct Blow {
    /// Name.
    pub name: String,
    /// Position of the struck point.
    #[input("r_J", "m")]
    pub point: Vector3<f64>,
    /// Magnitude.
    pub strength: Strength,
}

/// Magnitude of a blow.
#[derive(Clone, Debug, Inputs)]
pub enum Strength {
    /// Impulse
    Impulse {
        /// Impulse.
        #[input("J", "N*s")]
        impulse: Vector3<f64>,
    },
    /// Force of short duration
    Force {
        /// Mean force.
        #[input("F", "N")]
        force: Vector3<f64>,
        /// Duration.
        #[input("Δt", "s", positive)]
        duration: f64,
    },
}

/// The angular impulse of a couple: of a thruster pair, or of a wheel that is set spinning inside.
#[derive(Clone, Debug, Inputs)]
pub struct AngularImpulse {
    /// Name.
    pub name: String,
    /// Angular impulse.
    /// The moment of the couple times its duration.
    #[input("K", "N*m*s")]
    pub impulse: Vector3<f64>,
}

/// A small body that hits the body, and sticks in it or leaves.
#[derive(Clone, Debug, Inputs)]
pub struct Projectile {
    /// Name.
    pub name: String,
    /// Mass.
    #[input("m_p", "kg", positive)]
    pub mass: f64,
    /// Velocity.
    #[input("v_p", "m/s")]
    pub velocity: Vector3<f64>,
    /// Position of the point of impact.
    #[input("r_p", "m")]
    pub point: Vector3<f64>,
    /// Its mass after impact.
    #[input(default = "kept")]
    pub mass_after: MassAfter,
}

/// Mass after impact: with or without that of an embedded projectile, or of one that leaves again.
#[derive(Clone, Copy, Debug, PartialEq, Inputs)]
pub enum MassAfter {
    /// Part of the body
    Kept,
    /// Neglected
    /// Its momentum is included, its mass and inertia are not.
    Neglected,
    /// It leaves the body
    /// It passes through or rebounds: the body receives the change of its momentum.
    Leaves {
        /// Velocity of the projectile after impact.
        #[input("v_p′", "m/s")]
        velocity: Vector3<f64>,
    },
}

/// Constraint of the body after the impact.
#[derive(Clone, Debug, Inputs)]
pub enum BodyConstraint {
    /// Nothing
    Nothing,
    /// Point suddenly fixed
    /// A ball-and-socket, a hook: any rotation about it is free.
    Point {
        /// Position of the point.
        #[input("r_C", "m", default = "(0; 0; 0) m")]
        point: Vector3<f64>,
    },
    /// Axis suddenly fixed
    /// A hinge, a shaft or an edge that is suddenly fixed.
    Axis {
        /// Position of a point on it.
        #[input("r_C", "m", default = "(0; 0; 0) m")]
        point: Vector3<f64>,
        /// Any vector along it.
        #[input("e_C", "1")]
        axis: Vector3<f64>,
    },
    /// A point hits a smooth surface
    Surface {
        /// Position of the point.
        #[input("r_C", "m")]
        point: Vector3<f64>,
        /// Any vector normal to the surface, out of it.
        #[input("n_C", "1", default = "(0; 0; 1)")]
        normal: Vector3<f64>,
        /// Coefficient of restitution.
        #[input("ε", "1", min = 0, max = 1, default = "0")]
        restitution: f64,
    },
}

register!(Impulse);

impl Analysis for Impulse {
    const ABOUT: About = About {
        id: "rigid-body/impulse",
        title: "Impulse on a body in space",
        topic: "Inertia and momentum",
        summary: "Motion of a body immediately after an impulse, an angular impulse, the impact of a projectile or a sudden constraint; impulsive reactions and energy.",
        main: &["angular_velocity", "centre_velocity", "wanted_mass", "reaction"],
        keywords: "impulse angular impulse impact blow sudden constraint projectile meteorite impulsive reaction instantaneous axis screw torque-free precession \
                   impulso impulso angular impacto choque percussão projétil reação impulsiva eixo instantâneo precessão",
        sources: &[&BEER, &HIBBELER, &MERIAM, &RIUL],
        cases: include_str!("../../cases/impulse.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ImpulseGiven<W>, sheet: W) -> Result<(), Refusal> {
        self.follow(given, sheet)
    }
}
